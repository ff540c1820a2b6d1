#include "cloth/start/around_panels.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "cloth/start/constants.h"

namespace toile {

namespace {

/// Calls use(point of the panel, point of another panel) for each pair of sewn points.
void each_partner(const PanelMesh& garment, int panel, const auto& use) {
  const MeshedPanel& of = garment.panels[panel];
  const auto is_mine = [&](int p) { return p >= of.first_point && p < of.first_point + of.points; };
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if (is_mine(seam.a[i]) == is_mine(seam.b[i])) continue;
      const bool a_mine = is_mine(seam.a[i]);
      use(a_mine ? seam.a[i] : seam.b[i], a_mine ? seam.b[i] : seam.a[i]);
    }
  }
}

/// Whether the points of a panel that are sewn to others lie farther apart in y than in x.
bool is_sewn_along_y(const PanelMesh& garment, int panel) {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = -low;
  each_partner(garment, panel, [&](int mine, int) {
    low = low.cwiseMin(garment.flat[mine]);
    high = high.cwiseMax(garment.flat[mine]);
  });
  return high.y() - low.y() > high.x() - low.x();
}

}  // namespace

PlacementAxis up_axis(const PanelMesh& garment, int panel, bool to_partners) {
  const std::vector<int> panel_of = panel_of_points(garment);
  const MeshedPanel& of = garment.panels[panel];
  Vec2 along = is_sewn_along_y(garment, panel) ? Vec2(1, 0) : Vec2(0, 1);
  for (const MeshedSeam& seam : garment.seams) {
    if (panel_of[seam.a[1]] != panel || panel_of[seam.b[1]] != panel) continue;
    const Vec2 run = garment.flat[seam.a.back()] - garment.flat[seam.a.front()];
    along = std::abs(run.x()) > std::abs(run.y()) ? Vec2(1, 0) : Vec2(0, 1);
    break;
  }
  Vec2 sewn = Vec2::Zero();
  Vec2 centre = Vec2::Zero();
  int count = 0;
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    centre += garment.flat[i] / of.points;
  }
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const bool a_mine = panel_of[seam.a[i]] == panel;
      if (a_mine == (panel_of[seam.b[i]] == panel)) continue;
      sewn += garment.flat[a_mine ? seam.a[i] : seam.b[i]] - centre;
      ++count;
    }
  }
  const double up = to_partners && count > 0 ? sewn.dot(along) : 1;
  if (along.x() > 0) return up < 0 ? PlacementAxis::minus_x : PlacementAxis::plus_x;
  return up < 0 ? PlacementAxis::minus_y : PlacementAxis::plus_y;
}

bool may_be_strip(const PanelMesh& garment, int panel) {
  const std::vector<int> panel_of = panel_of_points(garment);
  const int along = is_sewn_along_y(garment, panel) ? 1 : 0;
  // Where a side that is sewn to others ends: the point, and the direction back along the side.
  std::vector<std::pair<int, Vec2>> ends;
  const auto add = [&](const std::vector<int>& side) {
    const auto from = [&](int end, int next) {
      ends.emplace_back(end, (garment.flat[next] - garment.flat[end]).normalized());
    };
    from(side.front(), side[1]);
    from(side.back(), side[side.size() - 2]);
  };
  for (const MeshedSeam& seam : garment.seams) {
    const bool a_mine = panel_of[seam.a[1]] == panel;
    if (a_mine == (panel_of[seam.b[1]] == panel)) continue;
    const std::vector<int>& side = a_mine ? seam.a : seam.b;
    const Vec2 run = garment.flat[side.back()] - garment.flat[side.front()];
    if (std::abs(run[1 - along]) > std::abs(run[along])) return false;
    add(side);
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (ends[i].first == ends[j].first && ends[i].second.dot(ends[j].second) > strip_corner) {
        return false;
      }
    }
  }
  return true;
}

TubeFit tube_fit(const PanelMesh& garment, int panel,
                 const std::function<std::optional<double>(int)>& angle_of) {
  const bool is_level = !is_sewn_along_y(garment, panel);
  const PlacementAxis up = is_level ? PlacementAxis::plus_y : PlacementAxis::plus_x;
  const PlacementAxis down = is_level ? PlacementAxis::minus_y : PlacementAxis::minus_x;
  const MeshedPanel& of = garment.panels[panel];
  double low = 1e300;
  double high = -low;
  for (int p = of.first_point; p < of.first_point + of.points; ++p) {
    low = std::min(low, upright(up, garment.flat[p]).x());
    high = std::max(high, upright(up, garment.flat[p]).x());
  }
  std::complex<double> sums[2] = {0, 0};
  int count = 0;
  each_partner(garment, panel, [&](int mine, int other) {
    const std::optional<double> there = angle_of(other);
    if (!there) return;
    const double x = upright(up, garment.flat[mine]).x();
    const double own = 2 * std::numbers::pi * ((x - low) / (high - low) - 0.5);
    sums[0] += std::polar(1.0, *there - own);
    sums[1] += std::polar(1.0, *there + own);  // upside down, what was right is left
    ++count;
  });
  if (count == 0) return {};
  const bool is_down = std::abs(sums[1]) > std::abs(sums[0]);
  const std::complex<double> sum = sums[is_down ? 1 : 0];
  return {std::abs(sum) / count, std::arg(sum), is_down ? down : up};
}

}  // namespace toile
