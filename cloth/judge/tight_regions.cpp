#include "cloth/judge/tight_regions.h"

#include <algorithm>
#include <cmath>

#include "cloth/judge/constants.h"
#include "cloth/judge/flat_line.h"
#include "cloth/judge/yarn_strain.h"
#include "cloth/scene/constants.h"
#include "geometry/polygon.h"

namespace toile {

namespace {

/// Finds and measures the tight regions of one garment.
class TightRegionSearch {
 public:
  TightRegionSearch(const PanelMesh& garment, const std::vector<Vec3>& points, double limit,
                    const std::vector<LimitMultiplier>& multipliers)
      : garment_(garment),
        points_(points),
        limit_(limit),
        multipliers_(multipliers),
        strains_(yarn_strains(garment, points)),
        gathered_(on_gathers(garment)) {
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
          TightRegion region = measure(panel, along_warp, piece);
          if (region.area < min_region_area) {
            ++found.specks;
          } else {
            found.regions.push_back(std::move(region));
          }
        }
      }
    }
    std::stable_sort(found.regions.begin(), found.regions.end(),
                     [](const auto& a, const auto& b) { return a.largest > b.largest; });
    return found;
  }

 private:
  double strain(int t, bool along_warp) const {
    return along_warp ? strains_[t].warp : strains_[t].weft;
  }

  /// Whether the yarn is beyond the limit, and stays so though its multiplier is the largest there
  /// is.
  bool is_tight(int t, bool along_warp) const {
    if (gathered_[t]) return false;
    if (multipliers_.empty()) return strain(t, along_warp) > limit_;
    const double multiplier = along_warp ? multipliers_[t].warp : multipliers_[t].weft;
    return strain(t, along_warp) > kept_limit * limit_ &&
           multiplier > (1 - 1e-9) * max_limit_multiplier;
  }

  /// The tight triangles of a panel in pieces: triangles that share a corner are in one piece.
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
    TightRegion region;
    region.panel = panel.name;
    region.along_warp = along_warp;
    region.flat = Vec2::Zero();
    for (const int t : piece) {
      const auto [a, b, c] = flat_corners(garment_, t);
      const double area = std::abs(signed_area({a, b, c}));
      region.area += area;
      region.mean += area * strain(t, along_warp);
      region.largest = std::max(region.largest, strain(t, along_warp));
      for (const int p : garment_.triangles[t]) {
        region.flat += area / 3 * garment_.flat[p];
        region.height += area / 3 * points_[p].y();
      }
    }
    region.mean /= region.area;
    region.flat /= region.area;
    region.height /= region.area;
    const YarnDirections yarns = yarn_directions(panel.grain);
    region.missing = missing(piece, along_warp, along_warp ? yarns.warp : yarns.weft);
    return region;
  }

  /// Metres by which the cloth exceeds its limit along the yarn where that is most.
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
    double largest = 0;
    for (int i = 0; i < region_lines; ++i) {
      // The share is not round, so that no line runs along an edge of the mesh.
      const double at = low + (high - low) * (i + 0.381966) / region_lines;
      const Vec2 from = (begin - 0.01) * yarn + at * across;
      double sum = 0;
      for (const int t : piece) {
        const double length = length_within(flat_corners(garment_, t), from, yarn);
        if (length > 0) sum += length * (strain(t, along_warp) - limit_);
      }
      largest = std::max(largest, sum);
    }
    return largest;
  }

  const PanelMesh& garment_;
  const std::vector<Vec3>& points_;
  double limit_;
  const std::vector<LimitMultiplier>& multipliers_;
  std::vector<YarnStrain> strains_;
  std::vector<char> gathered_;
  std::vector<std::vector<int>> around_;  // triangles, by material point
};

}  // namespace

TightRegions tight_regions(const PanelMesh& garment, const std::vector<Vec3>& points, double limit,
                           const std::vector<LimitMultiplier>& multipliers) {
  return TightRegionSearch(garment, points, limit, multipliers).run();
}

std::vector<TightRegion> overstretched(const PanelMesh& garment, const std::vector<Vec3>& points) {
  std::vector<TightRegion> regions = tight_regions(garment, points, max_worn_strain).regions;
  std::erase_if(
      regions, [](const TightRegion& region) { return region.area < hand_breadth * hand_breadth; });
  return regions;
}

}  // namespace toile
