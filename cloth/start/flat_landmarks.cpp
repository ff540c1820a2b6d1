#include "cloth/start/flat_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "cloth/start/constants.h"
#include "geometry/border_loops.h"
#include "geometry/disjoint_sets.h"
#include "geometry/polygon.h"

namespace toile {

namespace {

/// Points and triangles of the layout's panels, in the picture.
struct Picture {
  const PanelMesh& garment;
  const FlatLayout& layout;
  std::vector<int> number;  ///< per material point, of its panel in the layout; -1: in none
  std::vector<Vec2> at;     ///< per material point
  std::vector<std::vector<Vec2>> outlines;  ///< per panel of the layout

  Picture(const PanelMesh& of, const FlatLayout& in) : garment(of), layout(in) {
    number.assign(garment.flat.size(), -1);
    at.assign(garment.flat.size(), Vec2::Zero());
    for (std::size_t i = 0; i < layout.panels.size(); ++i) {
      const MeshedPanel& panel = garment.panels[layout.panels[i]];
      for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
        number[p] = static_cast<int>(i);
        at[p] = layout.picture(i, garment.flat[p]);
      }
      const std::vector<Triangle> triangles(
          garment.triangles.begin() + panel.first_triangle,
          garment.triangles.begin() + panel.first_triangle + panel.triangles);
      outlines.emplace_back();
      for (const std::vector<int>& loop : border_loops(triangles, garment.flat.size())) {
        if (loop.size() <= outlines.back().size()) continue;
        outlines.back().clear();
        for (const int p : loop) outlines.back().push_back(at[p]);
      }
    }
  }

  bool is_cloth(const Vec2& p) const {
    return std::ranges::any_of(outlines, [&](const auto& outline) { return inside(outline, p); });
  }
};

}  // namespace

std::vector<FlatOpening> flat_openings(const PanelMesh& garment, const FlatLayout& layout) {
  const Picture picture(garment, layout);
  DisjointSets nodes(garment.flat.size());
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) nodes.join(seam.a[i], seam.b[i]);
  }
  std::vector<Triangle> triangles;
  for (const int p : layout.panels) {
    const MeshedPanel& panel = garment.panels[p];
    triangles.insert(triangles.end(), garment.triangles.begin() + panel.first_triangle,
                     garment.triangles.begin() + panel.first_triangle + panel.triangles);
  }
  // Of a node, the point that stands for it, and the faces that have one.
  std::map<int, std::pair<Vec2, int>> of_node;
  for (const Triangle& t : triangles) {
    for (const int p : t) {
      auto& [at, faces] = of_node.try_emplace(nodes.of(p), picture.at[p], 0).first->second;
      faces |= layout.back[picture.number[p]] ? 2 : 1;
    }
  }
  std::vector<FlatOpening> openings;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::set<int> cut = points_at_cut_outs(garment);
  for (const auto& loop : border_loops(nodes.joined(triangles), garment.flat.size())) {
    if (cut.contains(loop.front())) continue;
    FlatOpening opening{0, infinity, -infinity, infinity, -infinity, 0, false};
    int faces = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [p, mine] = of_node.at(loop[i]);
      const auto& [next, others] = of_node.at(loop[(i + 1) % loop.size()]);
      const double length = (next - p).norm();
      opening.length += length;
      opening.mean_height += length * 0.5 * (p.y() + next.y());
      opening.low = std::min(opening.low, p.y());
      opening.high = std::max(opening.high, p.y());
      opening.left = std::min(opening.left, p.x());
      opening.right = std::max(opening.right, p.x());
      faces |= mine;
    }
    opening.mean_height /= std::max(opening.length, 1e-9);
    opening.both_faces = faces == 3;
    if (opening.length >= min_flat_opening) openings.push_back(opening);
  }
  std::ranges::stable_sort(openings, [](const FlatOpening& a, const FlatOpening& b) {
    return a.mean_height > b.mean_height;
  });
  return openings;
}

std::vector<Vec2> shoulder_points(const PanelMesh& garment, const FlatLayout& layout) {
  const Picture picture(garment, layout);
  std::vector<Vec2> points;
  for (const MeshedSeam& seam : garment.seams) {
    const int a = picture.number[seam.a[seam.a.size() / 2]];
    const int b = picture.number[seam.b[seam.b.size() / 2]];
    if (a < 0 || b < 0 || layout.back[a] == layout.back[b]) continue;
    for (std::size_t i = 0; i + 1 < seam.a.size(); ++i) {
      const Vec2 from = 0.5 * (picture.at[seam.a[i]] + picture.at[seam.b[i]]);
      const Vec2 to = 0.5 * (picture.at[seam.a[i + 1]] + picture.at[seam.b[i + 1]]);
      if (std::abs(to.x() - from.x()) < std::abs(to.y() - from.y())) continue;
      const Vec2 middle = 0.5 * (from + to);
      const Vec2 step(0, shoulder_probe);
      if (picture.is_cloth(middle - step) && !picture.is_cloth(middle + step)) {
        points.push_back(middle);
      }
    }
  }
  return points;
}

double face_top(const PanelMesh& garment, const FlatLayout& layout, bool back, double x) {
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    if ((layout.back[i] != 0) != back) continue;
    const MeshedPanel& panel = garment.panels[layout.panels[i]];
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      const Vec2 at = layout.picture(i, garment.flat[p]);
      if (std::abs(at.x() - x) < face_top_width) top = std::max(top, at.y());
    }
  }
  return top;
}

}  // namespace toile
