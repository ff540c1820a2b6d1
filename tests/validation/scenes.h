// Strips and sheets that are held at nodes, brought to rest by either method.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/mesh_polygon.h"
#include "pattern/panel_mesh.h"

namespace toile::test {

/// How a rectangle is cut into triangles: squares with one diagonal, the same turned by 45
/// degrees, or as the pattern mesher does.
enum class Cut { structured, turned, unstructured };
inline constexpr Cut all_cuts[] = {Cut::structured, Cut::turned, Cut::unstructured};
std::string name_of(Cut cut);

/// A rectangle from the origin with edges of about `edge`, metres.
PlanarMesh cut_rectangle(double length, double width, double edge, Cut cut);

/// With its mirror image across x = 0, where it has to have its left side: bent over a line there,
/// either half is clamped.
PlanarMesh mirrored(const PlanarMesh& right);

/// Keeps nodes where they start: no force moves what is stiff beyond all others, and weighs
/// nothing.
void hold(GarmentModel& model, const std::function<bool(const Vec3&)>& held);

/// Rests by relax() until the median force on the nodes is below `residual` weights of a node.
/// Fails the test when it does not come to that.
std::vector<Vec3> relaxed(const GarmentModel& model, double residual = 1e-6,
                          int max_iterations = 400000);

struct SpringRestOptions {
  double seconds = 3;   ///< simulated, at most
  double drag = 10;     ///< 1/s
  double speed = 1e-6;  ///< m/s of the fastest node, at which the sheet counts as at rest
};

/// Rests by the springs of the paper's method, stepped explicitly, the held nodes held.
std::vector<Vec3> sprung(const PanelMesh& garment, const GarmentModel& model,
                         const SpringRestOptions& options = {});

}  // namespace toile::test
