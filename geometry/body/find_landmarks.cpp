#include "geometry/body/find_landmarks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/body/centreline.h"
#include "geometry/body/extreme.h"
#include "geometry/body/limb_landmarks.h"
#include "geometry/body/missing_feet.h"
#include "geometry/body/outline_points.h"
#include "geometry/body/refine_joints.h"
#include "geometry/body/tape.h"
#include "geometry/body/torso_section.h"
#include "geometry/laplacian.h"

namespace toile {

namespace {

// Ratio of the neck's width at the level of C7 to its least width. At 1.4 the level is 5 mm higher
// on average bodies, at 1.6 some 3 mm lower.
constexpr double neck_base_ratio = 1.5;
// The direction in which a breast and a seat's half point: sideways, as a share of forward or
// backward. 11 and 15 degrees. Without it, points on flat chests lie 2 cm nearer to the middle.
constexpr double breast_outward = 0.20;
constexpr double seat_outward = 0.26;
// Share of the height: the smoothing's length. With 1 mm of noise on five bodies, 0.8 % of the
// landmarks move by more than 5 mm. At half of it 1.7 % do, at double 1.5 %, without it 3.3 %.
constexpr double smoothing = 0.003;

/// Metres from the lowest to the highest point of the surface; 0 where there is none.
double height_of(const TriangleMesh& body) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Triangle& t : body.triangles) {
    for (const int i : t) {
      low = std::min(low, body.points[i].y());
      high = std::max(high, body.points[i].y());
    }
  }
  return body.triangles.empty() ? 0 : high - low;
}

class LandmarkFinder {
 public:
  LandmarkFinder(BodyShape& shape, const std::optional<Vec3>& crotch)
      : shape_(shape),
        mesh_(shape.frame.mesh),
        levels_(shape.levels),
        h_(shape.frame.height),
        crotch_(crotch) {}

  void find() {
    if (const std::string why = no_floor(shape_); !why.empty()) {
      absent("floor", why);
    } else {
      add("floor", Vec3(0, 0, 0), 1);
    }
    find_levels();
    if (!shape_.frame.skeleton) {
      for (const char* name : {"crown", "cervicale", "front_neck", "crotch"}) {
        absent(name, no_joints());
      }
      for (const int side : {1, -1}) {
        for (const char* name : {"side_neck", "shoulder", "armpit", "armpit_front", "armpit_back",
                                 "gluteal_fold", "knee", "calf", "ankle", "elbow", "wrist"}) {
          absent(side_prefix(side) + name, no_joints());
        }
      }
      return;
    }
    skeleton_ = &*shape_.frame.skeleton;
    // Without air between the thighs the sections' touch is all there is.
    add("crotch", crotch_.value_or(skeleton_->joint("pelvis")), crotch_ ? 0.8 : 0.4);
    for (const int side : {1, -1}) {
      if (const std::string why = lack_of(side_prefix(side) + "arm"); !why.empty()) {
        for (const char* name :
             {"shoulder", "armpit", "armpit_front", "armpit_back", "elbow", "wrist"}) {
          absent(side_prefix(side) + name, why);
        }
      } else {
        find_armpit_and_shoulder(side);
      }
    }
    if (const std::string why = lack_of("head"); !why.empty()) {
      absent("crown", why);
      no_neck(why);
    } else {
      find_neck();
    }
    find_limb_landmarks(shape_);
  }

 private:
  /// Why the body lacks a part; empty: it is there.
  std::string lack_of(const std::string& part) const {
    const auto found = shape_.frame.missing.find(part);
    return found == shape_.frame.missing.end() ? "" : found->second;
  }

  std::string no_joints() const {
    return "the surface does not show head, arms and legs: " + shape_.frame.no_skeleton;
  }

  void add(const std::string& name, const std::optional<Vec3>& place, double confidence,
           const std::string& reason = "") {
    add_landmark(shape_.landmarks, name, place, confidence, reason);
  }
  void absent(const std::string& name, const std::string& reason) {
    add(name, std::nullopt, 0, reason);
  }

  std::optional<Section> level(double y) const { return torso_section(mesh_, y); }

  void add_level(const std::string& name, const TrunkLevel& level_found, double side) {
    if (!level_found.height) return absent(name, level_found.reason);
    const auto section = level(*level_found.height);
    const auto place = section ? at_x(*section, 0, side) : std::nullopt;
    add(name, place, level_found.confidence, level_found.reason);
  }

