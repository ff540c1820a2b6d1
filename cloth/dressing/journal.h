// What is recorded while a garment is dressed: its stages, its largest changes, and its progress.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cloth/judge/frame.h"
#include "cloth/judge/measures.h"
#include "cloth/relaxation/relax.h"

namespace toile {

struct StageReport {
  std::string name;
  int attempt = 1;  ///< panels that tangle or slip are placed and sewn anew
  double open = 0;  ///< of close_seams: the share of the seams' offset that is left, 0 for closed
  int nodes = 0;    ///< of the mesh that the stage ran on
  int steps = 0;
  int searches = 0;  ///< for cloth near cloth
  double seconds = 0;
  double simulated = 0;  ///< seconds of the cloth's own time; 0 for a method that has none
  bool converged = false;
  Residual residual;
};

/// The report of a run of relax() over `nodes` nodes.
StageReport stage_of(const std::string& name, int nodes, const RelaxReport& report);

/// Largest changes of any panel on the way, fractions.
struct DuringDressing {
  double area = 0;
  double perimeter = 0;
};

class Journal {
 public:
  /// `watcher` may be empty.
  explicit Journal(FrameWatcher watcher) : watcher_(std::move(watcher)) {}

  /// From here on the watcher sees points as `view` maps them (metres); empty: as they are.
  void show_through(std::function<Vec3(const Vec3&)> view) { view_ = std::move(view); }

  /// Panels start anew: the changes so far no longer count.
  void begin_attempt(int attempt);

  /// Runs relax() as a stage on `mesh`, of which `model` is compiled; x as relax() takes it. At the
  /// end of the stage the whole dressing has come to `end`, 0 to 1.
  RelaxReport run(const std::string& stage, const PanelMesh& mesh, const GarmentModel& model,
                  const RelaxOptions& options, std::vector<Vec3>& x, double end);

  /// Records a stage that is no run; its garment stands at `points`, per material point of `mesh`.
  void add(const StageReport& stage, const PanelMesh& mesh, const std::vector<Vec3>& points);

  /// Makes one stage of those from index `first` on, which are of one name.
  void join_stages(std::size_t first);

  /// The last stage did what it is for, though it did not come to rest.
  void mark_converged() { stages_.back().converged = true; }

  int attempt() const { return attempt_; }
  const std::vector<StageReport>& stages() const { return stages_; }
  const DuringDressing& during() const { return during_; }
  /// Of the whole dressing, 0 to 1.
  double progress() const { return progress_; }

 private:
  void show(const PanelMesh& mesh, const std::string& stage, std::vector<Vec3> points) const;
  void measure(const PanelMesh& mesh, const std::vector<double>& areas, const Outlines& outlines,
               const std::vector<double>& perimeters, const std::vector<Vec3>& points);

  FrameWatcher watcher_;
  std::function<Vec3(const Vec3&)> view_;
  std::vector<StageReport> stages_;
  DuringDressing during_;
  double progress_ = 0;
  int attempt_ = 1;
};

}  // namespace toile
