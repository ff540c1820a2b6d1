// Case 3: needles, triangles without area, points in one place, in none, faces listed twice; a
// panel of one triangle, one with a hole. 200,000 nodes: very_large_test.cpp.
#include "geometry/repair.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tests/cloth/panels.h"
#include "tests/stability/hard_case.h"
#include "tests/support/shapes.h"

namespace toile::test {
namespace bad_meshes_test {

using pipeline::run;

class BadGarment : public HardCase {
 protected:
  static constexpr double width = 0.6;
  static constexpr int cells = 16;

  /// A square sheet that lies level above the mannequin's head.
  static PanelMesh cape(const PlanarMesh& mesh = grid(width, width, cells, cells)) {
    PanelMesh garment;
    add_panel(garment, "cape", mesh,
              [](const Vec2& p) { return Vec3(p.x() - width / 2, 1.75, width / 2 - p.y()); });
    garment.edge_length = width / cells;
    return garment;
  }

  fs::path written(const PanelMesh& garment) {
    write_garment(folder / "cape.obj", garment);
    return folder / "cape.obj";
  }

  void refuses(const PanelMesh& garment, const std::string& what, const std::string& words) {
    const std::string said = refused("dress", {"--body", mannequin(), written(garment)});
    EXPECT_NE(said.find(words), std::string::npos) << said;
    state("3 " + what, "both", "error", said);
  }

  /// By both methods, whose verdicts have to be among those `allowed`.
  void dresses(const PanelMesh& garment, const std::string& what,
               const std::vector<std::string>& allowed) {
    const fs::path path = written(garment);
    for (const std::string& method : both_methods) {
      const Ending ending = dress(mannequin(), path, method);
      EXPECT_NE(std::find(allowed.begin(), allowed.end(), ending.outcome), allowed.end())
          << method << ": " << ending.outcome << ", " << ending.said;
      state("3 " + what, method, ending.outcome, ending.figures());
    }
  }
};

/// A row of cells a ten-thousandth as wide as the others.
TEST_F(BadGarment, Needles) {
  PlanarMesh mesh = grid(width, width, cells + 1, cells);
  const double cell = width / cells;
  for (Vec2& p : mesh.points) {
    const int column = static_cast<int>(std::lround(p.x() / width * (cells + 1)));
    p.x() = column <= 8 ? column * cell : (column - 1) * cell + (column == 9 ? 1e-4 * cell : 0);
  }
  // The explicit step may not follow needles, nor their residual come down: then it says so.
  dresses(cape(mesh), "needles, 1 : 10,000", {"sewn", "unconverged", "intersecting"});
}

TEST_F(BadGarment, ATriangleWithoutArea) {
  PlanarMesh mesh = grid(width, width, cells, cells);
  mesh.triangles.push_back({0, 1, 2});
  refuses(cape(mesh), "triangle without area", "face 512");
}

TEST_F(BadGarment, PointsInOnePlaceOfThePanel) {
  PlanarMesh mesh = grid(width, width, cells, cells);
  mesh.points[101] = mesh.points[100];
  refuses(cape(mesh), "two points in one place of the panel", "counter-clockwise");
}

/// Of a band around the waist: a cape can slide off the head, and then never comes to rest.
TEST_F(BadGarment, PointsPlacedInOnePlace) {
  PanelMesh garment = read_garment(band());
  garment.subdivisions = 0;
  const Triangle& corners = garment.triangles[50];
  garment.placed[corners[1]] = garment.placed[corners[0]];
  dresses(garment, "two points placed in one place", {"sewn"});
}

TEST_F(BadGarment, AllPointsPlacedInOnePlace) {
  PanelMesh garment = cape();
  for (Vec3& p : garment.placed) p = Vec3(0, 2, 0);
  refuses(garment, "all points placed in one place", "'cape' is placed with less than");
}

TEST_F(BadGarment, APointOfNoTriangle) {
  PlanarMesh mesh = grid(width, width, cells, cells);
  mesh.points.emplace_back(0.3, 0.3);
  refuses(cape(mesh), "isolated point", "vertex 290 is in no face");
}

TEST_F(BadGarment, AFaceListedTwice) {
  PlanarMesh mesh = grid(width, width, cells, cells);
  mesh.triangles.push_back(mesh.triangles[50]);
  refuses(cape(mesh), "face listed twice", "faces 50 and 512 lie on each other");
}

TEST_F(BadGarment, AnEdgeOfThreeFaces) {
  PlanarMesh mesh = grid(width, width, cells, cells);
  mesh.points.push_back(mesh.points[100] + Vec2(0.01, 0.03));
  mesh.triangles.push_back({100, 101, static_cast<int>(mesh.points.size()) - 1});
  refuses(cape(mesh), "edge of three faces", "lie on each other");
}

/// It rests on the crown of the head or slides off it, and falls for ever then.
TEST_F(BadGarment, APanelOfOneTriangle) {
  PlanarMesh mesh;
  mesh.points = {{0.25, 0.25}, {0.35, 0.25}, {0.3, 0.37}};
  mesh.triangles = {{0, 1, 2}};
  dresses(cape(mesh), "panel of one triangle", {"sewn", "unconverged"});
}

/// A hole of 10 x 8 cm in the front of a band around the waist.
TEST_F(BadGarment, APanelWithAHole) {
  const auto height = [](const PanelMesh& garment, int p) { return garment.flat[p].y(); };
  PanelMesh garment = read_garment(band());
  garment.subdivisions = 0;
  const auto in_hole = [&](const Triangle& t) {
    const Vec2 middle = (garment.flat[t[0]] + garment.flat[t[1]] + garment.flat[t[2]]) / 3;
    return std::abs(middle.x()) < 0.05 && std::abs(middle.y() - 0.13) < 0.04;
  };
  MeshedPanel& front = garment.panels[0];
  MeshedPanel& back = garment.panels[1];
  const auto first = garment.triangles.begin();
  const auto cut = std::remove_if(first, first + front.triangles, in_hole);
  const int removed = static_cast<int>(first + front.triangles - cut);
  ASSERT_GT(removed, 8);
  ASSERT_GT(height(garment, 0), 0);
  garment.triangles.erase(cut, first + front.triangles);
  front.triangles -= removed;
  back.first_triangle -= removed;
  // Points that only the hole had would belong to no face.
  PanelMesh holed = garment;
  std::vector<int> now(garment.flat.size(), -1);
  std::vector<char> used(garment.flat.size(), 0);
  for (const Triangle& t : garment.triangles) {
    for (const int p : t) used[p] = 1;
  }
  holed.flat.clear();
  holed.placed.clear();
  for (std::size_t p = 0; p < used.size(); ++p) {
    if (!used[p]) continue;
    now[p] = static_cast<int>(holed.flat.size());
    holed.flat.push_back(garment.flat[p]);
    holed.placed.push_back(garment.placed[p]);
  }
  const int lost = static_cast<int>(garment.flat.size() - holed.flat.size());
  ASSERT_GT(lost, 0);
  holed.panels[0].points -= lost;
  holed.panels[1].first_point -= lost;
  for (Triangle& t : holed.triangles) {
    for (int& p : t) p = now[p];
  }
  for (MeshedSeam& seam : holed.seams) {
    for (int& p : seam.a) p = now[p];
    for (int& p : seam.b) p = now[p];
  }
  dresses(holed, "panel with a hole", {"sewn"});
}

class BadBodyMesh : public HardCase {
 protected:
  /// Splits an edge of every `every`th triangle by a point at `share` of its length: the surface
  /// stays closed, with two triangles more.
  static TriangleMesh split(TriangleMesh mesh, std::size_t every, double share) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; i += every) {
      const auto [a, b, c] = mesh.triangles[i];
      for (std::size_t j = 0; j < count; ++j) {
        const Triangle t = mesh.triangles[j];
        for (int k = 0; k < 3; ++k) {
          if (t[k] != b || t[(k + 1) % 3] != a) continue;
          const int d = t[(k + 2) % 3];
          const int n = static_cast<int>(mesh.points.size());
          const Vec3 at = (1 - share) * mesh.points[a] + share * mesh.points[b];
          mesh.points.push_back(at);
          mesh.triangles[i] = {a, n, c};
          mesh.triangles[j] = {b, n, d};
          mesh.triangles.push_back({n, b, c});
          mesh.triangles.push_back({n, a, d});
          j = count;
          break;
        }
      }
    }
    return mesh;
  }