  void find_levels() {
    add_level("underbust", levels_.underbust, 1);
    add_level("waist", levels_.waist, 1);
    add_level("waist_back", levels_.waist, -1);
    add_level("abdomen", levels_.abdomen, 1);
    add_level("hip", levels_.hip, -1);
    for (const int side : {1, -1}) {
      find_bust_point(side);
      find_seat_point(side);
      if (!shape_.frame.skeleton) continue;
      add_side("bust_side", levels_.bust, side);
      add_side("waist_side", levels_.waist, side);
      add_side("hip_side", levels_.hip, side);
    }
  }

  void add_side(const std::string& name, const TrunkLevel& found, int side) {
    const auto section = found.height ? level(*found.height) : std::nullopt;
    if (!section) return absent(side_prefix(side) + name, found.reason);
    const double z = side_line(shape_, *found.height);
    std::optional<Vec3> place;
    const std::size_t n = section->points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& a = section->points[i];
      const Vec3& b = section->points[(i + 1) % n];
      if ((a.z() - z) * (b.z() - z) > 0 || a.z() == b.z()) continue;
      const Vec3 p = a + (z - a.z()) / (b.z() - a.z()) * (b - a);
      if (side * p.x() > (place ? side * place->x() : 0)) place = p;
    }
    add(side_prefix(side) + name, place, found.confidence);
  }

  /// The point of one side of the trunk at a level that stands out the most. `facing` is 1 to the
  /// front, -1 to the back; `outward` is the share to its side. Nothing where the middle does.
  std::optional<Vec3> summit(double height, int side, double facing, double outward) const {
    // The mean contour over a centimetre up and down: noise and edges of one section cancel. On a
    // small waist with a wide hip the contour ends sooner.
    std::vector<Vec2> contour;
    for (double x = 0.012 * h_; x < 0.075 * h_; x += 0.0015 * h_) contour.emplace_back(x, 0);
    int levels = 0;
    for (int k = -2; k <= 2; ++k) {
      const auto section = level(height + k * 0.003 * h_);
      if (!section) continue;
      ++levels;
      for (Vec2& sample : contour) {
        const auto p = at_x(*section, side * sample.x(), facing);
        if (!p) return std::nullopt;
        sample.y() += facing * p->z() + outward * sample.x();
      }
    }
    if (levels == 0) return std::nullopt;
    const Extreme most = greatest(contour, 0.015 * h_);
    if (most.is_end) return std::nullopt;
    const auto section = level(height);
    return section ? at_x(*section, side * most.at, facing) : std::nullopt;
  }

  void find_bust_point(int side) {
    const std::string name = side_prefix(side) + "bust_point";
    if (!levels_.bust.height) return absent(name, levels_.bust.reason);
    add(name, summit(*levels_.bust.height, side, 1, breast_outward), levels_.bust.confidence,
        levels_.bust.reason);
    Landmark& added = shape_.landmarks.back();
    if (!added.place) added.reason = "the chest stands out the most in its middle";
  }

  void find_seat_point(int side) {
    const std::string name = side_prefix(side) + "seat_point";
    if (!levels_.hip.height) return absent(name, levels_.hip.reason);
    add(name, summit(*levels_.hip.height, side, -1, seat_outward), levels_.hip.confidence,
        levels_.hip.reason);
    Landmark& added = shape_.landmarks.back();
    if (!added.place) added.reason = "the seat stands out the most in its middle";
  }

  /// The body's outline in its middle plane.
  std::optional<Section> sagittal() const {
    std::vector<Section> sections = slice(mesh_, Vec3::Zero(), Vec3::UnitX());
    if (sections.empty() || !sections.front().closed) return std::nullopt;
    return std::move(sections.front());
  }

  void find_armpit_and_shoulder(int side) {
    const Vec3& joint = skeleton_->joint(side_prefix(side) + "shoulder");
    // The armhole's plane is upright through the crease of the armpit, where the arm leaves the
    // trunk. The joint lies in it.
    const double x = joint.x();
    std::vector<Section> sections = slice(mesh_, Vec3(x, 0, 0), Vec3::UnitX());
    const auto arm = section_at(sections, joint, Vec3::UnitX(), 0, 0.05 * h_);
    if (!arm || arm->points.size() < 8) {
      for (const char* name : {"shoulder", "armpit", "armpit_front", "armpit_back"}) {
        absent(side_prefix(side) + name, "the arm's root has no closed outline");
      }
      return;
    }
    std::vector<Vec3> points;
    const double armpit = skeleton_->joint("chest").y();
    for (const Vec3& p : arm->points) {
      if (p.y() > armpit - 0.02 * h_) points.push_back(p);
    }
    add(side_prefix(side) + "shoulder", top_of(points), 0.8);
    add(side_prefix(side) + "armpit", Vec3(x, armpit, joint.z()), 0.7);
    const double middle = (top_of(points).y() + armpit) / 2;
    std::vector<Vec3> low;
    for (const Vec3& p : points) {
      if (p.y() < middle) low.push_back(p);
    }
    if (low.empty()) low = points;
    add(side_prefix(side) + "armpit_front", corner_of(low, Vec3(0, -1, 1), 0.018 * h_), 0.5);
    add(side_prefix(side) + "armpit_back", corner_of(low, Vec3(0, -1, -1), 0.018 * h_), 0.5);
  }

  /// The top of an outline in an upright plane, by a parabola over what is near it.
  Vec3 top_of(const std::vector<Vec3>& outline) const {
    Vec3 top = farthest(outline, Vec3::UnitY());
    std::vector<Vec2> samples;
    for (const Vec3& p : outline) {
      if (p.y() > top.y() - 0.012 * h_) samples.emplace_back(p.z(), p.y());
    }
    std::stable_sort(samples.begin(), samples.end(),
                     [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    if (samples.size() < 5) return top;
    const Extreme most = greatest(samples, 0.012 * h_);
    return most.is_end ? top : Vec3(top.x(), most.value, most.at);
  }

  struct Neck {
    double y = 0;
    Section section;
    double width = 0;
  };

  void find_neck() {
    add("crown", skeleton_->joint("head"), 0.9);
    const double base_joint = skeleton_->joint("neck").y();
    std::vector<Neck> neck;  // from the thinnest level down
    const double step = 0.002 * h_;
    std::vector<Neck> all;
    for (double y = base_joint + 0.05 * h_; y > base_joint - 0.05 * h_; y -= step) {
      auto section = level(y);
      if (!section) continue;
      const double width = width_of(*section);
      all.push_back({y, std::move(*section), width});
    }
    if (all.size() < 10) return no_neck("the neck has no closed outline");
    // Widths as they are above the base: a chin is not wider. The thinnest level is a matter of
    // noise, its neighbourhood is not.
    std::vector<Vec2> widths;
    for (std::size_t i = all.size(); i-- > 0;) {
      if (all[i].y > base_joint - step) widths.emplace_back(all[i].y, -all[i].width);
    }
    if (widths.empty()) return no_neck("the neck has no closed outline");
    const double thin = greatest(widths, 0.012 * h_).at;
    const auto from = std::find_if(all.begin(), all.end(),
                                   [&](const Neck& some) { return some.y < thin + step / 2; });
    neck.assign(from, all.end());
    const double wanted = neck_base_ratio * neck.front().width;
    std::size_t below = 1;
    while (below < neck.size() && neck[below].width < wanted) ++below;
    if (below == neck.size()) return no_neck("the neck does not widen to the shoulders");
    const Neck& above = neck[below - 1];
    const double t = (wanted - above.width) / (neck[below].width - above.width);
    const double base = above.y + t * (neck[below].y - above.y);
    const auto section = level(base);
    add("cervicale", section ? at_x(*section, 0, -1) : std::nullopt, 0.7);
    for (const int side : {1, -1}) find_side_neck(side, neck);
    find_front_neck(thin, base);
  }

  void no_neck(const std::string& reason) {
    for (const char* name : {"cervicale", "left_side_neck", "right_side_neck", "front_neck"}) {
      absent(name, reason);
    }
  }

  /// Where the outline from neck to shoulder turns the most, seen from the front. It is farthest
  /// there from the straight line between the thinnest neck and the shoulder.
  void find_side_neck(int side, const std::vector<Neck>& neck) {
    const std::string name = side_prefix(side) + "side_neck";
    const auto shoulder = place_of(shape_.landmarks, side_prefix(side) + "shoulder");
    if (!shoulder) return absent(name, "the shoulder is not found");
    std::vector<Vec3> outline;
    for (const Neck& level_of_neck : neck) {
      const Vec3 outer = farthest(level_of_neck.section.points, side * Vec3::UnitX());
      if (side * outer.x() > side * shoulder->x() || level_of_neck.y < shoulder->y()) break;
      outline.emplace_back(outer.x(), level_of_neck.y, 0);
    }
    outline.emplace_back(shoulder->x(), shoulder->y(), 0);
    if (outline.size() < 5) return absent(name, "the neck does not meet a shoulder");
    const std::optional<Vec3> hollow = bulge(outline, Vec3(-side, -1, 0), 0.2);
    if (!hollow) return absent(name, "the neck does not turn into the shoulder");
    const Vec3& turn = *hollow;
    // Along the ridge from neck to shoulder the point lies where a plane square to the ridge stands
    // out the most.
    const Vec3 along = (outline.back() - outline.front()).normalized();
    const Vec3 out(-side * along.y(), side * along.x(), 0);
    std::vector<Vec2> ridge;
    for (const Section& section : slice(mesh_, turn, along)) {
      for (const Vec3& p : section.points) {
        const double off = out.dot(p - turn);
        if (std::abs(off) < 0.008 * h_ && p.y() > shoulder->y()) ridge.emplace_back(p.z(), off);
      }
    }
    std::stable_sort(ridge.begin(), ridge.end(),
                     [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    if (ridge.size() < 5) return absent(name, "the neck has no closed outline");
    const Extreme most = greatest(ridge, 0.012 * h_);
    Vec3 place = turn + most.value * out;
    place.z() = most.at;
    add(name, place, 0.7);
  }

  /// The hollow of the front's outline between throat and chest.
  void find_front_neck(double thin, double base) {
    const auto outline = sagittal();
    const double low = base - 0.075 * h_;
    if (!outline) return absent("front_neck", "the body has no closed outline from the side");
    const auto upper = level(thin);
    const auto lower = level(low);
    const auto from = upper ? at_x(*upper, 0, 1) : std::nullopt;
    const auto to = lower ? at_x(*lower, 0, 1) : std::nullopt;
    if (!from || !to) return absent("front_neck", "the throat has no closed outline");
    const std::vector<Vec3> curve = part_between(*outline, *from, *to, Vec3::UnitZ());
    if (curve.size() < 5) return absent("front_neck", "the throat has no outline from the side");
    const std::optional<Vec3> hollow = bulge(curve, -Vec3::UnitZ(), 0.2);
    if (!hollow) return absent("front_neck", "the throat has no hollow");
    add("front_neck", hollow, 0.6);
  }

  BodyShape& shape_;
  const TriangleMesh& mesh_;
  const TrunkLevels& levels_;
  double h_;
  std::optional<Vec3> crotch_;
  const Skeleton* skeleton_ = nullptr;
};

}  // namespace

std::string no_floor(const BodyShape& shape) {
  const std::map<std::string, std::string>& missing = shape.frame.missing;
  const bool is_cut = missing.contains("left_foot") && missing.contains("right_foot");
  return is_cut ? "both legs end before their feet" : "";
}

double side_line(const BodyShape& shape, double y) {
  const Vec3& chest = shape.frame.skeleton->joint("chest");
  const Vec3& pelvis = shape.frame.skeleton->joint("pelvis");
  return pelvis.z() + (y - pelvis.y()) / (chest.y() - pelvis.y()) * (chest.z() - pelvis.z());
}

BodyShape find_landmarks(const TriangleMesh& body, const std::string& name) {
  BodyShape shape;
  shape.frame = body_frame(body, smoothed(body, smoothing * height_of(body)), name);
  std::optional<Vec3> crotch;
  if (shape.frame.skeleton) {
    crotch = refine_joints(shape.frame);
    for (const std::string& side : missing_feet(shape.frame.mesh, *shape.frame.skeleton)) {
      shape.frame.missing[side + "_foot"] = "the " + side + " leg ends before a foot";
    }
  }
  shape.levels = facing_trunk_levels(shape.frame);
  LandmarkFinder(shape, crotch).find();
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    shape.frame.mesh.points[i] = shape.frame.rotation * body.points[i] + shape.frame.translation;
  }
  return shape;
}

Landmarks given_landmarks(const BodyShape& shape) {
  Landmarks landmarks = shape.landmarks;
  for (Landmark& landmark : landmarks) {
    if (landmark.place) landmark.place = shape.frame.given(*landmark.place);
  }
  return landmarks;
}

}  // namespace toile
