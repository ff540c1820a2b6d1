#include "cloth/springs/contact_detection.h"

#include <Eigen/Geometry>
#include <optional>

#include "cloth/springs/constants.h"
#include "cloth/springs/incident_rays.h"
#include "geometry/closest_points.h"

namespace toile {

namespace {

/// The speed that the paper's response asks for when the approach is fast enough to bounce. A point
/// that does not bounce may first go the rest of the way to the gap.
double bounced(const CollisionStep& step, double least, double speed_before) {
  if (step.options.restitution > 0 && speed_before < least &&
      speed_before < -step.options.slowest_bounce) {
    return std::max(least, -step.options.restitution * speed_before);
  }
  return least;
}

/// Metres along a ray within which it announces a collision.
double announced_within(const CollisionStep& step, double tolerance, const Vec3& velocity) {
  return std::max(tolerance, velocity.norm() * step.dt);
}

Vec3 at(const std::array<Vec3, 3>& corners, const Vec3& w) {
  return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
}

}  // namespace

double min_speed(const CollisionStep& step, double distance, double gap) {
  if (distance > gap) return (gap - distance) / step.dt;
  return std::min((gap - distance) / (let_out_steps * step.dt), step.options.let_out_speed);
}

double NodeContacts::solve(double friction, std::vector<Vec3>& v) {
  if (count == 0) return 0;
  double change = contacts[0].solve(friction, v);
  for (int sweep = 0; sweep < node_sweeps && count > 1; ++sweep) {
    double last = 0;
    for (int i = 0; i < count; ++i) last = std::max(last, contacts[i].solve(friction, v));
    change = std::max(change, last);
    if (last < min_node_change) break;
  }
  return change;
}

NodeContacts node_contacts(const CollisionStep& step, int t, int corner, const NearTriangle& near,
                           double moved, double reach, double& clear) {
  struct Found {
    SubjectNearest nearest;
    int facet;
  };
  const int node = step.cloth[t].nodes[corner];
  const Vec3& x = step.x[node];
  const Vec3& before = step.before[node];
  const double tolerance = step.options.tolerance;
  const double within = announced_within(step, tolerance, before);

  NodeContacts all;
  std::array<Found, 8> found;
  std::size_t count = 0;
  std::optional<Found> closest;
  std::array<std::pair<int, double>, 4> hits;  // facets that the ray meets, and their least speed
  std::size_t hit_count = 0;
  double limit = near.behind ? std::max(reach, step.behind_depth) : reach;
  for (const Candidate& candidate : near.facets) {
    if (candidate.distance - moved > limit) break;
    if (candidate.own != corner) continue;
    const int facet = candidate.subject;
    const SubjectNearest nearest = step.subject.nearest(x, facet);
    const double distance = std::abs(nearest.distance);
    if (!closest || distance < std::abs(closest->nearest.distance)) closest = {nearest, facet};
    if (distance <= reach && nearest.distance >= 0) {
      const bool known = std::any_of(found.begin(), found.begin() + count, [&](const Found& f) {
        return (f.nearest.point - nearest.point).squaredNorm() <
               same_contact_distance * same_contact_distance;
      });
      if (nearest.local && !known && count < found.size()) found[count++] = {nearest, facet};
      const Vec3& normal = step.subject.facet_normal(facet);
      const double speed = before.dot(normal);
      if (speed < 0 && distance <= within && hit_count < hits.size()) {
        const Triangle& c = step.subject.mesh().triangles[facet];
        const double height = normal.dot(x - step.subject.point(c[0]));
        if (height >= 0 && height <= -speed / before.norm() * within) {
          if (const auto ray = particle_ray(x, before, step.subject.point(c[0]),
                                            step.subject.point(c[1]), step.subject.point(c[2]));
              ray && *ray <= within) {
            hits[hit_count++] = {facet, min_speed(step, std::max(height, tolerance), tolerance)};
          }
        }
      }
    }
  }
  if (!closest) return all;
  const auto add = [&](const Vec3& normal, double least) {
    if (all.count == 4) return;
    Contact<1>& contact = all.contacts[all.count++];
    contact = {.nodes = {node},
               .weights = {1},
               .inverse_mass = {step.inverse_mass[node]},
               .normal = normal};
    contact.least = bounced(step, least, normal.dot(before));
  };
  const SubjectNearest& first = closest->nearest;
  if (first.distance < 0) {
    if (first.distance >= -step.behind_depth) {
      add(first.direction, min_speed(step, first.distance, tolerance));
    }
    return all;
  }
  clear = std::min(clear, first.distance);
  if (first.distance <= reach) add(first.direction, min_speed(step, first.distance, tolerance));
  for (std::size_t i = 0; i < count; ++i) {
    const SubjectNearest& other = found[i].nearest;
    if ((other.point - first.point).squaredNorm() < same_contact_distance * same_contact_distance)
      continue;
    add(other.direction, min_speed(step, other.distance, tolerance));
  }
  for (std::size_t i = 0; i < hit_count; ++i) {
    const bool known = closest->facet == hits[i].first ||
                       std::any_of(found.begin(), found.begin() + count,
                                   [&](const Found& f) { return f.facet == hits[i].first; });
    if (!known) add(step.subject.facet_normal(hits[i].first), hits[i].second);
  }
  return all;
}

namespace {

void edge_contact(const CollisionStep& step, int t, int side, const SubjectEdge& edge,
                  const std::vector<Vec3>& v, double slack, PairContacts& all, double& clear) {
  const Triangle& corners = step.cloth[t].nodes;
  const std::array<int, 2> nodes = {corners[side], corners[(side + 1) % 3]};
  const Vec3& p1 = step.x[nodes[0]];
  const Vec3& p2 = step.x[nodes[1]];
  const Vec3& q1 = step.subject.point(edge.a);
  const Vec3& q2 = step.subject.point(edge.b);
  // Of the two lines; what is nearest at an end is a node's or a vertex's own affair.
  const Vec3 p = p2 - p1;
  const Vec3 q = q2 - q1;
  const Vec3 r = p1 - q1;
  const double pp = p.squaredNorm();
  const double qq = q.squaredNorm();
  const double pq = p.dot(q);
  const double crossing = pp * qq - pq * pq;  // of the lengths, times the sine, squared
  const double pr = p.dot(r);
  const double qr = q.dot(r);
  const double along_p = pq * qr - pr * qq;
  const double along_q = pp * qr - pq * pr;
  if (!(along_p > 0 && along_p < crossing && along_q > 0 && along_q < crossing) ||
      crossing <= parallel_edges_sine * parallel_edges_sine * pp * qq) {
    return;
  }
  const double s = along_p / crossing;
  const double u = along_q / crossing;
  const Vec3 away = r + s * p - u * q;
  const double distance = away.norm();
  const bool in_front = edge.rim || away.dot(edge.normal) >= 0;
  if (in_front) clear = std::min(clear, distance);
  const Vec3 square = p.cross(q) / std::sqrt(crossing);
  Contact<2> contact{.nodes = nodes,
                     .weights = {1 - s, s},
                     .inverse_mass = {step.inverse_mass[nodes[0]], step.inverse_mass[nodes[1]]},
                     .normal = square};
  const double gap = step.options.edge_tolerance;
  double height = distance;
  if (in_front && distance > touching) {
    contact.normal = away / distance;
    if (!step.subject.faces(edge, contact.normal)) return;
  } else {
    if (square.dot(edge.normal) < 0) contact.normal = -square;
    if (!in_front) {
      // Behind the edge: a point that really goes through the surface there is let out. A point in
      // front of the other side of something thin is not.
      if (distance > gap) return;
      const auto pierces = [&](int facet) {
        const Triangle& c = step.subject.mesh().triangles[facet];
        const auto ray = particle_ray(p1, p, step.subject.point(c[0]), step.subject.point(c[1]),
                                      step.subject.point(c[2]));
        return ray && *ray <= p.norm();
      };
      if (!pierces(edge.facets[0]) && !pierces(edge.facets[1])) return;
      height = -distance;
    }
  }
  const double least = min_speed(step, height, gap);
  contact.least = least;
  if (contact.approach(v) <= slack) return;

  // Both ends held: nothing to move. One held: the edge turns about it, and goes its way.
  const double m1 = contact.inverse_mass[1];
  const double m2 = contact.inverse_mass[0];
  if (m1 + m2 <= 0) return;
  if (in_front) {
    const Vec3 v_g = (m1 * step.before[nodes[0]] + m2 * step.before[nodes[1]]) / (m1 + m2);
    const auto hit = edge_sweep(p1, p2, v_g, q1, q2);
    if (hit && hit->distance <= announced_within(step, gap, v_g)) {
      const Vec3 against = square.dot(v_g) > 0 ? Vec3(-square) : square;
      if (against.dot(contact.normal) > 0) {
        const Contact<2> nearest = contact;
        contact.weights = {1 - hit->w1, hit->w1};
        contact.normal = against;
        if (contact.approach(v) <= slack) contact = nearest;
      }
    }
  }
  contact.least = bounced(step, least, contact.normal.dot(contact.velocity(step.before)));
  all.edges.push_back(contact);
}

void vertex_contact(const CollisionStep& step, int t, int vertex, const std::vector<Vec3>& v,
                    double slack, PairContacts& all, double& clear) {
  const ClothTriangle& own = step.cloth[t];
  const std::array<Vec3, 3> p = {step.x[own.nodes[0]], step.x[own.nodes[1]], step.x[own.nodes[2]]};
  const Vec3& q = step.subject.point(vertex);
  const Vec3& normal = step.subject.vertex_normal(vertex);
  const Vec3 w = closest_on_triangle(q, p[0], p[1], p[2]);
  if (!w.allFinite()) return;  // a triangle without area: its edges are looked after
  const Vec3 nearest = at(p, w);
  const Vec3 away = nearest - q;
  const double distance = away.norm();
  const bool in_front = step.subject.on_rim(vertex) || away.dot(normal) >= 0;
  if (in_front) clear = std::min(clear, distance);
  if (w.maxCoeff() >= 1) return;  // a node's own affair
  for (int i = 0; i < 3; ++i) {
    if (w[(i + 2) % 3] != 0) continue;
    if (!own.owns_side[i]) return;
    if (own.across[i] < 0) continue;
    const Vec3 along = (p[(i + 1) % 3] - p[i]).normalized();
    const Vec3 over = step.x[own.across[i]] - p[i];
    if (away.dot(over - over.dot(along) * along) < 0) return;  // nearer to the triangle beyond
  }
  Contact<3> contact{
      .nodes = own.nodes,
      .weights = {w[0], w[1], w[2]},
      .inverse_mass = {step.inverse_mass[own.nodes[0]], step.inverse_mass[own.nodes[1]],
                       step.inverse_mass[own.nodes[2]]},
      .normal = normal};
  const double gap = step.options.edge_tolerance;
  double height = distance;
  if (in_front && distance > touching) {
    contact.normal = away / distance;
    if (!step.subject.faces(vertex, contact.normal)) return;
  } else if (!in_front) {
    if (distance > gap) return;
    bool pierced = false;
    for (const int other : step.subject.neighbours(vertex)) {
      const Vec3 along = step.subject.point(other) - q;
      const auto ray = particle_ray(q, along, p[0], p[1], p[2]);
      pierced = pierced || (ray && *ray <= along.norm());
    }
    if (!pierced) return;
    height = -distance;
  }
  const double least = min_speed(step, height, gap);
  contact.least = least;
  if (contact.approach(v) <= slack || inverse_mass_at(contact.weights, contact.inverse_mass) <= 0) {
    return;
  }
  if (in_front) {
    const Vec3 v_g =
        (step.before[own.nodes[0]] + step.before[own.nodes[1]] + step.before[own.nodes[2]]) / 3;
    const auto hit = vertex_ray(q, v_g, p[0], p[1], p[2]);
    if (hit && hit->distance <= announced_within(step, gap, v_g)) {
      const Contact<3> by_distance = contact;
      contact.weights = hit->weights;
      contact.normal = normal;
      if (contact.approach(v) <= slack) contact = by_distance;
    }
  }
  contact.least = bounced(step, least, contact.normal.dot(contact.velocity(step.before)));
  all.vertices.push_back(contact);
}

}  // namespace

void pair_contacts(const CollisionStep& step, int t, const NearTriangle& near, double moved,
                   double reach, const std::vector<Vec3>& v, double slack, PairContacts& found,
                   double& clear) {
  for (const Candidate& candidate : near.edges) {
    if (candidate.distance - moved > reach) break;
    edge_contact(step, t, candidate.own, step.subject.edge(candidate.subject), v, slack, found,
                 clear);
  }
  for (const Candidate& candidate : near.vertices) {
    if (candidate.distance - moved > reach) break;
    vertex_contact(step, t, candidate.subject, v, slack, found, clear);
  }
}

}  // namespace toile
