// Only what a scene needs is modelled: what each sample is compiled to, and that each term counts.
#include <map>
#include <set>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "geometry/repair.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tests/cloth/panels.h"
#include "tests/stability/hard_case.h"
#include "tests/support/shapes.h"

namespace toile::test {
namespace terms_test {

using Terms = std::map<std::string, int>;

Terms terms_of(const GarmentModel& model) {
  const auto counts = term_counts(model);
  return {counts.begin(), counts.end()};
}

/// A number for each sewn point: the lowest of those that are sewn to it. By repetition, apart from
/// the compiler's disjoint sets.
std::vector<int> joined(const PanelMesh& garment) {
  std::vector<int> lowest(garment.flat.size());
  for (std::size_t p = 0; p < lowest.size(); ++p) lowest[p] = static_cast<int>(p);
  for (bool changed = true; changed;) {
    changed = false;
    for (const MeshedSeam& seam : garment.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        int& a = lowest[seam.a[i]];
        int& b = lowest[seam.b[i]];
        changed = changed || a != b;
        a = b = std::min(a, b);
      }
    }
  }
  return lowest;
}

class SampleTerms : public HardCase, public testing::WithParamInterface<const char*> {};

TEST_P(SampleTerms, AreThoseOfTheGarment) {
  const PanelMesh garment = read_garment(meshed(sample(GetParam())));
  Scene scene;
  for (const MeshedPanel& panel : garment.panels) {
    if (!panel.fabric.empty()) scene.fabrics[panel.fabric] = {};
  }
  // For what is attached at a level of the body.
  const TriangleMesh skin = fan_triangles(read_mesh(mannequin()));
  const Skeleton skeleton = read_skeleton(skeleton_path(mannequin()));
  const Collider wearer(skin);
  scene.collider = &wearer;
  scene.body_contact = BodyContactTerm::none;
  scene.skeleton = &skeleton;
  const GarmentModel bare = compile(garment, scene, garment.placed);
  const std::vector<int> node = joined(garment);
  std::map<int, int> copies;
  for (const int n : node) ++copies[n];
  int sewn = 0;
  for (const auto& [n, count] : copies) sewn += count > 1;
  std::map<std::pair<int, int>, int> faces;
  for (const Triangle& t : garment.triangles) {
    for (int i = 0; i < 3; ++i) ++faces[std::minmax(node[t[i]], node[t[(i + 1) % 3]])];
  }
  int hinges = 0;
  for (const auto& [edge, count] : faces) hinges += count == 2;
  int segments = 0;
  for (const MeshedElastic& elastic : garment.elastics) {
    segments += static_cast<int>(elastic.points.size()) - 1;
  }
  int attached = 0;
  for (const MeshedAttachment& each : garment.attachments) {
    attached += static_cast<int>(each.points.size());
  }
  const int triangles = static_cast<int>(garment.triangles.size());
  const int nodes = static_cast<int>(copies.size());
  const std::set<std::string> with_elastics = {"elastic_skirt", "tube_top"};
  EXPECT_EQ(segments > 0, with_elastics.contains(GetParam()));

  Terms found = terms_of(bare);
  EXPECT_EQ(found["stretch"], triangles);
  EXPECT_EQ(found["bend"], hinges);
  EXPECT_EQ(found["seam"], sewn);
  EXPECT_EQ(found["elastic"], segments);
  EXPECT_EQ(found["attachment"], attached);
  EXPECT_EQ(found["self_contact"], triangles);
  EXPECT_EQ(found["cloth_friction"], nodes);
  for (const char* unused :
       {"body_contact", "friction", "layer_contact", "strain_limit", "shear_limit"}) {
    EXPECT_EQ(found[unused], 0) << unused;
  }

  // And what a scene adds or takes is added and taken, and nothing else.
  const TriangleMesh ball = sphere(0.1, 3);
  Collider body(skin);
  body.add_layer(ball);
  Scene full = scene;
  full.collider = &body;
  full.body_contact = BodyContactTerm::nodes;
  full.strain_limit = 0.01;
  full.shear_limit = 0.1;
  Terms with = terms_of(compile(garment, full, garment.placed));
  EXPECT_EQ(with["body_contact"], nodes);
  EXPECT_EQ(with["friction"], nodes);
  EXPECT_EQ(with["layer_contact"], static_cast<int>(ball.triangles.size()));
  EXPECT_GT(with["strain_limit"], 0);
  EXPECT_LE(with["strain_limit"], triangles);
  Scene least = scene;
  least.self_contact = false;
  for (Fabric* fabric : {&least.fabric}) fabric->bending_warp = fabric->bending_weft = 0;
  for (auto& [name, fabric] : least.fabrics) fabric.bending_warp = fabric.bending_weft = 0;
  Terms without = terms_of(compile(garment, least, garment.placed));
  EXPECT_EQ(without["bend"], 0);
  EXPECT_EQ(without["self_contact"], 0);
  EXPECT_EQ(without["stretch"], triangles);
  state("D terms of " + std::string(GetParam()), "relaxation", "compiled",
        std::to_string(triangles) + " stretch, " + std::to_string(hinges) + " bend, " +
            std::to_string(sewn) + " seam, " + std::to_string(segments) + " elastic, " +
            std::to_string(attached) + " attachment, " + std::to_string(nodes) + " body_contact");
}

INSTANTIATE_TEST_SUITE_P(All, SampleTerms,
                         testing::Values("band", "band_small", "bodice_dress", "elastic_skirt",
                                         "fitted_tshirt", "gathered_skirt", "jacket", "trousers",
                                         "tshirt", "tube_top", "walking_dress"),
                         [](const auto& test) { return std::string(test.param); });

/// Two handkerchiefs sewn along a side, draped over a ball: the scene uses all that is switched.
class SwitchedOff : public testing::Test {
 protected:
  SwitchedOff() {
    for (const double left : {-0.15, 0.0}) {
      add_panel(garment, left < 0 ? "left" : "right", grid(0.15, 0.3, 10, 20),
                [&](const Vec2& p) { return Vec3(p.x() + left, 0.06, 0.15 - p.y()); });
    }
    garment.seams = {seam("middle", side(garment.panels[0], 10, 20, true),
                          side(garment.panels[1], 10, 20, false))};
    scene.collider = &distance;
    scene.body_contact = BodyContactTerm::nodes;
    scene.strain_limit = 0.001;
    scene.fabric.stretch_warp = scene.fabric.stretch_weft = 50;
    scene.fabric.shear = 10;
  }

