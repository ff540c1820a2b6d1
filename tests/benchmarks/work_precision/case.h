// A garment in a scene, and how a method may be told to bring it to rest.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/relax.h"
#include "geometry/surface_distance.h"
#include "pattern/panel_mesh.h"

namespace toile::precision {

enum class Method { relaxation, paper };
inline const char* name_of(Method method) {
  return method == Method::relaxation ? "relaxation" : "paper";
}

/// One turn of a method's knob. What a method does not know has no effect on it.
struct Setting {
  std::string knob;          ///< the one that is turned
  std::string value;         ///< as shown
  double residual = 0.01;    ///< of the median, in node weights; the rms may be ten times that
  int iterations = 400000;   ///< relaxation: at most, on the garment's own mesh
  double step_share = 0.9;   ///< paper: of the largest stable step
  double seconds = 3;        ///< paper: simulated at most, of the fall
  bool exact_limit = false;  ///< paper: the strain limit is held, not only approached
};

/// Where a run ended.
struct Outcome {
  std::vector<Vec3> points;  ///< metres, per material point
  Residual residual;
  bool converged = false;
  bool sewn = true;    ///< else its seams would not close, and it was not draped
  int iterations = 0;  ///< on the garment's own mesh
  double simulated = 0;
  double wall = 0;       ///< seconds
  double processor = 0;  ///< seconds, of all threads
};

class Case {
 public:
  Case(std::string scene, double edge_mm) : scene_(std::move(scene)), edge_mm_(edge_mm) {}
  virtual ~Case() = default;

  const std::string& scene() const { return scene_; }
  double edge_mm() const { return edge_mm_; }
  virtual const PanelMesh& garment() const = 0;
  /// Compiled: who shares a node.
  virtual const GarmentModel& model() const = 0;
  /// None: nothing to measure ease against.
  virtual const SurfaceDistance* body() const { return nullptr; }
  /// Residual of a reference of the paper's method: what it comes to in reasonable time.
  virtual double springs_at_rest() const = 0;
  virtual Outcome run(Method method, const Setting& setting) const = 0;

 private:
  std::string scene_;
  double edge_mm_;
};

/// "at rest", "not at rest" or "not sewn".
std::string end_of(const Outcome& outcome);

/// Wall and processor time since it was made.
class Stopwatch {
 public:
  Stopwatch();
  void stop(Outcome& outcome) const;

 private:
  double wall_;
  double processor_;
};

/// Places of the material points, from those of the nodes of the same triangles.
std::vector<Vec3> material_points(const PanelMesh& garment, const std::vector<Vec3>& nodes,
                                  const std::vector<Triangle>& triangles);

}  // namespace toile::precision
