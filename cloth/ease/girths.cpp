#include "cloth/ease/girths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/body/bones.h"
#include "geometry/body/torso_section.h"
#include "geometry/body/trunk_levels.h"
#include "geometry/slice.h"

namespace toile {

namespace {

/// Metres: steps in which a girth is looked for below its level, and their count: down to 6.5 cm.
/// Above, the line may run around more than its part. At the crotch of trousers that is both
/// thighs, and where sleeves hang low the arms. The sample trousers' thigh is found 0 to 4 cm down.
constexpr double search_step = 0.005;
constexpr int search_steps = 14;

/// "left thigh" of "left_upper_thigh".
std::string row_name(std::string measure) {
  if (const auto upper = measure.find("upper_thigh"); upper != std::string::npos) {
    measure.erase(upper, 6);
  }
  if (const auto middle = measure.find("mid_"); middle != std::string::npos) {
    measure[middle + 3] = '-';
  }
  std::ranges::replace(measure, '_', ' ');
  return measure;
}

bool is_trunk_girth(const std::string& name) {
  static const std::vector<std::string> names = {"bust", "underbust", "waist", "abdomen", "hip"};
  return std::ranges::find(names, name) != names.end();
}

/// The same limb's name on the other side; empty: it has no side.
std::string other_side(const std::string& name) {
  if (name.starts_with("left ")) return "right " + name.substr(5);
  if (name.starts_with("right ")) return "left " + name.substr(6);
  return "";
}

class GirthTaker {
 public:
  GirthTaker(const DressedGarment& garment, const TriangleMesh& body, const Skeleton& skeleton,
             const GirthOptions& options)
      : garment_(garment),
        cloth_{garment.points, garment.triangles},
        body_(body),
        arms_{Bones(skeleton, BodyPart::left_arm), Bones(skeleton, BodyPart::right_arm)},
        options_(options) {}

  /// The row of a section of the garment.
  Girth row(const std::string& name, const CuttingPlane& plane, double body,
            const Section& section) const {
    Girth girth;
    girth.name = name;
    girth.plane = plane;
    girth.height = plane.origin.y();
    girth.body = body;
    girth.garment = section.length;
    girth.hull = section.girth;
    girth.offset = offset_of(section, plane.normal);
    ClothLine line = line_on_panels(garment_, section.triangles, plane, options_.grains);
    girth.as_cut = line.as_cut;
    girth.on_the_line = line.on_the_line;
    girth.panels = std::move(line.panels);
    girth.triangles = section.triangles;
    return girth;
  }

  /// At a height of the trunk; the bust below it where its line runs around the arms. A reason
  /// where there is none.
  std::pair<std::optional<Girth>, GirthLeftOut> around_trunk(const std::string& name,
                                                             double height) const {
    const std::optional<Section> torso = torso_section(body_, height);
    if (!torso) return {{}, {name, "the body's surface is open there", false, height}};
    bool is_over_arms = false;
    for (int i = 0; i < (name == "bust" ? search_steps : 1); ++i) {
      const CuttingPlane plane{{0, height - search_step * i, 0}, Vec3::UnitY()};
      const std::vector<Section> sections = slice(cloth_, plane.origin, plane.normal);
      const auto around = outermost(sections, torso->centroid, plane.normal);
      if (around != sections.end()) {
        is_over_arms = goes_around_arm(*around, plane.origin.y());
        if (is_over_arms) continue;
        Girth girth = row(name, plane, torso->girth, *around);
        girth.is_of_trunk = true;
        return {std::move(girth), {}};
      }
      if (is_over_arms) break;
      const bool is_open = !sections.empty();
      return {{},
              {name,
               is_open ? "the garment is not closed around the body there"
                       : "the garment does not reach it",
               is_open, height}};
    }
    return {{}, {name, "its line there runs around the arms", false, height}};
  }

  /// Around a limb or the neck, or around both legs. `other` is the same place of the other limb.
  /// `trunk` is a point of the trunk's middle line, for what must not go around that.
  std::optional<Girth> around_limb(const std::string& name, const CuttingPlane& plane,
                                   const std::optional<Vec3>& other,
                                   const std::optional<Vec3>& trunk) const {
    const std::vector<Section> sections = slice(cloth_, plane.origin, plane.normal);
    const auto around = outermost(sections, plane.origin, plane.normal);
    if (around == sections.end()) return std::nullopt;
    const std::vector<Section> skin = slice(body_, plane.origin, plane.normal);
    const auto limb = section_around(skin, plane.origin, plane.normal);
    // A cape or a poncho goes around arm and trunk.
    const double upright = plane.normal.y();
    if (trunk && std::abs(upright) > 0.1) {
      const Vec3 middle = *trunk + Vec3(0, (plane.origin - *trunk).dot(plane.normal) / upright, 0);
      if (contains(*around, middle, plane.normal)) return std::nullopt;
    }
    // Where a limb touches the trunk, its section goes around both, and the cloth's does not.
    if (limb == skin.end() || limb->area > std::abs(around->area)) return std::nullopt;
    if (!other || !contains(*around, *other, plane.normal)) {
      return row(name, plane, limb->girth, *around);
    }
    const auto second = section_around(skin, *other, plane.normal);
    if (second == skin.end()) return std::nullopt;
    std::vector<Vec3> both = limb->points;
    both.insert(both.end(), second->points.begin(), second->points.end());
    Girth girth =
        row(name.substr(name.find(' ') + 1), plane, hull_length(both, plane.normal), *around);
    girth.is_of_both_legs = true;
    return girth;
  }

