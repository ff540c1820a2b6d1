#include "cloth/springs/subject_collisions.h"

#include <algorithm>

#include "cloth/springs/constants.h"
#include "cloth/springs/crossing_guard.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Triangles that one task handles.
constexpr std::size_t triangle_chunk = 256;

}  // namespace

class SubjectCollisions::Response {
 public:
  Response(const TriangleMesh& subject, const std::vector<Triangle>& triangles)
      : subject_(subject), candidates_(subject_, max_let_out_depth) {
    set_cloth(triangles);
  }

  void set_cloth(const std::vector<Triangle>& triangles) {
    candidates_.set_cloth(triangles);
    clear_.resize(triangles.size());
    reach_.resize(triangles.size());
    pair_reach_.resize(triangles.size());
    moved_.resize(triangles.size());
    chunks_.resize(chunks_of(triangles.size(), triangle_chunk));
  }

  CollisionCounts respond(const CollisionStep& step, std::vector<Vec3>& v);
  const SubjectSurface& subject() const { return subject_; }
  const std::vector<ClothTriangle>& cloth() const { return candidates_.cloth(); }

 private:
  template <class Work>
  void each_chunk(const Work& work) {
    parallel_for(chunks_.size(), [&](std::size_t c) {
      work(c, c * triangle_chunk, std::min((c + 1) * triangle_chunk, candidates_.cloth().size()));
    });
  }
  void nodes_first(const CollisionStep& step, std::vector<Vec3>& v);
  bool find_pairs(const CollisionStep& step, double slack, const std::vector<Vec3>& v);
  void solve(double friction, double enough, std::vector<Vec3>& v);
  void guard(const CollisionStep& step, std::vector<Vec3>& v);
  void touch(int node);

  SubjectSurface subject_;
  CollisionCandidates candidates_;
  std::vector<double> reach_;       // per triangle, metres: what may matter in this step, of a node
  std::vector<double> pair_reach_;  // the same of edges and vertices
  std::vector<double> moved_;       // per triangle, since its lists were made
  std::vector<double> clear_;       // per triangle, distance of what is in front of it
  std::vector<NodeContacts> node_contacts_;
  std::vector<PairContacts> chunks_;
  PairContacts pairs_;
  std::vector<int> touched_;  // nodes that pairs push, in the order they were met
  std::vector<char> is_touched_;
  bool all_pairs_ = true;
  double fastest_ = 0;  // m/s, of the approaches answered in this step
};

void SubjectCollisions::Response::touch(int node) {
  if (is_touched_[node] != 0) return;
  is_touched_[node] = 1;
  touched_.push_back(node);
}

void SubjectCollisions::Response::nodes_first(const CollisionStep& step, std::vector<Vec3>& v) {
  std::vector<double> fastest(chunks_.size(), 0);
  each_chunk([&](std::size_t c, std::size_t begin, std::size_t end) {
    for (int t = static_cast<int>(begin); t < static_cast<int>(end); ++t) {
      const ClothTriangle& own = step.cloth[t];
      double speed = 0;
      for (const int node : own.nodes) speed = std::max(speed, step.before[node].squaredNorm());
      const double passed = std::sqrt(speed) * step.dt;
      reach_[t] = step.options.tolerance + passed;
      pair_reach_[t] = step.options.edge_tolerance + passed;
      const NearTriangle& near = candidates_.refreshed(
          t, step.x, reach_[t], pair_reach_[t],
          std::clamp(candidate_list_steps * passed, min_candidate_margin, max_candidate_margin));
      clear_[t] = pair_reach_[t];
      moved_[t] = near.moved(own.nodes, step.x);
      for (int i = 0; i < 3; ++i) {
        if (!own.owns_node[i]) continue;
        NodeContacts& contacts = node_contacts_[own.nodes[i]];
        contacts.count = 0;
        if (near.facets.empty() || step.inverse_mass[own.nodes[i]] == 0) continue;
        contacts = node_contacts(step, t, i, near, moved_[t], reach_[t], clear_[t]);
        fastest[c] = std::max(fastest[c], contacts.solve(step.options.friction, v));
      }
    }
  });
  for (const double speed : fastest) fastest_ = std::max(fastest_, speed);
}

