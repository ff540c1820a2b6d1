// Small garments that the tests of the cloth room share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh_polygon.h"
#include "pattern/classify/classify.h"
#include "pattern/file/garment_file.h"
#include "pattern/panel_mesh.h"
#include "tests/pattern/sewn.h"

namespace toile::test {

/// A rectangle from the origin, cut into columns x rows and each of those along its rising
/// diagonal. Point (column, row) has index row·(columns + 1) + column.
inline PlanarMesh grid(double width, double height, int columns, int rows) {
  PlanarMesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      mesh.points.emplace_back(width * column / columns, height * row / rows);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int at = row * (columns + 1) + column;
      const int above = at + columns + 1;
      mesh.triangles.push_back({at, at + 1, above + 1});
      mesh.triangles.push_back({at, above + 1, above});
    }
  }
  return mesh;
}

/// Names a panel, and lets it be what its name says.
inline void name_panel(MeshedPanel& panel, const std::string& name) {
  panel.name = name;
  panel.is = classify({name});
}

/// Adds a panel; `place` says where a flat point is in space.
template <typename Place>
MeshedPanel& add_panel(PanelMesh& garment, const std::string& name, const PlanarMesh& mesh,
                       const Place& place) {
  MeshedPanel panel;
  name_panel(panel, name);
  panel.first_point = static_cast<int>(garment.flat.size());
  panel.points = static_cast<int>(mesh.points.size());
  panel.first_triangle = static_cast<int>(garment.triangles.size());
  panel.triangles = static_cast<int>(mesh.triangles.size());
  for (const Vec2& p : mesh.points) {
    garment.flat.push_back(p);
    garment.placed.push_back(place(p));
  }
  for (const Triangle& t : mesh.triangles) {
    garment.triangles.push_back(
        {t[0] + panel.first_point, t[1] + panel.first_point, t[2] + panel.first_point});
  }
  garment.panels.push_back(panel);
  return garment.panels.back();
}

/// One panel, laid flat in the plane z = 0.
inline PanelMesh flat_panel(const PlanarMesh& mesh) {
  PanelMesh garment;
  add_panel(garment, "panel", mesh, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  return garment;
}

/// Points of the left or right side of a grid() panel, upward.
inline std::vector<int> side(const MeshedPanel& panel, int columns, int rows, bool right) {
  std::vector<int> points;
  for (int row = 0; row <= rows; ++row) {
    points.push_back(panel.first_point + row * (columns + 1) + (right ? columns : 0));
  }
  return points;
}

inline MeshedSeam seam(const std::string& name, std::vector<int> a, std::vector<int> b) {
  MeshedSeam sewn;
  sewn.name = name;
  sewn.a = std::move(a);
  sewn.b = std::move(b);
  return sewn;
}

/// The two side seams of a front and a back, panels 0 and 1, each grid(…, columns, rows).
inline std::vector<MeshedSeam> side_seams(const PanelMesh& garment, int columns, int rows) {
  const auto side_of = [&](int panel, bool right) {
    return side(garment.panels[panel], columns, rows, right);
  };
  return {seam("left", side_of(0, true), side_of(1, false)),
          seam("right", side_of(1, true), side_of(0, false))};
}

/// Two squares of 10 cm side by side, 1 cm apart, sewn together between them.
inline PanelMesh sewn_pair(int columns = 5) {
  PanelMesh garment;
  const PlanarMesh square = grid(0.1, 0.1, columns, columns);
  add_panel(garment, "left", square, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  add_panel(garment, "right", square, [](const Vec2& p) { return Vec3(p.x() + 0.11, p.y(), 0); });
  garment.seams = {seam("middle", side(garment.panels[0], columns, columns, true),
                        side(garment.panels[1], columns, columns, false))};
  return garment;
}

/// The garment as if it had been dressed with its material points at `points`; sewn points share a
/// node where `sew` is true.
inline DressedGarment as_dressed(const PanelMesh& garment, const std::vector<Vec3>& points,
                                 bool sew = true) {
  std::vector<int> node = samples::sewn_nodes(garment);
  for (std::size_t p = 0; !sew && p < node.size(); ++p) node[p] = static_cast<int>(p);
  std::vector<int> index(points.size(), -1);
  std::vector<Vec3> nodes;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (node[p] != static_cast<int>(p)) continue;
    index[p] = static_cast<int>(nodes.size());
    nodes.push_back(points[p]);
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : garment.triangles) {
    triangles.push_back({index[node[t[0]]], index[node[t[1]]], index[node[t[2]]]});
  }
  return toile::as_dressed(garment, std::move(nodes), std::move(triangles));
}

/// Three parallel panels, sewn at their right sides: the second to the third, then the third to the
/// first.
inline PanelMesh three_panels_in_a_chain() {
  PanelMesh garment;
  for (int i = 0; i < 3; ++i) {
    add_panel(garment, "panel", grid(0.1, 0.1, 4, 4),
              [&](const Vec2& p) { return Vec3(p.x(), p.y(), 0.1 * i); });
  }
  const auto right_of = [&](int i) { return side(garment.panels[i], 4, 4, true); };
  garment.seams = {seam("", right_of(1), right_of(2)), seam("", right_of(2), right_of(0))};
  return garment;
}

}  // namespace toile::test
