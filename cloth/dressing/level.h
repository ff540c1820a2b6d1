// One of a garment's nested meshes, and the state of the garment on it.
#pragma once

#include <vector>

#include "cloth/contact/friction_state.h"
#include "cloth/model/compile.h"
#include "cloth/relaxation/force_options.h"
#include "cloth/scene/scene.h"
#include "geometry/intersections.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The garment's nested meshes, the finest first. Linear in the triangles.
std::vector<PanelMesh> nested_meshes(const PanelMesh& garment);

/// A nested mesh, compiled.
struct Level {
  const PanelMesh* mesh = nullptr;
  int depth = 0;             ///< 0: the garment's own mesh; the deeper, the coarser
  std::vector<Vec3> placed;  ///< metres, per material point: where its panel started
  GarmentModel model;
};

struct State {
  std::vector<Vec3> nodes;  ///< metres, one a node of the level's model
  WarmStart warm_start;
  /// RelaxReport's, of the last run.
  std::vector<double> extra_offset = {};
};

/// Metres kept from the skin on the garment's own mesh: the scene's at least. Edges above 15 mm
/// need more, because their faces cut the curves of a body.
double resting_offset(const PanelMesh& garment, const Scene& scene);

/// Metres kept from the skin while the garment settles on a mesh: the coarser, the more. Over
/// layers also more than at rest, for their folds are sharper than a body.
double settling_offset(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset);

/// The mesh, compiled with its settling offset. Throws what compile() throws.
Level compiled_level(const PanelMesh& mesh, int depth, const Scene& scene,
                     const std::vector<Vec3>& placed, double resting_offset);

/// The next finer level, whose mesh is `fine`, and the same state on it. What friction holds is
/// forgotten.
Level finer_level(const Level& coarse, const PanelMesh& fine, const Scene& scene,
                  double resting_offset, State& state);

/// Whether no two triangles of the cloth intersect, by the exact test.
bool is_clear_of_itself(const Level& level, const State& state);

/// Pairs of triangles of the cloth that intersect, by the exact test.
std::size_t count_self_intersections(const Level& level, const State& state);

/// Pairs of triangles of cloth and body that intersect, by the exact test.
std::vector<TrianglePair> body_intersections(const Level& level, const State& state);

/// Whether the cloth is outside of all layers below and meets none of them, so that bounds can keep
/// it so. False without layers.
bool is_clear_of_layers(const Level& level, const State& state);

/// Metres that the cloth has come down from where its nodes were, on average.
double fallen(const Level& level, const State& state, const std::vector<Vec3>& from);

/// Place of every material point, metres.
std::vector<Vec3> points_of(const Level& level, const State& state);

}  // namespace toile