bool SubjectCollisions::Response::find_pairs(const CollisionStep& step, double slack,
                                             const std::vector<Vec3>& v) {
  each_chunk([&](std::size_t c, std::size_t begin, std::size_t end) {
    chunks_[c].edges.clear();
    chunks_[c].vertices.clear();
    for (int t = static_cast<int>(begin); t < static_cast<int>(end); ++t) {
      const NearTriangle& near = candidates_.near(t);
      if (near.edges.empty() && near.vertices.empty()) continue;
      const Triangle& n = step.cloth[t].nodes;
      if (!all_pairs_ && !is_touched_[n[0]] && !is_touched_[n[1]] && !is_touched_[n[2]]) continue;
      pair_contacts(step, t, near, moved_[t], pair_reach_[t], v, slack, chunks_[c], clear_[t]);
    }
  });
  bool any = false;
  for (PairContacts& found : chunks_) {
    for (Contact<2>& contact : found.edges) {
      any = true;
      fastest_ = std::max(fastest_, contact.approach(v));
      for (const int node : contact.nodes) touch(node);
      pairs_.edges.push_back(contact);
    }
    for (Contact<3>& contact : found.vertices) {
      any = true;
      fastest_ = std::max(fastest_, contact.approach(v));
      for (const int node : contact.nodes) touch(node);
      pairs_.vertices.push_back(contact);
    }
  }
  return any;
}

void SubjectCollisions::Response::solve(double friction, double enough, std::vector<Vec3>& v) {
  for (int sweep = 0; sweep < impulse_sweeps; ++sweep) {
    double change = 0;
    for (Contact<3>& contact : pairs_.vertices) {
      change = std::max(change, contact.solve(friction, v));
    }
    for (Contact<2>& contact : pairs_.edges) {
      change = std::max(change, contact.solve(friction, v));
    }
    for (const int node : touched_) {
      change = std::max(change, node_contacts_[node].solve(friction, v));
    }
    if (change <= enough) break;
  }
}

void SubjectCollisions::Response::guard(const CollisionStep& step, std::vector<Vec3>& v) {
  std::vector<int> long_steps;
  for (int t = 0; t < static_cast<int>(clear_.size()); ++t) {
    double speed = 0;
    for (const int node : step.cloth[t].nodes) speed = std::max(speed, v[node].squaredNorm());
    const double max_speed = usable_distance_share * clear_[t] / step.dt;
    if (speed <= max_speed * max_speed) continue;
    const double reach = 2 * std::sqrt(speed) * step.dt;
    candidates_.refreshed(t, step.x, reach, reach, min_candidate_margin);
    long_steps.push_back(t);
  }
  if (!long_steps.empty()) keep_from_crossing(step, long_steps, candidates_, v);
}

CollisionCounts SubjectCollisions::Response::respond(const CollisionStep& step,
                                                     std::vector<Vec3>& v) {
  node_contacts_.resize(v.size());
  is_touched_.assign(v.size(), 0);
  touched_.clear();
  pairs_.edges.clear();
  pairs_.vertices.clear();
  all_pairs_ = true;
  fastest_ = 0;
  nodes_first(step, v);
  for (int round = 0; round < collision_rounds; ++round) {
    const double enough = std::max(left_approach_share * fastest_, left_approach_speed);
    if (!find_pairs(step, round == 0 ? left_approach_speed : 2 * enough, v)) break;
    solve(step.options.friction, std::max(left_approach_share * fastest_, left_approach_speed), v);
    all_pairs_ = false;
  }
  guard(step, v);

  CollisionCounts counts;
  for (const ClothTriangle& own : step.cloth) {
    for (int i = 0; i < 3; ++i) {
      if (!own.owns_node[i]) continue;
      const NodeContacts& contacts = node_contacts_[own.nodes[i]];
      for (int k = 0; k < contacts.count; ++k) {
        counts.particle_facet += contacts.contacts[k].push > 0 ? 1 : 0;
      }
    }
  }
  for (const Contact<2>& contact : pairs_.edges) counts.edge_edge += contact.push > 0 ? 1 : 0;
  for (const Contact<3>& contact : pairs_.vertices) {
    counts.vertex_triangle += contact.push > 0 ? 1 : 0;
  }
  return counts;
}

SubjectCollisions::SubjectCollisions(const TriangleMesh& subject,
                                     const std::vector<Triangle>& triangles)
    : response_(std::make_unique<Response>(subject, triangles)) {}

SubjectCollisions::~SubjectCollisions() = default;
SubjectCollisions::SubjectCollisions(SubjectCollisions&&) noexcept = default;
SubjectCollisions& SubjectCollisions::operator=(SubjectCollisions&&) noexcept = default;

void SubjectCollisions::set_cloth(const std::vector<Triangle>& triangles) {
  response_->set_cloth(triangles);
}

CollisionCounts SubjectCollisions::respond(const std::vector<Vec3>& x,
                                           const std::vector<double>& inverse_mass, double dt,
                                           const CollisionOptions& options, std::vector<Vec3>& v) {
  const std::vector<Vec3> before = v;
  return response_->respond({response_->subject(), response_->cloth(), x, before, inverse_mass, dt,
                             options, max_let_out_depth},
                            v);
}

}  // namespace toile
