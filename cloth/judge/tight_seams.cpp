#include "cloth/judge/tight_seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cloth/judge/constants.h"
#include "cloth/judge/flat_line.h"
#include "cloth/loads/inner_face.h"
#include "cloth/scene/collider.h"
#include "cloth/scene/constants.h"

namespace toile {

namespace {

/// Finds and measures the tight seams of one garment.
class TightSeamSearch {
 public:
  TightSeamSearch(const PanelMesh& garment, const GarmentModel& model,
                  const std::vector<Vec3>& nodes, const std::vector<LimitMultiplier>& multipliers)
      : garment_(garment),
        model_(model),
        nodes_(nodes),
        multipliers_(multipliers),
        panel_of_point_(panel_of_points(garment)) {
    options_.limit = model.scene.strain_limit.value_or(-1);
    options_.shear_limit = model.scene.shear_limit.value_or(-1);
    std::vector<char> on_seam(garment.flat.size(), 0);
    for (const MeshedSeam& seam : garment.seams) {
      for (const int p : seam.a) on_seam[p] = 1;
      for (const int p : seam.b) on_seam[p] = 1;
    }
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Triangle& corners = garment.triangles[t];
        const int a = corners[(i + 1) % 3];
        const int b = corners[(i + 2) % 3];
        if (on_seam[a] && on_seam[b]) beside_[std::minmax(a, b)] = {static_cast<int>(t), i};
      }
    }
  }

  std::vector<TightSeam> run() {
    // The middle of the cloth is strained at least as much as its inner face, which costs more.
    double tension = 0;
    if (std::ranges::none_of(garment_.seams, [&](const MeshedSeam& seam) {
          return exceeds_bearable(seam, tension);
        })) {
      return {};
    }
    if (touches_body(model_.scene)) {
      inner_.emplace(model_, nodes_, model_.scene.collider->skin(),
                     model_.body_offset + contact_margin);
    }
    std::vector<TightSeam> tight;
    for (const MeshedSeam& seam : garment_.seams) {
      TightSeam found;
      found.name = seam.name;
      if (!exceeds_bearable(seam, found.tension)) continue;
      const int edges = static_cast<int>(seam.a.size()) - 1;
      const int stride = (edges + max_seam_lines - 1) / max_seam_lines;
      for (int i = 0; i < edges; i += stride) {
        const double missing = 0.5 * (missing_beside(seam.a[i], seam.a[i + 1]) +
                                      missing_beside(seam.b[i], seam.b[i + 1]));
        found.missing = std::max(found.missing, missing);
      }
      if (found.missing > flesh_give) tight.push_back(found);
    }
    return tight;
  }

 private:
  /// The triangle at an edge on a seam, and its corner that is opposite to the edge.
  struct Beside {
    int triangle;
    int corner;
  };

  const Beside* beside(int a, int b) const {
    const auto found = beside_.find(std::minmax(a, b));
    return found == beside_.end() ? nullptr : &found->second;
  }

  /// N/m with which the cloth on one side pulls across the edge. Negative: it pushes.
  double tension_beside(int a, int b) const {
    const Beside* at = beside(a, b);
    if (at == nullptr) return 0;
    const Triangle& corners = model_.node_triangles[at->triangle];
    const auto forces =
        stretch_forces(inner_ ? inner_->pulling(at->triangle) : model_.stretch[at->triangle],
                       options_, nodes_[corners[0]], nodes_[corners[1]], nodes_[corners[2]],
                       multipliers_.empty() ? LimitMultiplier{} : multipliers_[at->triangle]);
    const Vec3& p = nodes_[corners[(at->corner + 1) % 3]];
    const Vec3& q = nodes_[corners[(at->corner + 2) % 3]];
    const Vec3 along = (q - p).normalized();
    Vec3 out = p - nodes_[corners[at->corner]];
    out = (out - along.dot(out) * along).normalized();
    // The opposite corner bears half of the force across the edge.
    return 2 * forces[at->corner].dot(out) / (garment_.flat[a] - garment_.flat[b]).norm();
  }

  /// N/m of tension across the edge that a wearer bears at most.
  double bearable_beside(int a, int b) const {
    const Beside* at = beside(a, b);
    if (at == nullptr) return hand_pull;
    const Vec2 edge = garment_.flat[b] - garment_.flat[a];
    return std::min(hand_pull,
                    max_worn_strain * stiffness_along(at->triangle, {edge.y(), -edge.x()}));
  }