  std::vector<Vec3> rest(const PanelMesh& of, const Scene& by, bool friction = true) const {
    const GarmentModel model = compile(of, by, of.placed);
    RelaxOptions options;
    options.max_iterations = 3000;
    options.friction = friction;
    std::vector<Vec3> x = model.start;
    relax(model, options, x);
    return point_positions(model, x);
  }

  double changed(const Scene& other) const { return changed(garment, other); }
  double changed(const PanelMesh& of, const Scene& other) const {
    const std::vector<Vec3> usual = rest(of, scene);
    const std::vector<Vec3> now = rest(of, other);
    double most = 0;
    for (std::size_t p = 0; p < now.size(); ++p) most = std::max(most, (now[p] - usual[p]).norm());
    return most;
  }

  void expect_changed(const std::string& what, double metres) {
    EXPECT_GT(metres, 1e-3) << what;
    state("D " + what + " switched off", "relaxation", "changes the rest",
          "by " + number(1000 * metres) + " mm at most");
  }

  const TriangleMesh ball = sphere(0.05, 4);
  const Collider distance{ball};
  PanelMesh garment;
  Scene scene;
};

TEST_F(SwitchedOff, Bending) {
  Scene other = scene;
  other.fabric.bending_warp = other.fabric.bending_weft = 0;
  expect_changed("bending", changed(other));
}

// Off the middle of the ball, where only friction holds it: on the middle, it would stay anyway.
TEST_F(SwitchedOff, Friction) {
  PanelMesh aside = garment;
  for (Vec3& p : aside.placed) p.x() += 0.01;
  Scene other = scene;
  other.fabric.friction_skin = other.fabric.friction_cloth = 0;
  expect_changed("friction", changed(aside, other));
}

TEST_F(SwitchedOff, SelfContact) {
  Scene other = scene;
  other.self_contact = false;
  expect_changed("self-contact", changed(other));
}

TEST_F(SwitchedOff, BodyContact) {
  Scene other = scene;
  other.body_contact = BodyContactTerm::none;
  expect_changed("body contact", changed(other));
}

TEST_F(SwitchedOff, TheStrainLimit) {
  Scene other = scene;
  other.strain_limit.reset();
  expect_changed("the strain limit", changed(other));
}

TEST_F(SwitchedOff, Seams) {
  PanelMesh apart = garment;
  apart.seams.clear();
  const std::vector<Vec3> sewn = rest(garment, scene);
  const std::vector<Vec3> open = rest(apart, scene);
  const int a = garment.seams[0].a.front(), b = garment.seams[0].b.front();
  EXPECT_EQ((sewn[a] - sewn[b]).norm(), 0);
  expect_changed("the seam", (open[a] - open[b]).norm());
}

// What is off and what does not exist are one and the same: the bits of the rest.
TEST_F(SwitchedOff, WhatASceneDoesNotUseChangesNoBit) {
  Scene other = scene;
  other.shear_limit = std::nullopt;
  other.fabrics["unused"] = Fabric();
  other.fabrics["unused"].thickness = 0.02;
  EXPECT_EQ(changed(other), 0);
}

}  // namespace terms_test
}  // namespace toile::test
