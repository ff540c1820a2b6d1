#include "tests/figures/paper_dressing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <set>

#include "cloth/judge/measures.h"
#include "pattern/check/check_pattern.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"

namespace toile::figures {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<double> changes_percent(const std::vector<double>& rest,
                                    const std::vector<double>& now) {
  std::vector<double> changes;
  for (std::size_t i = 0; i < rest.size(); ++i) changes.push_back(100 * (now[i] / rest[i] - 1));
  return changes;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

MannequinOptions posed(const Pose& pose) {
  MannequinOptions options;
  options.pose = pose;
  return options;
}

/// Follows a dressing. Keeps every state, which the figures choose from once it is over.
class Follower {
 public:
  explicit Follower(const PanelMesh& garment)
      : garment_(garment),
        areas_(panel_areas(garment)),
        perimeters_(triangle_perimeters(garment)) {}

  void operator()(const DressFrame& frame) { add(frame.stage, frame.seconds, frame.points); }

  void add(const std::string& stage, double seconds, const std::vector<Vec3>& points) {
    moments.push_back({seconds, stage, changes_percent(areas_, panel_areas(garment_, points)),
                       changes_percent(perimeters_, triangle_perimeters(garment_, points))});
    states.push_back(points);
  }

  /// The last state of the stage; `share`: as far on the way through it.
  void choose(const std::string& stage, double share, const std::string& caption,
              std::vector<DressingState>& chosen) const {
    std::vector<std::size_t> of_stage;
    for (std::size_t i = 0; i < moments.size(); ++i) {
      if (moments[i].stage == stage) of_stage.push_back(i);
    }
    if (of_stage.empty()) return;
    const auto at = static_cast<std::size_t>(share * static_cast<double>(of_stage.size() - 1));
    chosen.push_back({caption, states[of_stage[at]]});
  }

  std::vector<DressingMoment> moments;
  std::vector<std::vector<Vec3>> states;

 private:
  const PanelMesh& garment_;
  std::vector<double> areas_;
  std::vector<double> perimeters_;
};

std::string nearest_joint(const Skeleton& skeleton, const Vec3& point) {
  std::string name;
  double least = std::numeric_limits<double>::max();
  for (const auto& [joint, at] : skeleton.joints) {
    if ((at - point).norm() < least) {
      least = (at - point).norm();
      name = joint;
    }
  }
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

void say(const PaperDressing& d) {
  const GarmentMeasurements& g = d.judgement.garment;
  std::cerr << d.name << ": " << to_string(d.judgement.verdict) << "; " << d.result.nodes.size()
            << " nodes, " << d.steps() << " steps of " << 1e6 * d.result.time_step << " us, "
            << 1e3 * d.seconds_per_step() << " ms a step, " << d.seconds << " s; seams open "
            << g.seams.open << ", intersections " << d.judgement.body_intersections << " body "
            << d.judgement.self_intersections << " self " << d.judgement.layer_intersections
            << " layers; strain off the seams max " << 100 * g.strain_off_seams.max << " % p99 "
            << 100 * g.strain_off_seams.p99 << " %; on the way area " << d.max_area()
            << " %, perimeter " << d.max_perimeter() << " %; residual median "
            << d.result.residual.median << " rms " << d.result.residual.rms << "; wraps";
  for (const WrapMeasurement& wrap : d.judgement.wraps) {
    std::cerr << ' ' << name_of(wrap.part) << ' ' << wrap.fraction;
  }
  std::cerr << std::endl;
}

}  // namespace

Wearer::Wearer(const Pose& pose)
    : mannequin(make_mannequin(posed(pose))), subject(mannequin.surface) {}

PanelMesh sample_garment(const std::string& name, double edge_length) {
  std::vector<Remark> remarks;
  const auto path = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json");
  const Pattern pattern = read_pattern(path, remarks);
  check_pattern(pattern, remarks);
  MeshSettings settings;
  settings.edge_length = edge_length;
  // The paper knows one mesh. A nested mesh is cut by its coarsest level, for which curves ask for
  // shorter steps. The shortest edge of all decides the number of steps in time.
  settings.subdivisions = 0;
  return mesh_panels(pattern, settings, remarks);
}

double DressingMoment::largest_area() const { return largest(area); }
double DressingMoment::largest_perimeter() const { return largest(perimeter); }

long PaperDressing::steps() const {
  long sum = 0;
  for (const StageReport& stage : result.stages) sum += stage.steps;
  return sum;
}

double PaperDressing::simulated() const {
  double sum = 0;
  for (const StageReport& stage : result.stages) sum += stage.simulated;
  return sum;
}

double PaperDressing::seconds_per_step() const {
  double sum = 0;
  for (const StageReport& stage : result.stages) sum += stage.seconds;
  return steps() > 0 ? sum / static_cast<double>(steps()) : 0;
}

double PaperDressing::max_area() const {
  double most = 0;
  for (const DressingMoment& m : moments) most = std::max(most, m.largest_area());
  return most;
}

double PaperDressing::max_perimeter() const {
  double most = 0;
  for (const DressingMoment& m : moments) most = std::max(most, m.largest_perimeter());
  return most;
}

SpringDressOptions figure_options() {
  SpringDressOptions options;
  options.motion.converged_strain = true;
  return options;
}

PaperDressing dress_by_paper(const std::string& name, const PanelMesh& garment,
                             const Wearer& wearer, const SpringDressOptions& options,
                             const Fabric& fabric) {
  const Clock::time_point start = Clock::now();
  std::cerr << name << ": " << garment.flat.size() << " points, edges of "
            << 1000 * garment.edge_length << " mm ..." << std::endl;
  const Skeleton& skeleton = wearer.mannequin.skeleton;
  PaperDressing done;
  done.name = name;
  done.garment = garment;
  done.options = options;
  Scene scene;
  scene.fabric = fabric;
  scene.collider = &wearer.subject;
  const TriangleMesh& layers = wearer.subject.cloth();
  scene.skeleton = &skeleton;
  // What is judged needs to know where the panels stood.
  done.garment.placed = position_panels(garment, wearer.subject.grid(), &skeleton).placed;

  Follower follower(garment);
  done.result =
      dress_springs(garment, scene, options, [&](const DressFrame& frame) { follower(frame); });
  done.dressed = as_dressed(done.garment, done.result.nodes, done.result.triangles);
  done.judgement = judge(done.garment, done.dressed, wearer.subject.body(), &skeleton,
                         {done.result.converged}, layers.triangles.empty() ? nullptr : &layers);
  const std::vector<Vec3> last = material_points(garment, done.result);
  follower.add(done.result.stages.back().name, done.simulated(), last);
  done.states.push_back({"position", done.result.placement.placed});
  follower.choose("wrap", 0.5, "wrap, half way", done.states);
  follower.choose("wrap", 1, "wrapped", done.states);
  follower.choose("sew", 1, done.judgement.garment.seams.open > 0 ? "seams stay open" : "sewn",
                  done.states);
  follower.choose("drape", 1, "draped", done.states);
  done.moments = std::move(follower.moments);
  done.places = strained_places(garment, last, skeleton, options.motion.strain.limit);
  done.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  say(done);
  return done;
}

std::vector<StrainedPlace> strained_places(const PanelMesh& garment,
                                           const std::vector<Vec3>& points,
                                           const Skeleton& skeleton, double limit) {
  std::vector<char> on_seam(points.size(), 0);
  for (const MeshedSeam& seam : garment.seams) {
    for (const int p : seam.a) on_seam[p] = 1;
    for (const int p : seam.b) on_seam[p] = 1;
  }
  std::map<std::pair<std::string, std::string>, StrainedPlace> places;
  for (const MeshedPanel& panel : garment.panels) {
    std::set<std::pair<int, int>> edges;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      for (int k = 0; k < 3; ++k) {
        edges.insert(std::minmax(garment.triangles[t][k], garment.triangles[t][(k + 1) % 3]));
      }
    }
    for (const auto& [a, b] : edges) {
      if (on_seam[a] && on_seam[b]) continue;
      const double change =
          (points[a] - points[b]).norm() / (garment.flat[a] - garment.flat[b]).norm() - 1;
      if (std::abs(change) <= limit) continue;
      const Vec3 middle = (points[a] + points[b]) / 2;
      const std::string joint = nearest_joint(skeleton, middle);
      StrainedPlace& place = places[{panel.name, joint}];
      place.panel = panel.name;
      place.joint = joint;
      ++place.edges;
      if (std::abs(change) > place.largest) {
        place.largest = std::abs(change);
        place.longer = change > 0;
        place.at = middle;
      }
    }
  }
  std::vector<StrainedPlace> sorted;
  for (const auto& [key, place] : places) sorted.push_back(place);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.largest > b.largest; });
  return sorted;
}

}  // namespace toile::figures
