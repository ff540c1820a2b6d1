#include "cloth/start/placement_warnings.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "cloth/scene/collider.h"
#include "cloth/start/constants.h"
#include "geometry/body/skeleton.h"
#include "geometry/disjoint_sets.h"
#include "geometry/surface_distance.h"
#include "geometry/triangle_area.h"

namespace toile {

namespace {

/// Panels on one side of the body that are sewn together.
struct Group {
  std::vector<int> panels;
  double area = 0;
};

class PanelSides {
 public:
  PanelSides(const PanelMesh& garment, double middle)
      : garment_(garment),
        at_(garment.placed),
        panel_of_(panel_of_points(garment)),
        side_(garment.panels.size(), 0) {
    for (Vec3& p : at_) p.x() -= middle;
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      boxes_.push_back(box_of(garment.panels[p]));
      side_[p] = side_of(boxes_.back());
    }
  }

  /// Panels that stand where their mirror images belong, in the garment's order. After the call
  /// they count as exchanged.
  std::vector<int> exchange_swapped() {
    std::vector<int> found;
    for (const Group& group : groups()) {
      if (!seams_of(group).to_images.is_much_shorter_there()) continue;
      found.insert(found.end(), group.panels.begin(), group.panels.end());
    }
    for (const int p : found) carry_across(p);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Panels that belong on the other side, in the garment's order.
  std::vector<int> misplaced() {
    std::vector<int> found;
    for (const Group& group : groups()) {
      if (!belongs_across(seams_of(group).to_others)) continue;
      found.insert(found.end(), group.panels.begin(), group.panels.end());
      // Panels that are sewn to the group are judged by where the group should be.
      for (const int p : group.panels) mirror(p);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  Eigen::AlignedBox3d box_of(const MeshedPanel& panel) const {
    Eigen::AlignedBox3d box;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) box.extend(at_[p]);
    return box;
  }

  /// 1: left of the middle, -1: right, 0: on both sides.
  static int side_of(const Eigen::AlignedBox3d& box) {
    const double off = box.center().x() / (0.5 * box.sizes().x());
    return off > one_side_offset ? 1 : off < -one_side_offset ? -1 : 0;
  }

  bool are_images(int a, int b) const {
    Vec3 mirrored = boxes_[a].center();
    mirrored.x() = -mirrored.x();
    const double tolerance = image_tolerance * boxes_[b].diagonal().norm();
    return (mirrored - boxes_[b].center()).norm() < tolerance &&
           (boxes_[a].sizes() - boxes_[b].sizes()).norm() < tolerance;
  }

  /// The groups, the smallest first.
  std::vector<Group> groups() const {
    DisjointSets sets(garment_.panels.size());
    for (const MeshedSeam& seam : garment_.seams) {
      const int a = panel_of_[seam.a.front()];
      const int b = panel_of_[seam.b.front()];
      if (side_[a] != 0 && side_[a] == side_[b]) sets.join(a, b);
    }
    std::vector<Group> by_first(garment_.panels.size());
    for (std::size_t p = 0; p < garment_.panels.size(); ++p) {
      if (side_[p] == 0) continue;
      Group& group = by_first[sets.of(static_cast<int>(p))];
      group.panels.push_back(static_cast<int>(p));
      const MeshedPanel& panel = garment_.panels[p];
      for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
        const auto& [a, b, c] = garment_.triangles[t];
        group.area += triangle_area(at_[a], at_[b], at_[c]);
      }
    }
    std::erase_if(by_first, [](const Group& group) { return group.panels.empty(); });
    std::ranges::stable_sort(by_first, {}, &Group::area);
    return by_first;
  }

  /// The seams of a group to other panels: pairs of points, and the metres between them.
  struct SeamLengths {
    int pairs = 0;
    int across = 0;    ///< pairs on both sides of the body's middle
    double here = 0;   ///< metres, the sum over all pairs
    double there = 0;  ///< metres, the same with the group on the other side

    bool is_much_shorter_there() const {
      return there < much_shorter * here && there < here - min_seam_gain * pairs;
    }
  };
  struct GroupSeams {
    SeamLengths to_images;  ///< to mirror images of its panels, with these moved across as well
    SeamLengths to_others;  ///< to all other panels
  };

  GroupSeams seams_of(const Group& group) const {
    std::vector<char> mine(garment_.panels.size(), 0);
    for (const int p : group.panels) mine[p] = 1;
    GroupSeams seams;
    for (const MeshedSeam& seam : garment_.seams) {
      int panel = panel_of_[seam.a.front()];
      int other = panel_of_[seam.b.front()];
      if (mine[panel] == mine[other]) continue;
      const bool from_a = mine[panel] != 0;
      if (!from_a) std::swap(panel, other);
      const bool images = are_images(panel, other);
      SeamLengths& lengths = images ? seams.to_images : seams.to_others;
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        const Vec3& p = at_[from_a ? seam.a[i] : seam.b[i]];
        const Vec3& q = at_[from_a ? seam.b[i] : seam.a[i]];
        ++lengths.pairs;
        lengths.across += (p.x() > 0) != (q.x() > 0);
        lengths.here += (q - p).norm();
        lengths.there += images ? (carried_across(q, other) - carried_across(p, panel)).norm()
                                : (q - Vec3(-p.x(), p.y(), p.z())).norm();
      }
    }
    return seams;
  }

