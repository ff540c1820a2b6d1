#include "cloth/judge/tight_regions.h"

#include <algorithm>
#include <cmath>

#include "cloth/judge/flat_line.h"
#include "cloth/judge/yarn_strain.h"

namespace toile {

namespace {

constexpr double speck = 1e-4;  // m²
constexpr int lines = 24;       // through a place

class Places {
 public:
  Places(const PanelMesh& garment, const GarmentModel& model, const std::vector<Vec3>& nodes,
         const std::vector<LimitMultiplier>& held)
      : garment_(garment),
        model_(model),
        held_(held),
        limit_(*model.scene.strain_limit),
        points_(point_positions(model, nodes, 0)),
        strains_(yarn_strains(garment, points_)) {
    around_.resize(garment.flat.size());
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
      for (const int p : garment.triangles[t]) around_[p].push_back(static_cast<int>(t));
    }
  }

  TightRegions run() const {
    TightRegions found;
    for (const bool along_warp : {false, true}) {
      for (const MeshedPanel& panel : garment_.panels) {
        for (const std::vector<int>& piece : pieces(panel, along_warp)) {
          TightRegion place = measure(panel, along_warp, piece);
          if (place.area < speck) {
            ++found.specks;
          } else {
            found.places.push_back(std::move(place));
          }
        }
      }
    }
    std::stable_sort(found.places.begin(), found.places.end(),
                     [](const auto& a, const auto& b) { return a.largest > b.largest; });
    return found;
  }

 private:
  double strain(int t, bool along_warp) const {
    return along_warp ? strains_[t].warp : strains_[t].weft;
  }

  /// Whether the yarn is beyond the limit for all that it is held with.
  bool is_tight(int t, bool along_warp) const {
    const double restraint = along_warp ? held_[t].warp : held_[t].weft;
    return strain(t, along_warp) > limit_is_kept * limit_ &&
           restraint > (1 - 1e-9) * max_limit_multiplier;
  }

  /// Tight triangles of a panel, those that touch together.
  std::vector<std::vector<int>> pieces(const MeshedPanel& panel, bool along_warp) const {
    std::vector<std::vector<int>> all;
    std::vector<char> seen(panel.triangles, 0);
    const auto take = [&](int t, std::vector<int>& piece) {
      if (seen[t - panel.first_triangle] || !is_tight(t, along_warp)) return;
      seen[t - panel.first_triangle] = 1;
      piece.push_back(t);
    };
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      std::vector<int> piece;
      take(t, piece);
      for (std::size_t i = 0; i < piece.size(); ++i) {
        for (const int p : garment_.triangles[piece[i]]) {
          for (const int other : around_[p]) take(other, piece);
        }
      }
      if (!piece.empty()) all.push_back(std::move(piece));
    }
    return all;
  }

  TightRegion measure(const MeshedPanel& panel, bool along_warp,
                      const std::vector<int>& piece) const {
    TightRegion place;
    place.panel = panel.name;
    place.along_warp = along_warp;
    place.flat = Vec2::Zero();
    for (const int t : piece) {
      const double area = model_.stretch[t].area;
      place.area += area;
      place.mean += area * strain(t, along_warp);
      place.largest = std::max(place.largest, strain(t, along_warp));
      for (const int p : garment_.triangles[t]) {
        place.flat += area / 3 * garment_.flat[p];
        place.height += area / 3 * points_[p].y();
      }
    }
    place.mean /= place.area;
    place.flat /= place.area;
    place.height /= place.area;
    const Vec2 weft(std::cos(panel.grain), std::sin(panel.grain));
    place.missing = missing(piece, along_warp, along_warp ? Vec2(-weft.y(), weft.x()) : weft);
    return place;
  }

  /// Metres by which the cloth is longer than it may be along the yarn that lacks the most.
  double missing(const std::vector<int>& piece, bool along_warp, const Vec2& yarn) const {
    const Vec2 across(-yarn.y(), yarn.x());
    double low = 1e300;
    double high = -1e300;
    double begin = 1e300;
    for (const int t : piece) {
      for (const int p : garment_.triangles[t]) {
        low = std::min(low, garment_.flat[p].dot(across));
        high = std::max(high, garment_.flat[p].dot(across));
        begin = std::min(begin, garment_.flat[p].dot(yarn));
      }
    }
    double most = 0;
    for (int i = 0; i < lines; ++i) {
      // No round share, so that no line runs along an edge of the mesh.
      const double at = low + (high - low) * (i + 0.381966) / lines;
      const Vec2 from = (begin - 0.01) * yarn + at * across;
      double sum = 0;
      for (const int t : piece) {
        const double length = length_within(flat_corners(garment_, t), from, yarn);
        if (length > 0) sum += length * (strain(t, along_warp) - limit_);
      }
      most = std::max(most, sum);
    }
    return most;
  }

  const PanelMesh& garment_;
  const GarmentModel& model_;
  const std::vector<LimitMultiplier>& held_;
  double limit_;
  std::vector<Vec3> points_;
  std::vector<YarnStrain> strains_;
  std::vector<std::vector<int>> around_;  // triangles, by material point
};

}  // namespace

TightRegions tight_regions(const PanelMesh& garment, const GarmentModel& model,
                           const std::vector<Vec3>& nodes,
                           const std::vector<LimitMultiplier>& held) {
  if (!model.scene.strain_limit || held.empty()) return {};
  return Places(garment, model, nodes, held).run();
}

}  // namespace toile
