#include "cloth/judge/worn_garment.h"

#include <algorithm>
#include <limits>

#include "cloth/judge/constants.h"
#include "geometry/border_loops.h"
#include "geometry/triangle_area.h"

namespace toile {

WornGarment::WornGarment(const PanelMesh& meshed, const DressedGarment& worn,
                         const Skeleton& joints, const TriangleMesh* body)
    : garment(meshed),
      dressed(worn),
      skeleton(joints),
      nodes(worn.points),
      placed(worn.points),
      openings(find_openings(meshed, worn, joints)),
      moments(meshed.panels.size()),
      hangs(measure_hangs(meshed, worn, joints)),
      crotch(joints.joint("pelvis").y()),
      waist(joints.joint("waist").y()),
      armpit(joints.joint("chest").y()) {
  if (body != nullptr) measure_passing(openings, *body, skeleton);
  const std::vector<int> component_of_node = connected_components(dressed);
  std::map<int, WornComponent> numbered;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    const Triangle& corners = dressed.triangles[t];
    const int panel = dressed.panel_of_triangle[t];
    for (int i = 0; i < 3; ++i) placed[corners[i]] = garment.placed[garment.triangles[t][i]];
    if (garment.panels[panel].layered) continue;
    numbered[component_of_node[corners[0]]].panels.insert(panel);
    const Vec3& a = nodes[corners[0]];
    const Vec3& b = nodes[corners[1]];
    const Vec3& c = nodes[corners[2]];
    const double area = triangle_area(a, b, c);
    moments[panel].moment += area * (a + b + c) / 3;
    moments[panel].area += area;
  }
  for (const Opening& opening : openings) {
    if (opening.is_cut_out && !opening.limbs.any()) continue;
    numbered[opening.component].openings.push_back(&opening);
  }
  for (auto& [number, component] : numbered) components.push_back(std::move(component));
}

std::vector<int> WornGarment::panels_of(const WornComponent& component, PanelRole wanted) const {
  std::vector<int> panels;
  for (const int p : component.panels) {
    if (kind(p) == wanted) panels.push_back(p);
  }
  return panels;
}

bool WornGarment::has(const WornComponent& component, PanelRole wanted) const {
  return !panels_of(component, wanted).empty();
}

std::vector<int> WornGarment::without_sleeves(const WornComponent& component) const {
  std::vector<int> panels;
  for (const int p : component.panels) {
    if (kind(p) != PanelRole::sleeve) panels.push_back(p);
  }
  return panels;
}

std::vector<char> WornGarment::marked(const std::vector<int>& panels) const {
  std::vector<char> is_marked(garment.panels.size(), 0);
  for (const int p : panels) is_marked[p] = 1;
  return is_marked;
}

double WornGarment::share_around(const std::vector<int>& panels, BodyPart part) const {
  return measure_wrap(dressed, skeleton, part, marked(panels)).fraction;
}

bool WornGarment::closes_around(const std::vector<int>& panels, const LimbsThrough& limbs) const {
  const std::vector<char> is_counted = marked(panels);
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (is_counted[dressed.panel_of_triangle[t]]) triangles.push_back(dressed.triangles[t]);
  }
  for (const std::vector<int>& loop : border_loops(triangles, nodes.size())) {
    std::vector<Vec3> curve;
    curve.reserve(loop.size());
    for (const int node : loop) curve.push_back(nodes[node]);
    if (limbs_through(curve, skeleton) == limbs) return true;
  }
  return false;
}

bool WornGarment::goes_around(const std::vector<int>& panels, BodyPart part,
                              const LimbsThrough& limbs) const {
  if (closes_around(panels, limbs)) return true;
  return share_around(panels, part) >= around_share;
}

std::array<double, 2> WornGarment::heights(const std::vector<Vec3>& places,
                                           const std::set<int>& panels) const {
  std::array<double, 2> found = {std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (!panels.contains(dressed.panel_of_triangle[t])) continue;
    for (const int node : dressed.triangles[t]) {
      found = {std::min(found[0], places[node].y()), std::max(found[1], places[node].y())};
    }
  }
  return found;
}

std::map<BodyPart, std::vector<int>> WornGarment::by_limb(const std::vector<int>& panels,
                                                          BodyPart (*limb_of)(bool)) const {
  std::map<BodyPart, std::vector<int>> groups;
  for (const int p : panels) {
    const PanelClass& is = garment.panels[p].is;
    const bool is_found = is.part.by == PanelSource::seams || is.part.by == PanelSource::asked;
    int side = is_found ? side_of(is.part) : 0;
    if (side == 0) side = side_sign(is);
    if (side == 0) side = placed_side(garment.panels[p]);
    groups[limb_of(side > 0)].push_back(p);
  }
  return groups;
}

int WornGarment::placed_side(const MeshedPanel& panel) const {
  double sum = 0;
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    sum += garment.placed[p].x() - skeleton.joint("pelvis").x();
  }
  return sum >= 0 ? 1 : -1;
}

bool WornGarment::belongs_to(const Opening& opening, const std::vector<int>& panels) {
  const auto count = std::ranges::count_if(
      opening.panels, [&](int p) { return std::ranges::find(panels, p) != panels.end(); });
  return 2 * count > static_cast<std::ptrdiff_t>(opening.panels.size());
}

const Opening* WornGarment::highest_around_trunk(const WornComponent& component) const {
  const Opening* highest = nullptr;
  for (const Opening* opening : component.openings) {
    if (opening->limbs != through_hem) continue;
    if (highest == nullptr || opening->middle.y() > highest->middle.y()) highest = opening;
  }
  return highest;
}

std::optional<Vec3> WornGarment::level_direction(const WornComponent& component,
                                                 int (*sign_of)(const PanelClass&)) const {
  AreaMoment negative;
  AreaMoment positive;
  for (const int p : component.panels) {
    if (kind(p) == PanelRole::sleeve) continue;
    const int sign = sign_of(garment.panels[p].is);
    if (sign < 0) negative.add(moments[p]);
    if (sign > 0) positive.add(moments[p]);
  }
  if (negative.area == 0 || positive.area == 0) return std::nullopt;
  Vec3 across = positive.middle() - negative.middle();
  across.y() = 0;
  if (across.norm() < min_face_distance) return std::nullopt;
  return across.normalized();
}

}  // namespace toile