  static bool belongs_across(const SeamLengths& lengths) {
    return lengths.across > max_seams_across * lengths.pairs && lengths.is_much_shorter_there();
  }

  /// A panel's point when the panel is moved across the middle without being turned. So the outer
  /// edges of legs that change places become inner ones.
  Vec3 carried_across(const Vec3& p, int panel) const {
    return {p.x() - 2 * boxes_[panel].center().x(), p.y(), p.z()};
  }

  void carry_across(int panel) {
    const MeshedPanel& moved = garment_.panels[panel];
    for (int p = moved.first_point; p < moved.first_point + moved.points; ++p) {
      at_[p] = carried_across(at_[p], panel);
    }
    boxes_[panel] = box_of(moved);
    side_[panel] = side_of(boxes_[panel]);
  }

  void mirror(int panel) {
    const MeshedPanel& moved = garment_.panels[panel];
    for (int p = moved.first_point; p < moved.first_point + moved.points; ++p) {
      at_[p].x() = -at_[p].x();
    }
    boxes_[panel] = box_of(moved);
  }

  const PanelMesh& garment_;
  std::vector<Vec3> at_;       // x from the body's middle
  std::vector<int> panel_of_;  // per material point
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<int> side_;
};

}  // namespace

std::vector<double> facing_out(const PanelMesh& garment, const SurfaceDistance& skin) {
  std::vector<double> facing;
  for (const MeshedPanel& panel : garment.panels) {
    const int stride = std::max(1, panel.triangles / facing_samples);
    double sum = 0;
    double areas = 0;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; t += stride) {
      const auto& [a, b, c] = garment.triangles[t];
      const Vec3& p = garment.placed[a];
      const Vec3 area = (garment.placed[b] - p).cross(garment.placed[c] - p);
      const Vec3 middle = (p + garment.placed[b] + garment.placed[c]) / 3;
      const SurfacePoint nearest = skin.closest_point(middle);
      const Vec3 out =
          nearest.distance < 0 ? Vec3(nearest.point - middle) : Vec3(middle - nearest.point);
      if (out.norm() > 0) sum += area.dot(out.normalized());
      areas += area.norm();
    }
    facing.push_back(areas > 0 ? sum / areas : 0);
  }
  return facing;
}

std::vector<PlacementWarning> placement_warnings(const PanelMesh& garment, const Scene& scene) {
  using Kind = PlacementWarning::Kind;
  std::vector<PlacementWarning> warnings;
  const double middle = scene.skeleton != nullptr ? scene.skeleton->joint("pelvis").x() : 0;
  PanelSides sides(garment, middle);
  for (const int p : sides.exchange_swapped()) {
    warnings.push_back({garment.panels[p].name, Kind::swapped});
  }
  for (const int p : sides.misplaced()) {
    warnings.push_back({garment.panels[p].name, Kind::other_side});
  }
  if (scene.collider == nullptr) return warnings;
  const std::vector<double> facing = facing_out(garment, scene.collider->skin());
  for (std::size_t p = 0; p < facing.size(); ++p) {
    if (facing[p] < inside_out_facing)
      warnings.push_back({garment.panels[p].name, Kind::inside_out});
  }
  return warnings;
}

std::string code_of(PlacementWarning::Kind kind) {
  switch (kind) {
    case PlacementWarning::Kind::swapped:
      return "swapped";
    case PlacementWarning::Kind::other_side:
      return "other_side";
    case PlacementWarning::Kind::inside_out:
      return "inside_out";
  }
  return "";
}

std::string text_of(const PlacementWarning& warning) {
  const std::string panel = "panel '" + warning.panel + "' ";
  if (warning.kind == PlacementWarning::Kind::other_side) {
    return panel +
           "stands on the other side of the body from what it is sewn to: move it across (the sign "
           "of its translation's x, or the part of its 'placement'), or sew it to the other side";
  }
  if (warning.kind == PlacementWarning::Kind::swapped) {
    return panel +
           "stands where its mirror image, which it is sewn to, belongs: let the two change places";
  }
  return panel +
         "starts inside out, its right side to the body: turn it around (by 180 degrees in its "
         "rotation), move it to the body's other side (the sign of its translation's z), or check "
         "the stitches' 'reversed'";
}

}  // namespace toile
