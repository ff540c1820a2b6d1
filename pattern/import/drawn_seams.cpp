#include "pattern/import/drawn_seams.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "geometry/polygon.h"

namespace toile {

namespace {

/// Chords of a curve that a text's place is compared with.
constexpr int curve_chords = 32;

Vec2 point_at(const FittedCurve& curve, double t) {
  const double u = 1 - t;
  return u * u * u * curve.points[0] + 3 * u * u * t * curve.points[1] +
         3 * u * t * t * curve.points[2] + t * t * t * curve.points[3];
}

}  // namespace

PieceSeam turned_seam(PieceSeam drawn, double angle) {
  drawn.at = Eigen::Rotation2Dd(angle) * drawn.at;
  drawn.angle += angle;
  return drawn;
}

SeamSide seam_side(const PieceSeam& drawn, const EdgedOutline& outline) {
  SeamSide side{drawn.text};
  const Vec2 along(std::cos(drawn.angle), std::sin(drawn.angle));
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    for (const FittedCurve& curve : outline.edges[i].curves) {
      const int chords = curve.straight ? 1 : curve_chords;
      Vec2 from = curve.points[0];
      for (int k = 1; k <= chords; ++k) {
        const Vec2 to = point_at(curve, static_cast<double>(k) / chords);
        const double distance = distance_to_segment(drawn.at, from, to);
        if (distance < nearest) {
          nearest = distance;
          side.edge = static_cast<int>(i);
          side.forward = (to - from).dot(along) > 0;
        }
        from = to;
      }
    }
  }
  return side;
}

std::vector<ImportedSeam> drawn_seams(const std::vector<ImportedPanel>& panels,
                                      const std::string& source, std::vector<Remark>& remarks) {
  struct Place {
    int panel = 0;
    const SeamSide* side = nullptr;
  };
  std::map<int, std::vector<Place>> sides;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (const SeamSide& side : panels[p].seams) {
      sides[side.text.number].push_back({static_cast<int>(p), &side});
    }
  }
  std::vector<ImportedSeam> seams;
  std::string odd;
  for (const auto& [number, both] : sides) {
    if (both.size() != 2 || both[0].side->text.second == both[1].side->text.second) {
      odd += (odd.empty() ? " " : ", ") + std::to_string(number);
      continue;
    }
    const Place& a = both[both[0].side->text.second ? 1 : 0];
    const Place& b = both[both[0].side->text.second ? 0 : 1];
    seams.push_back({a.panel, a.side->edge, b.panel, b.side->edge,
                     a.side->forward != b.side->forward, a.side->text});
  }
  if (!odd.empty()) {
    remarks.push_back(
        {true, source + ": seams that have not one side a and one side b are left out:" + odd});
  }
  return seams;
}

}  // namespace toile
