#include "cloth/dressing/coupled_layers.h"

#include <algorithm>
#include <numeric>

#include "cloth/contact/pair_forces.h"
#include "cloth/contact/proximity.h"
#include "cloth/dressing/constants.h"
#include "cloth/dressing/stability_test.h"
#include "cloth/dressing/stages.h"
#include "cloth/model/compile.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// The scene with each garment's fabric known by name.
Scene with_fabrics(Scene scene, const std::vector<WornGarment>& garments) {
  for (std::size_t i = 0; i < garments.size(); ++i) {
    scene.fabrics[garment_fabric(i)] = garments[i].fabric;
  }
  return scene;
}

class CoupledRelaxation {
 public:
  CoupledRelaxation(const std::vector<WornGarment>& garments, const Scene& scene,
                    const DressOptions& options, const FrameWatcher& watcher)
      : garments_(garments),
        scene_(with_fabrics(scene, garments)),
        options_(options),
        watcher_(watcher),
        mesh_(join_garments(garments)),
        model_(compile(mesh_, scene_, mesh_.placed)) {
    hold_for_good();
    for (const WornGarment& worn : garments) {
      model_.body_offset = std::max(model_.body_offset, worn.body_offset);
      first_.push_back(static_cast<int>(start_.size()));
      start_.insert(start_.end(), worn.nodes.begin(), worn.nodes.end());
      warm_start_.skin_anchors.insert(warm_start_.skin_anchors.end(),
                                      worn.warm_start.skin_anchors.begin(),
                                      worn.warm_start.skin_anchors.end());
      warm_start_.skin_anchors.resize(start_.size());
      take_over(worn);
      warm_start_.multipliers.insert(warm_start_.multipliers.end(),
                                     worn.warm_start.multipliers.begin(),
                                     worn.warm_start.multipliers.end());
      first_triangle_.push_back(first_triangle_.back() + worn.garment->triangles.size());
      warm_start_.multipliers.resize(first_triangle_.back());
    }
    first_.push_back(static_cast<int>(start_.size()));
    if (first_.back() != model_.nodes) {
      throw Error("garments", "have other nodes than their meshes", "dress them anew");
    }
    // A mesh without nested ones has no coarser state that could be clean.
    if (!self_intersections({start_, model_.node_triangles}).empty()) {
      throw Error("garments", "intersect each other, and can't be moved together",
                  "dress each clear of the others first");
    }
  }

  CoupledResult run() {
    RestingState state = {std::move(start_), std::move(warm_start_)};
    come_to_rest(state);
    if (options_.release_seconds > 0) let_go_of(state);
    result_.converged = is_at_rest(result_.stages.back(), options_);
    for (std::size_t i = 0; i < garments_.size(); ++i) take_out(i, state);
    measure_pressings(state.nodes);
    return std::move(result_);
  }

 private:
  /// What is attached for good stays so.
  void hold_for_good() {
    int first_point = 0;
    for (const WornGarment& worn : garments_) {
      for (AttachedPoint attached : worn.attached) {
        attached.point += first_point;
        model_.attachments.push_back(attached);
      }
      first_point += static_cast<int>(worn.garment->flat.size());
    }
  }

  /// Takes over the friction anchors of a garment's edges and pairs. Pairs with the layer below are
  /// left out: its nodes have other numbers now.
  void take_over(const WornGarment& worn) {
    const int nodes = static_cast<int>(worn.nodes.size());
    for (EdgeAnchor anchor : worn.warm_start.edge_anchors) {
      for (int& v : anchor.edge) v += first_.back();
      warm_start_.edge_anchors.push_back(anchor);
    }
    for (PairAnchor anchor : worn.warm_start.pair_anchors) {
      if (std::ranges::max(anchor.vertices) >= nodes) continue;
      for (int& v : anchor.vertices) v += first_.back();
      warm_start_.pair_anchors.push_back(anchor);
    }
  }

  void set_forces(ForceOptions& options) const { options.bounded = true; }

  void come_to_rest(RestingState& state) {
    RelaxOptions options;
    set_forces(options);
    options.warm_start = &state.warm_start;
    ask_for_rest(options_, options);
    const std::string name = "relax_coupled";
    int calls = 0;
    const auto watch = [&](const std::vector<Vec3>& nodes, double progress) {
      if (watcher_) watcher_({mesh_, name, point_positions(model_, nodes), progress});
    };
    watch(state.nodes, 0);
    const RelaxReport report = relax(model_, options, state.nodes, [&](const RelaxProgress& at) {
      if (calls++ % 4 == 0) {
        watch(at.nodes, static_cast<double>(at.iteration) / options.max_iterations);
      }
    });
    watch(state.nodes, 1);
    state.warm_start = report.warm_start;
    state.at_rest = report.converged;
    extra_offset_ = report.extra_offset;
    result_.stages.push_back(stage_of(name, model_.nodes, report));
  }

