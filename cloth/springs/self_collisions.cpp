#include "cloth/springs/self_collisions.h"

#include <algorithm>

#include "cloth/springs/constants.h"

namespace toile {

namespace {

std::vector<double> shortest_edges(const GarmentModel& model) {
  std::vector<double> shortest;
  for (const int node : model.node_of_point) shortest.push_back(model.shortest_edge[node]);
  return shortest;
}

}  // namespace

SelfCollisions::SelfCollisions(const GarmentModel& model, double gap)
    : proximity_(model.triangles, model.node_of_point, shortest_edges(model)),
      gap_(gap),
      radius_(gap + self_search_distance) {}

void SelfCollisions::leave_out_neighbours(bool leave_out) {
  leave_out_ = leave_out;
  searched_.clear();
}

void SelfCollisions::search(const std::vector<Vec3>& x) {
  proximity_.find(x, radius_, gap_, pairs_, bound_, leave_out_);
  searched_ = x;
  since_search_ = 0;
  ++searches_;
}

void SelfCollisions::respond(const std::vector<Vec3>& x, const std::vector<int>& node,
                             const std::vector<double>& inverse_mass, double dt,
                             std::vector<Vec3>& v) {
  if (searched_.empty()) search(x);
  for (int sweep = 0; sweep < self_sweeps; ++sweep) {
    for (const ContactPair& pair : pairs_) {
      const NearestPoints nearest = nearest_points(pair, x);
      const double distance = nearest.apart.norm();
      if (distance >= radius_ || distance < 1e-9) continue;
      const Vec3 normal = nearest.apart / distance;
      double speed = 0;
      double mobility = 0;  // of the pair, 1/kg
      for (int i = 0; i < 4; ++i) {
        const int n = node[pair.vertices[i]];
        speed += nearest.weights[i] * v[n].dot(normal);
        mobility += nearest.weights[i] * nearest.weights[i] * inverse_mass[n];
      }
      const double room = distance - pair.gap;
      const double min_speed = room > 0 ? -room / dt : -room / let_out_seconds;
      if (speed >= min_speed || mobility <= 0) continue;
      const double impulse = (min_speed - speed) / mobility;
      for (int i = 0; i < 4; ++i) {
        const int n = node[pair.vertices[i]];
        v[n] += nearest.weights[i] * inverse_mass[n] * impulse * normal;
      }
    }
  }
}

void SelfCollisions::bound(const std::vector<Vec3>& x, const std::vector<int>& node, double dt,
                           std::vector<Vec3>& v) {
  ++since_search_;
  const auto exceeds = [&](std::size_t p) {
    return (x[p] + dt * v[node[p]] - searched_[p]).squaredNorm() > bound_[p] * bound_[p];
  };
  bool due = false;
  for (std::size_t p = 0; p < x.size() && !due; ++p) due = exceeds(p);
  if (!due) return;
  if (since_search_ >= self_search_interval) search(x);
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (!exceeds(p)) continue;
    const Vec3 away = x[p] + dt * v[node[p]] - searched_[p];
    v[node[p]] = (searched_[p] + away * (bound_[p] / away.norm()) - x[p]) / dt;
  }
}

}  // namespace toile