  void dresses(const TriangleMesh& mesh, const std::string& what) {
    ASSERT_TRUE(is_closed(mesh));
    const fs::path body = folder / "body.ply";
    write_mesh(body, mesh);
    fs::copy_file(skeleton_path(mannequin()), folder / "body.body.json");
    const fs::path garment = band();
    for (const std::string& method : both_methods) {
      const Ending ending = dress(body, garment, method);
      EXPECT_EQ(ending.outcome, "sewn") << ending.said;
      state("3 " + what, method, ending.outcome, ending.figures());
    }
    const pipeline::Run clean = run("clean-body", {body, "-o", folder / "clean.ply"});
    EXPECT_EQ(clean.exit_code, 0) << clean.err;
    EXPECT_TRUE(is_closed(fan_triangles(read_mesh(folder / "clean.ply"))));
    state("3 " + what, "clean-body", "mended", "closed");
  }
};

TEST_F(BadBodyMesh, PointsInOnePlace) {
  dresses(split(fan_triangles(read_mesh(mannequin())), 64, 0), "body with points in one place");
}

TEST_F(BadBodyMesh, Needles) {
  dresses(split(fan_triangles(read_mesh(mannequin())), 64, 1e-4), "body with needles, 1 : 10,000");
}

TEST_F(BadBodyMesh, IsolatedPoints) {
  TriangleMesh mesh = fan_triangles(read_mesh(mannequin()));
  mesh.points.emplace_back(0, 1, 0);
  dresses(mesh, "body with an isolated point");
}

/// A body whose isolated point is far away is no taller for it.
TEST_F(BadBodyMesh, FarIsolatedPoints) {
  TriangleMesh mesh = fan_triangles(read_mesh(mannequin()));
  mesh.points.emplace_back(50, 100, 3);
  dresses(mesh, "body with an isolated point 100 m away");
}

}  // namespace bad_meshes_test
}  // namespace toile::test