  /// One garment's part of the state.
  void take_out(std::size_t garment, const RestingState& state) {
    const WornGarment& worn = garments_[garment];
    result_.nodes.emplace_back(state.nodes.begin() + first_[garment],
                               state.nodes.begin() + first_[garment + 1]);
    result_.extra_offset.emplace_back(extra_offset_.begin() + first_[garment],
                                      extra_offset_.begin() + first_[garment + 1]);
    std::vector<double> moved;
    for (std::size_t n = 0; n < worn.nodes.size(); ++n) {
      moved.push_back((result_.nodes.back()[n] - worn.nodes[n]).norm());
    }
    result_.moved.push_back(move_statistics(moved));
    Scene scene = scene_;
    scene.fabric = worn.fabric;
    std::vector<LimitMultiplier> multipliers;
    const std::vector<LimitMultiplier>& yarns = state.warm_start.multipliers;
    if (!yarns.empty()) {
      multipliers.assign(yarns.begin() + first_triangle_[garment],
                         yarns.begin() + first_triangle_[garment + 1]);
    }
    const GarmentModel model =
        compile(*worn.garment, scene, worn.garment->placed, model_.body_offset);
    const std::vector<Vec3>& nodes = result_.nodes.back();
    result_.tight_seams.push_back(tight_seams(*worn.garment, model, nodes, multipliers));
    if (scene.strain_limit) {
      result_.tight_regions.push_back(tight_regions(*worn.garment, point_positions(model, nodes),
                                                    *scene.strain_limit, multipliers));
    }
  }

  int garment_of(int node) const {
    return static_cast<int>(std::upper_bound(first_.begin(), first_.end(), node) - first_.begin()) -
           1;
  }

  void measure_pressings(const std::vector<Vec3>& x) {
    std::vector<int> nodes(x.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    const ProximitySearch search(model_.node_triangles, nodes, model_.shortest_edge);
    std::vector<ContactPair> pairs;
    std::vector<double> bound;
    search.find(x, touching_gaps * model_.self_gap, model_.self_gap, pairs, bound, false);
    const std::size_t count = garments_.size();
    std::vector<LayerContact> table(count * count);
    std::vector<std::vector<char>> touched(count * count);
    for (const ContactPair& pair : pairs) {
      const int a = garment_of(pair.vertices[0]);
      const int b = garment_of(pair.vertices[3]);
      if (a == b) continue;
      const int inner = std::min(a, b);
      const std::size_t at = inner * count + std::max(a, b);
      const auto& of = pair.vertices;
      table[at].force += push_of(pair, {x[of[0]], x[of[1]], x[of[2]], x[of[3]]}, true).force;
      touched[at].resize(x.size());
      for (const int v : pair.vertices) touched[at][v] |= garment_of(v) == inner;
    }
    for (std::size_t t = 0; t < model_.stretch.size(); ++t) {
      for (const int node : model_.node_triangles[t]) {
        for (std::size_t at = 0; at < table.size(); ++at) {
          if (!touched[at].empty() && touched[at][node]) {
            table[at].area += model_.stretch[t].area / 3;
          }
        }
      }
    }
    for (std::size_t at = 0; at < table.size(); ++at) {
      if (table[at].force <= 0) continue;
      table[at].inner = static_cast<int>(at / count);
      table[at].outer = static_cast<int>(at % count);
      result_.contacts.push_back(table[at]);
    }
  }

  void let_go_of(RestingState& state) {
    ReleaseOptions options;
    set_forces(options);
    options.seconds = options_.release_seconds;
    result_.release =
        test_stability(model_, options, state, [&](RestingState& moved) { come_to_rest(moved); });
  }

  const std::vector<WornGarment>& garments_;
  const Scene scene_;
  const DressOptions& options_;
  const FrameWatcher& watcher_;
  const PanelMesh mesh_;
  GarmentModel model_;
  std::vector<int> first_;                         // node of each garment, and the number of nodes
  std::vector<std::size_t> first_triangle_ = {0};  // of each garment, and the number of triangles
  std::vector<Vec3> start_;
  WarmStart warm_start_;
  std::vector<double> extra_offset_;  // RelaxReport's, of the last rest
  CoupledResult result_;
};

}  // namespace

std::string garment_fabric(std::size_t garment) { return "of garment " + std::to_string(garment); }

PanelMesh join_garments(const std::vector<WornGarment>& garments) {
  PanelMesh all;
  for (std::size_t i = 0; i < garments.size(); ++i) {
    const PanelMesh& one = *garments[i].garment;
    const int first_point = static_cast<int>(all.flat.size());
    const int first_triangle = static_cast<int>(all.triangles.size());
    all.flat.insert(all.flat.end(), one.flat.begin(), one.flat.end());
    all.placed.insert(all.placed.end(), one.placed.begin(), one.placed.end());
    for (const Triangle& t : one.triangles) {
      all.triangles.push_back({t[0] + first_point, t[1] + first_point, t[2] + first_point});
    }
    for (MeshedPanel panel : one.panels) {
      panel.first_point += first_point;
      panel.first_triangle += first_triangle;
      if (panel.fabric.empty()) panel.fabric = garment_fabric(i);
      all.panels.push_back(std::move(panel));
    }
    for (MeshedSeam seam : one.seams) {
      for (int& point : seam.a) point += first_point;
      for (int& point : seam.b) point += first_point;
      all.seams.push_back(std::move(seam));
    }
    for (MeshedElastic elastic : one.elastics) {
      for (int& point : elastic.points) point += first_point;
      all.elastics.push_back(std::move(elastic));
    }
    all.edge_length = std::max(all.edge_length, one.edge_length);
    all.subdivisions = i == 0 ? one.subdivisions : std::min(all.subdivisions, one.subdivisions);
  }
  return all;
}

CoupledResult relax_coupled(const std::vector<WornGarment>& garments, const Scene& scene,
                            const DressOptions& options, const FrameWatcher& watcher) {
  return CoupledRelaxation(garments, scene, options, watcher).run();
}

}  // namespace toile