 private:
  /// Whether an arm passes through a level section, as where sleeves hang as low.
  bool goes_around_arm(const Section& section, double height) const {
    return std::ranges::any_of(arms_, [&](const Bones& arm) {
      for (std::size_t i = 0; i + 1 < arm.joints.size(); ++i) {
        const Vec3& a = arm.joints[i];
        const Vec3& b = arm.joints[i + 1];
        if ((a.y() > height) == (b.y() > height)) continue;
        const Vec3 at = a + (height - a.y()) / (b.y() - a.y()) * (b - a);
        if (contains(section, at, Vec3::UnitY())) return true;
      }
      return false;
    });
  }
  /// The largest section around the point; they are in falling area.
  static std::vector<Section>::const_iterator outermost(const std::vector<Section>& sections,
                                                        const Vec3& point, const Vec3& normal) {
    return std::ranges::find_if(
        sections, [&](const Section& section) { return contains(section, point, normal); });
  }
  /// The smallest section around the point.
  static std::vector<Section>::const_iterator section_around(const std::vector<Section>& sections,
                                                             const Vec3& point,
                                                             const Vec3& normal) {
    auto found = sections.end();
    for (auto at = sections.begin(); at != sections.end(); ++at) {
      if (at->area > 0 && contains(*at, point, normal)) found = at;
    }
    return found;
  }

  /// Where a line moves inward by d, it gets shorter by d times the angle by which it turns.
  double offset_of(const Section& section, const Vec3& normal) const {
    if (options_.skin == nullptr) return 0;
    const std::vector<Vec3>& line = section.points;
    const double inside = section.area < 0 ? -1 : 1;
    double shorter = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec3& at = line[i];
      const SurfacePoint nearest = options_.skin->closest_point(at);
      if (nearest.distance > options_.touching) continue;
      const Vec3 before = at - line[(i + line.size() - 1) % line.size()];
      const Vec3 after = line[(i + 1) % line.size()] - at;
      const double turn = std::atan2(normal.dot(before.cross(after)), before.dot(after));
      const Vec3 way = nearest.point - at;
      const double in_plane = (way - normal.dot(way) * normal).norm();
      // On slanting skin the way within the plane is longer.
      const double moved = way.norm() * std::min(2.0, way.norm() / std::max(in_plane, 1e-9));
      shorter += inside * turn * moved;
    }
    return shorter;
  }

  const DressedGarment& garment_;
  TriangleMesh cloth_;
  const TriangleMesh& body_;
  std::array<Bones, 2> arms_;
  const GirthOptions& options_;
};

}  // namespace

std::vector<int> panels_of(const Girth& girth) {
  std::vector<int> panels;
  panels.reserve(girth.panels.size());
  for (const PanelWidth& width : girth.panels) panels.push_back(width.panel);
  return panels;
}

Girths measure_girths(const DressedGarment& garment, const TriangleMesh& body,
                      const Skeleton& skeleton, const BodyMeasures& measures,
                      const GirthOptions& options) {
  Girths result;
  std::vector<NamedLevel> levels;
  std::vector<BodyGirth> limbs;
  if (!measures.empty()) {
    for (BodyGirth girth : measures.girths) {
      if (is_trunk_girth(girth.name)) levels.push_back({girth.name, girth.origin.y()});
      if (girth.name == "neck" || !other_side(row_name(girth.name)).empty()) {
        girth.name = row_name(girth.name);
        limbs.push_back(std::move(girth));
      }
    }
  } else {
    levels = girth_levels(body, skeleton);
  }
  for (const char* name : {"bust", "waist", "hip"}) {
    if (std::ranges::find(levels, name, &NamedLevel::name) == levels.end()) {
      result.left_out.push_back({name, "the body has none"});
    }
  }
  const double crotch = skeleton.joint("pelvis").y();
  const double armpit = skeleton.joint("chest").y();
  const double step = options.step;
  for (double y = std::ceil(crotch / step) * step; step > 0 && y < armpit; y += step) {
    levels.push_back({"", y});
  }
  for (const double height : options.heights) levels.push_back({"", height});
  std::ranges::stable_sort(levels, std::ranges::greater{}, &NamedLevel::height);

  const GirthTaker taker(garment, body, skeleton, options);
  for (const NamedLevel& level : levels) {
    auto [girth, why_not] = taker.around_trunk(level.name, level.height);
    if (girth) {
      result.rows.push_back(std::move(*girth));
    } else if (level.name == "bust" || level.name == "waist" || level.name == "hip") {
      result.left_out.push_back(std::move(why_not));
    }
  }
  for (const BodyGirth& limb : limbs) {
    const bool is_leg = limb.origin.y() < crotch;
    const auto pair = std::ranges::find(limbs, other_side(limb.name), &BodyGirth::name);
    std::optional<Vec3> trunk;
    if (!is_leg && limb.name != "neck") trunk = skeleton.joint("chest");
    std::optional<Vec3> other;
    if (is_leg && pair != limbs.end()) other = pair->origin;
    std::optional<Girth> girth;
    for (int i = 0; i < (limb.name.ends_with(" thigh") ? search_steps : 1); ++i) {
      const Vec3 down(0, -search_step * i, 0);
      std::optional<Vec3> beside;
      if (other) beside = *other + down;
      std::optional<Girth> found =
          taker.around_limb(limb.name, {limb.origin + down, limb.normal}, beside, trunk);
      if (i == 0) girth = found;
      if (!found || found->name != limb.name) continue;
      girth = std::move(found);
      break;
    }
    if (!girth) continue;
    // A skirt goes around both legs: once is enough.
    const auto is_same = [&](const Girth& row) { return row.name == girth->name; };
    if (std::ranges::none_of(result.rows, is_same)) result.rows.push_back(std::move(*girth));
  }
  return result;
}

}  // namespace toile