  /// Whether some hand's breadth of the seam pulls harder than a wearer bears. `largest` becomes
  /// the largest mean tension over a hand's breadth, N/m.
  bool exceeds_bearable(const MeshedSeam& seam, double& largest) const {
    std::vector<double> length = {0};
    std::vector<double> pull = {0};      // N, summed from the seam's start
    std::vector<double> bearable = {0};  // N, summed from the seam's start
    for (std::size_t i = 0; i + 1 < seam.a.size(); ++i) {
      const double edge = 0.5 * ((garment_.flat[seam.a[i]] - garment_.flat[seam.a[i + 1]]).norm() +
                                 (garment_.flat[seam.b[i]] - garment_.flat[seam.b[i + 1]]).norm());
      const double tension = 0.5 * (tension_beside(seam.a[i], seam.a[i + 1]) +
                                    tension_beside(seam.b[i], seam.b[i + 1]));
      length.push_back(length.back() + edge);
      pull.push_back(pull.back() + tension * edge);
      bearable.push_back(bearable.back() + 0.5 * edge *
                                               (bearable_beside(seam.a[i], seam.a[i + 1]) +
                                                bearable_beside(seam.b[i], seam.b[i + 1])));
    }
    bool exceeds = false;
    largest = 0;
    std::size_t end = 0;
    for (std::size_t from = 0; from + 1 < length.size(); ++from) {
      while (end + 1 < length.size() && length[end] - length[from] < hand_breadth) ++end;
      const double span = length[end] - length[from];
      if (from > 0 && span < hand_breadth) break;
      if (span <= 0) continue;
      largest = std::max(largest, (pull[end] - pull[from]) / span);
      exceeds = exceeds || pull[end] - pull[from] > bearable[end] - bearable[from];
    }
    return exceeds;
  }

  /// Metres by which the panel is stretched along a line that begins in the middle of the edge and
  /// runs square to it.
  double missing_beside(int a, int b) const {
    const Beside* at = beside(a, b);
    if (at == nullptr) return 0;
    const auto& flat = garment_.flat;
    const Vec2 from = 0.5 * (flat[a] + flat[b]);
    Vec2 direction(flat[a].y() - flat[b].y(), flat[b].x() - flat[a].x());
    direction.normalize();
    const Vec2& opposite = flat[garment_.triangles[at->triangle][at->corner]];
    if (direction.dot(opposite - from) < 0) direction = -direction;
    const MeshedPanel& panel = garment_.panels[panel_of_point_[a]];
    double missing = 0;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const double length = length_within(flat_corners(garment_, t), from, direction);
      if (length > 0) missing += length * strain_along(t, direction);
    }
    return missing;
  }

  /// A flat direction in the triangle's own weft and warp, as they are at rest.
  std::array<double, 2> weft_and_warp(int t, const Vec2& direction) const {
    const StretchTriangle& s = model_.stretch[t];
    double weft = 0;
    double warp = 0;
    for (int i = 0; i < 3; ++i) {
      const double along = garment_.flat[garment_.triangles[t][i]].dot(direction);
      weft += s.weft[i] * along;
      warp += s.warp[i] * along;
    }
    return {weft, warp};
  }

  /// Strain of a triangle along a flat direction. 0 where it is slack.
  double strain_along(int t, const Vec2& direction) const {
    const StretchTriangle worn = inner_ ? inner_->strained(t) : model_.stretch[t];
    const auto [weft, warp] = weft_and_warp(t, direction);
    Vec3 now = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      now += (weft * worn.weft[i] + warp * worn.warp[i]) * nodes_[model_.node_triangles[t][i]];
    }
    return std::max(0.0, now.norm() / std::hypot(weft, warp) - 1);
  }

  /// N/m per strain of a triangle along a flat direction: a mean of weft's and warp's.
  double stiffness_along(int t, const Vec2& direction) const {
    const StretchTriangle& s = model_.stretch[t];
    const auto [weft, warp] = weft_and_warp(t, direction);
    return (weft * weft * s.weft_stiffness + warp * warp * s.warp_stiffness) /
           ((weft * weft + warp * warp) * s.area);
  }

  const PanelMesh& garment_;
  const GarmentModel& model_;
  const std::vector<Vec3>& nodes_;
  const std::vector<LimitMultiplier>& multipliers_;
  std::optional<InnerFace> inner_;  // none: not needed yet, or there is no body
  std::vector<int> panel_of_point_;
  StretchOptions options_;
  std::map<std::pair<int, int>, Beside> beside_;  // by the edge, lower point first
};

}  // namespace

std::vector<TightSeam> tight_seams(const PanelMesh& garment, const GarmentModel& model,
                                   const std::vector<Vec3>& nodes,
                                   const std::vector<LimitMultiplier>& multipliers) {
  return TightSeamSearch(garment, model, nodes, multipliers).run();
}

}  // namespace toile
