#include "cloth/judge/slits.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <utility>

#include "cloth/judge/constants.h"
#include "geometry/angles.h"
#include "geometry/border_loops.h"

namespace toile {

namespace {

/// Radians at corner i of a flat triangle.
double corner_angle(const PanelMesh& garment, const Triangle& t, int i) {
  const Vec2 to_next = garment.flat[t[(i + 1) % 3]] - garment.flat[t[i]];
  const Vec2 to_last = garment.flat[t[(i + 2) % 3]] - garment.flat[t[i]];
  return std::acos(std::clamp(to_next.normalized().dot(to_last.normalized()), -1.0, 1.0));
}

/// Of an edge of the border, from its first node to its second.
struct BorderEdge {
  double length = 0;  ///< metres, flat
  int panel = -1;
};

/// Radians, 135 degrees, half way between a square corner and a straight edge. A band ends where it
/// has less about a point of the border, and the edge goes on where the rest has more. At 90 and
/// 180 degrees corners that are a little off square decide by chance.
constexpr double square_or_straight = 0.75 * std::numbers::pi;

bool is_band(const MeshedPanel& panel) {
  return panel.is.role == PanelRole::waistband || panel.is.role == PanelRole::cuff;
}

}  // namespace

std::vector<Slit> find_slits(const PanelMesh& garment, const DressedGarment& dressed) {
  std::vector<double> turn(dressed.points.size(), 0);  // radians of cloth around each node
  std::vector<Triangle> triangles;                     // without layered panels
  std::map<std::pair<int, int>, BorderEdge> edges;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    const int panel = dressed.panel_of_triangle[t];
    if (garment.panels[panel].layered) continue;
    triangles.push_back(dressed.triangles[t]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int a = dressed.triangles[t][i];
      const int b = dressed.triangles[t][j];
      turn[a] += corner_angle(garment, garment.triangles[t], i);
      const Vec2 along =
          garment.flat[garment.triangles[t][j]] - garment.flat[garment.triangles[t][i]];
      edges[std::minmax(a, b)] = {along.norm(), panel};
    }
  }
  std::vector<Slit> slits;
  for (const std::vector<int>& loop : border_loops(triangles, dressed.points.size())) {
    const int count = static_cast<int>(loop.size());
    const auto node = [&](int i) { return loop[((i % count) + count) % count]; };
    /// Metres from the tip at `i` to the next corner of the border, one way round.
    const auto run = [&](int i, int step) {
      double length = 0;
      double turned = 0;  // within the last `slit_corner` metres
      std::deque<std::pair<double, double>> bends;
      for (int walked = 1; walked < count; ++walked) {
        const int at = i + step * walked;
        length += edges[std::minmax(node(at - step), node(at))].length;
        bends.emplace_back(length, turn[node(at)] - std::numbers::pi);
        turned += bends.back().second;
        for (; bends.front().first < length - slit_corner; bends.pop_front()) {
          turned -= bends.front().second;
        }
        if (std::abs(turned) > max_slit_bend) break;
      }
      return length;
    };
    double ring = 0;
    for (int i = 0; i < count; ++i) ring += edges[std::minmax(node(i), node(i + 1))].length;
    for (int i = 0; i < count; ++i) {
      if (turn[node(i)] < min_slit_turn) continue;
      const double length = std::min(run(i, 1), run(i, -1));
      if (length < min_slit) continue;
      const auto panel = [&](int next) {
        return garment.panels[edges[std::minmax(node(i), node(next))].panel].name;
      };
      slits.push_back({panel(i - 1), panel(i + 1), length, dressed.points[node(i)], node(i),
                       std::max(0.0, ring - 2 * length)});
    }
  }
  return slits;
}

std::vector<BandEnd> find_band_ends(const PanelMesh& garment, const DressedGarment& dressed) {
  std::vector<Triangle> triangles;
  std::map<std::pair<int, int>, int> panel_beside;  // of an edge of the border
  std::map<std::pair<int, int>, double> turn;       // radians of cloth, of a node and a panel
  std::vector<double> whole(dressed.points.size(), 0);
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    const int panel = dressed.panel_of_triangle[t];
    if (garment.panels[panel].layered) continue;
    triangles.push_back(dressed.triangles[t]);
    const Triangle& flat = garment.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      const int node = dressed.triangles[t][i];
      const double angle = corner_angle(garment, flat, i);
      whole[node] += angle;
      turn[{node, panel}] += angle;
      panel_beside[std::minmax(node, dressed.triangles[t][next])] = panel;
    }
  }
  std::vector<BandEnd> ends;
  for (const std::vector<int>& loop : border_loops(triangles, dressed.points.size())) {
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
      const int node = loop[i];
      int band = panel_beside.at(std::minmax(node, loop[(i + 1) % count]));
      int other = panel_beside.at(std::minmax(node, loop[(i + count - 1) % count]));
      if (!is_band(garment.panels[band])) std::swap(band, other);
      if (!is_band(garment.panels[band]) || is_band(garment.panels[other])) continue;
      const double of_band = turn.at({node, band});
      if (of_band > square_or_straight || whole[node] - of_band < square_or_straight) continue;
      ends.push_back({garment.panels[band].name, garment.panels[other].name, dressed.points[node]});
    }
  }
  return ends;
}

}  // namespace toile
