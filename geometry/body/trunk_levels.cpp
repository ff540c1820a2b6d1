#include "geometry/body/trunk_levels.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/body/extreme.h"
#include "geometry/body/torso_section.h"
#include "geometry/parallel.h"
#include "geometry/slice.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

// Share of the height: 5 mm at 1.70 m. At half or double of it no level moves by 1 mm.
constexpr double step_share = 0.003;
// Share of the height, 20 mm at 1.70 m: the parabolas' reach. At half of it, noise of 1 mm moves
// the seat by 6 mm; at double, the bust of a child joins the belly.
constexpr double reach_share = 0.012;
// Girth at the lower edge of the waist's hollow, as a share above the least. A tape slides down to
// there. It is 5 mm below the least girth on an average body. At half of it the waists of five
// bodies are 1.6 mm higher, at double 2.3 mm lower.
constexpr double hollow_edge = 0.0005;
// Share of the way from crotch to armpits at which the waist is where no hollow shows it: the mean
// of what is seen. Five bodies all have a hollow, so half or double of it changes none.
constexpr double waist_share = 0.64;
// Share of the trunk's lean that a bust's direction has. At 0 an average woman's bust is 6 mm lower
// and its girth 6 mm less. At 1 an average man's is 2 mm higher and 1 mm more.
constexpr double bust_lean = 0.85;
// Of a form: bend of the front at the bust, times the height, below which the chest is nearly flat.
// At half or double no form of the tests changes.
constexpr double flat_bend = 4;
// Share of the way from waist to neck at which a flat chest has its level. It is 0.37 to 0.45 of
// five bodies, 0.43 of a man. At half of it that is the belly, at double the neck.
constexpr double bust_share = 0.43;
// Bend of the front there, times the height: up to the first proportion alone places the level,
// from the second on what is seen. It is 8 of a child, 15 of a man, 19 to 22 of women. At half of
// both, 1 mm of noise moves a child's bust by 29 mm. At double a woman's bust is 10 mm larger.
constexpr double flat_front = 10;
constexpr double full_front = 15;
// Share of the height from the bust points down to the underbust, where no crease is lower. At half
// of it an average man's is 35 mm higher; at double two bodies of five have none above the waist.
constexpr double underbust_share = 0.044;
// Share of the way from waist to hip at which the abdomen is where none stands out. Five bodies
// that show one have 0.1 to 0.47, 0.26 in the mean. At half of it a young woman's girth there is 5
// cm less, at double 13 cm more.
constexpr double abdomen_share = 0.3;
// Share of the way from waist to bust below which no underbust is looked for. Below a bust that
// hangs to the waist it is there. At half of it none of 38 low and firm busts moves, at double an
// average woman's underbust is 9 mm higher.
constexpr double least_band = 0.25;
// Share of the height, 7 cm at 1.70 m: what is fullest so far above where the seat stands out the
// most is no hip. At half or double the hips of five bodies stay. Without it a man whose belly is
// 143 cm around has his hip there, 7 cm too high.
constexpr double seat_reach = 0.04;
// Depth of the crease, as a share of the height: up to the first it does not count, from the second
// on it does. Depths are 0.005 to 0.01 on average adults, 0.001 with as much noise on a child. At
// half or double of either, no underbust of five bodies moves.
constexpr double no_crease = 0.002;
constexpr double a_crease = 0.004;
// A body without joints. Share of what a level cuts that the trunk has: arms beside it have less.
// At half of it the forms of the tests keep their levels; double is beyond the whole.
constexpr double form_share = 0.7;
// Its waist, as a share of its fuller girths: 0.62 to 1.0 of people, 0.3 to 0.4 of necks. At half
// of it a neck is taken for a waist; at double no form has one.
constexpr double thinnest_waist = 0.55;
// Metres; of children of 75 cm it is 0.42. Half of it lets bottles in; double, as long as adults.
constexpr double least_waist = 0.35;
// Of a form, whose stature nobody knows. At half of it the tests' forms keep their levels within
// 6 mm. At double, one with a head does not.
constexpr double waist_to_stature = 2.2;
// Shares of that stature, means of five bodies. From the bust up to the armpits it is 0.017 to
// 0.040, from there to the neck's base 0.086 to 0.116. At half of them a form's chest is 2.5 cm
// lower, its neck 8 cm. At double its chest is 5 cm higher; its neck is at the form's end already.
constexpr double chest_share = 0.026;
constexpr double neck_share = 0.095;
// Width of bust or hip over depth: 1.1 to 1.6 of people, 1 of vases and balls. At half of it a vase
// has a waist, at double no form has.
constexpr double roundest = 1.05;

/// What one level plane cuts of the trunk.
struct Level {
  double y = 0;
  double girth = 0;
  double front = 0;  // foremost z
  double back = 0;   // rearmost z
  double width = 0;  // in x
};

std::optional<Level> level_at(const TriangleMesh& mesh, double y, double min_share) {
  const std::vector<Section> sections = slice(mesh, {0, y, 0}, Vec3::UnitY());
  if (sections.empty() || !sections.front().closed) return std::nullopt;
  double whole = 0;
  for (const Section& section : sections) whole += std::max(0.0, section.area);
  const Section& trunk = sections.front();
  if (trunk.area < min_share * whole) return std::nullopt;
  Level level{y, trunk.girth, trunk.points.front().z(), trunk.points.front().z(), 0};
  const auto [left, right] =
      std::minmax_element(trunk.points.begin(), trunk.points.end(),
                          [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  level.width = right->x() - left->x();
  for (const Vec3& p : trunk.points) {
    level.front = std::max(level.front, p.z());
    level.back = std::min(level.back, p.z());
  }
  return level;
}

/// The levels from `from` up to `to` (metres), `step` apart.
std::vector<std::optional<Level>> levels_at(const TriangleMesh& mesh, double from, double to,
                                            double step, double min_share) {
  std::vector<double> heights;
  for (double y = from; y < to; y += step) heights.push_back(y);
  std::vector<std::optional<Level>> levels(heights.size());
  parallel_for(heights.size(),
               [&](std::size_t i) { levels[i] = level_at(mesh, heights[i], min_share); });
  return levels;
}

using Profile = std::vector<Level>;

template <class Value>
std::vector<Vec2> curve(const Profile& profile, double low, double high, const Value& value) {
  std::vector<Vec2> samples;
  for (const Level& level : profile) {
    if (level.y >= low && level.y <= high) samples.emplace_back(level.y, value(level));
  }
  return samples;
}

TrunkLevel absent(const std::string& reason) { return {std::nullopt, 0, reason}; }

/// The runs of levels without a jump of the girth, as where arms join; longest first.
std::vector<Profile> smooth_runs(const std::vector<std::optional<Level>>& levels) {
  constexpr double jump = 0.12;  // of the girth from level to level
  std::vector<Profile> runs(1);
  for (const std::optional<Level>& level : levels) {
    const Profile& run = runs.back();
    const bool goes_on = level && (run.empty() || std::abs(level->girth - run.back().girth) <
                                                      jump * run.back().girth);
    if (!goes_on && !run.empty()) runs.emplace_back();
    if (level) runs.back().push_back(*level);
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Profile& a, const Profile& b) { return a.size() > b.size(); });
  return runs;
}

class TrunkLevelFinder {
 public:
  explicit TrunkLevelFinder(const BodyFrame& body)
      : body_(body), stature_(body.height), reach_(reach_share * body.height) {}

  TrunkLevels find() {
    body_.skeleton ? profile_of_body() : profile_of_form();
    if (profile_.size() < 12) return none("there is no trunk that one section goes around");
    levels_.low = profile_.front().y;
    levels_.high = profile_.back().y;
    find_waist();
    if (!levels_.waist.height) return none(levels_.waist.reason);
    if (body_.skeleton && body_.skeleton->joints.contains("neck")) {
      const Vec3 axis = body_.skeleton->joint("neck") - body_.skeleton->joint("waist");
      levels_.lean = std::clamp(axis.z() / axis.y(), -0.25, 0.25);
    }
    find_hip();
    find_abdomen();
    find_bust();
    find_underbust();
    if (!body_.skeleton) {
      if (const std::string why = no_trunk(); !why.empty())
        return none("there is no trunk: " + why);
      levels_.is_backward = hollow(1) > hollow(-1);
    }
    return levels_;
  }

 private:
  TrunkLevels none(const std::string& reason) {
    levels_.bust = levels_.underbust = levels_.waist = levels_.abdomen = levels_.hip =
        absent(reason);
    return levels_;
  }

  double step() const { return step_share * body_.height; }

  void profile_of_body() {
    const double crotch = body_.skeleton->joint("pelvis").y();
    const double armpit = body_.skeleton->joint("chest").y();
    for (const auto& level : levels_at(body_.mesh, crotch + step() / 2, armpit, step(), 0)) {
      if (level) profile_.push_back(*level);
    }
  }

  void profile_of_form() {
    const auto levels = levels_at(body_.mesh, 2 * step(), body_.height, step(), form_share);
    // A stand's pole may be longer than the form.
    const std::vector<Profile> runs = smooth_runs(levels);
    const auto found = std::find_if(runs.begin(), runs.end(), [](const Profile& some) {
      return some.size() >= 12 && hollow_of(some) < some.size();
    });
    if (found == runs.end()) return;
    const Profile& run = *found;
    const std::size_t waist = hollow_of(run);
    // Neck, head and a stand's pole are no trunk. It ends where it is much thinner than the waist,
    // and above where it gets thinner than where it is fullest.
    const auto ends = [&](const Level& l) { return l.girth < 0.85 * run[waist].girth; };
    const auto middle = run.begin() + static_cast<std::ptrdiff_t>(waist);
    const auto neck = std::find_if(middle, run.end(), ends);
    const auto pole = std::find_if(std::make_reverse_iterator(middle), run.rend(), ends).base();
    const auto widest = std::max_element(
        middle, neck, [](const Level& a, const Level& b) { return a.girth < b.girth; });
    // Of a form without shoulders the bust is the fullest: what stands back above it shows it.
    const auto top =
        std::find_if(widest, neck, [&](const Level& l) { return l.girth < 0.92 * widest->girth; });
    profile_.assign(pole, top);
    stature_ = waist_to_stature * run[waist].girth;
    reach_ = reach_share * stature_;
  }

  /// The level of a form's waist, or the number of levels if there is none. It has to be 4 % wider
  /// above and below before it is as thin again. Necks and poles are too thin for it.
  static std::size_t hollow_of(const Profile& run) {
    std::vector<double> girths;
    girths.reserve(run.size());
    for (const Level& level : run) girths.push_back(level.girth);
    const double least = thinnest_waist * percentile(girths, 0.9);
    const auto rises = [&](std::size_t from, int way) {
      for (std::size_t i = from + way; i < girths.size() && girths[i] >= girths[from]; i += way) {
        if (girths[i] > 1.04 * girths[from]) return true;
      }
      return false;
    };
    std::size_t best = girths.size();
    for (std::size_t i = 0; i < girths.size(); ++i) {
      if (girths[i] < least || !rises(i, 1) || !rises(i, -1)) continue;
      if (best == girths.size() || girths[i] < girths[best]) best = i;
    }
    return best;
  }

  /// Why what was found on a form can't be a trunk's; empty: it can.
  std::string no_trunk() const {
    if (!levels_.bust.height || !levels_.hip.height) return "";
    const auto at = [this](double y) {
      return *std::min_element(
          profile_.begin(), profile_.end(),
          [y](const Level& a, const Level& b) { return std::abs(a.y - y) < std::abs(b.y - y); });
    };
    const Level bust = at(*levels_.bust.height);
    const Level waist = at(*levels_.waist.height);
    const Level hip = at(*levels_.hip.height);
    if (waist.girth < least_waist) return "its thinnest level is too thin for a waist";
    if (waist.girth < thinnest_waist * std::max(bust.girth, hip.girth)) {
      return "its thinnest level is too thin for a waist between its widest";
    }
    if (bust.girth < 0.65 * hip.girth || hip.girth < 0.65 * bust.girth) {
      return "what is above its thinnest level does not match what is below";
    }
    const auto is_round = [](const Level& l) { return l.width < roundest * (l.front - l.back); };
    if (is_round(bust) && is_round(hip)) return "it is round where a trunk is wider than deep";
    return "";
  }

  /// Metres that the front (1) or back (-1) at the waist lies behind what stands out both above and
  /// below.
  double hollow(int facing) const {
    const auto out = [facing](const Level& l) { return facing > 0 ? l.front : -l.back; };
    const double waist = *levels_.waist.height;
    double at_waist = 0;
    double nearest = std::numeric_limits<double>::infinity();
    double above = -nearest;
    double below = -nearest;
    for (const Level& level : profile_) {
      double& side = level.y > waist ? above : below;
      side = std::max(side, out(level));
      if (std::abs(level.y - waist) >= nearest) continue;
      nearest = std::abs(level.y - waist);
      at_waist = out(level);
    }
    return std::min(above, below) - at_waist;
  }

  void find_waist() {
    const double span = levels_.high - levels_.low;
    // A body's waist is looked for where joints have it; a form may be cut anywhere.
    const double low = body_.skeleton ? levels_.low + 0.3 * span : levels_.low;
    const double high = body_.skeleton ? levels_.low + 0.88 * span : levels_.high;
    const auto girths = curve(profile_, low, high, [](const Level& l) { return -l.girth; });
    if (girths.size() < 5) {
      levels_.waist = absent("the trunk is too short for a waist");
      return;
    }
    const Extreme least = greatest(girths, reach_);
    if (least.is_end || !(least.curvature < 0)) {
      levels_.waist = {levels_.low + waist_share * span, 0.3,
                       "no hollow shows the waist; proportion places it"};
      return;
    }
    const double down = std::sqrt(2 * hollow_edge * least.value / least.curvature);
    levels_.waist = {least.at - std::min(down, 0.5 * reach_), 0.9, ""};
  }

  void find_hip() {
    const double top = levels_.low + 0.75 * (*levels_.waist.height - levels_.low);
    const auto seat = curve(profile_, levels_.low, top, [](const Level& l) { return -l.back; });
    if (seat.size() < 5) {
      levels_.hip = absent("the trunk is too short for a hip");
      return;
    }
    const Extreme rearmost = greatest(seat, reach_);
    const auto girths = curve(profile_, levels_.low, top, [](const Level& l) { return l.girth; });
    Extreme fullest = greatest(girths, reach_);
    // A belly above the seat may be fuller. The farther above, the less it counts.
    const double above = fullest.at - rearmost.at;
    if (!rearmost.is_end && above > 0) {
      const double counts = std::max(0.0, 1 - above / (seat_reach * stature_));
      fullest = {rearmost.at + counts * above, fullest.value, fullest.curvature, false};
    }
    levels_.hip = {(rearmost.at + fullest.at) / 2, 0.9, ""};
    if (!rearmost.is_end && !fullest.is_end) return;
    // Thighs may be fuller than the hip, and a flat seat may stand out nowhere.
    levels_.hip = {
        (fullest.is_end ? rearmost : fullest).at, rearmost.is_end ? 0.5 : 0.7,
        rearmost.is_end ? "the seat stands out nowhere" : "the trunk is fullest at its end"};
  }

  void find_abdomen() {
    if (!levels_.hip.height) {
      levels_.abdomen = absent(levels_.hip.reason);
      return;
    }
    // A large belly stands out the most at the waist or above: its samples go on there.
    const double above = *levels_.waist.height + 0.15 * (levels_.high - levels_.low);
    const auto front =
        curve(profile_, *levels_.hip.height, above, [](const Level& l) { return l.front; });
    if (front.size() < 5) {
      levels_.abdomen = absent("hip and waist are too near to each other");
      return;
    }
    // A belly is flat: noise moves it by centimetres with a shorter reach.
    const Extreme foremost = greatest(front, 4 * reach_);
    levels_.abdomen = {foremost.at, 0.7, ""};
    if (!foremost.is_end && foremost.at <= *levels_.waist.height) return;
    const double waist = *levels_.waist.height;
    levels_.abdomen = {waist - abdomen_share * (waist - *levels_.hip.height), 0.4,
                       "no belly stands out between hip and waist; proportion places its level"};
  }

  void find_bust() {
    const double waist = *levels_.waist.height;
    // A low bust hangs down to the waist.
    const auto front = curve(profile_, waist, levels_.high, [this](const Level& l) {
      return l.front - bust_lean * levels_.lean * l.y;
    });
    // A breast is rounder above than below: a longer reach finds it too high.
    const double bust_reach = 0.67 * reach_;
    if (front.size() < 5) {
      levels_.bust = absent("the trunk ends too soon above the waist");
      return;
    }
    Extreme foremost = greatest(front, bust_reach);
    if (foremost.is_end) {
      // A belly, or the shoulders, stand out farther: the highest summit between them counts.
      std::vector<Vec2> summit;
      for (std::size_t i = 1; i + 1 < front.size(); ++i) {
        std::vector<Vec2> near;
        for (const Vec2& sample : front) {
          if (std::abs(sample.x() - front[i].x()) <= reach_) near.push_back(sample);
        }
        const bool is_summit = std::all_of(near.begin(), near.end(), [&](const Vec2& sample) {
          return sample.y() <= front[i].y();
        });
        if (is_summit && near.front().x() < front[i].x() && near.back().x() > front[i].x() &&
            (summit.empty() || greatest(summit, bust_reach).value < front[i].y())) {
          summit = near;
        }
      }
      if (summit.size() >= 5) foremost = greatest(summit, bust_reach);
    }
    levels_.bust = {foremost.at, 0.9, ""};
    const std::optional<double> usual = usual_bust();
    // Of a form. Noise of 1 mm hides how much the chest bends within the bust's own reach.
    const Extreme wide = greatest(front, 3 * reach_);
    const bool is_flat = !usual && !wide.is_end && -wide.curvature * stature_ < flat_bend;
    if (foremost.is_end || is_flat) {
      // A belly that stands out farther, or a chest that is nearly flat.
      const double low = waist + (levels_.high - waist) / 3;
      const Extreme convex = most_convex(waist, low, bust_reach);
      if (!convex.is_end) {
        levels_.bust = {convex.at, 0.5, "the chest stands out little"};
      } else if (foremost.is_end) {
        levels_.bust = {levels_.high - step(), 0.3, "no bust stands out; it is under the armpits"};
      }
    }
    if (!usual) return;
    // Where the armpits cut the front off, a few levels tell nothing of its bend.
    const double place = foremost.is_end ? *usual : foremost.at;
    const double bend = bend_around(front, std::min(place, levels_.high - 2 * reach_));
    const double seen = std::clamp((bend - flat_front) / (full_front - flat_front), 0.0, 1.0);
    if (seen == 1) return;
    *levels_.bust.height = *usual + seen * (*levels_.bust.height - *usual);
    levels_.bust.confidence = std::min(levels_.bust.confidence, 0.4 + 0.5 * seen);
    levels_.bust.reason = "the chest stands out little; proportion places its level";
  }

  /// Where the chest's level is on a body that shows none.
  std::optional<double> usual_bust() const {
    if (!body_.skeleton || !body_.skeleton->joints.contains("neck")) return std::nullopt;
    const double waist = *levels_.waist.height;
    const double at = waist + bust_share * (body_.skeleton->joint("neck").y() - waist);
    return std::min(at, levels_.high - step());
  }

  /// How much the front bends there, times the height: of the parabola of least squares within two
  /// reaches.
  double bend_around(const std::vector<Vec2>& front, double y) const {
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Vec2& sample : front) {
      const double t = (sample.x() - y) / (2 * reach_);
      if (std::abs(t) > 1) continue;
      const Eigen::Vector3d powers(1, t, t * t);
      sums += powers * powers.transpose();
      right += sample.y() * powers;
    }
    return -2 * sums.ldlt().solve(right)[2] / (4 * reach_ * reach_) * stature_;
  }

  /// Where the front stands out the most, from `low` up, from the straight line between the waist
  /// and the armpits.
  Extreme most_convex(double waist, double low, double reach) const {
    const auto front = curve(profile_, waist, levels_.high, [](const Level& l) { return l.front; });
    const Vec2& start = front.front();
    const Vec2& end = front.back();
    const double slope = (end.y() - start.y()) / (end.x() - start.x());
    return greatest(curve(profile_, low, levels_.high,
                          [&](const Level& l) { return l.front - slope * (l.y - start.x()); }),
                    reach);
  }

  void find_underbust() {
    if (!levels_.bust.height) {
      levels_.underbust = absent(levels_.bust.reason);
      return;
    }
    const double bust = *levels_.bust.height;
    const double waist = *levels_.waist.height;
    const double below =
        std::max(bust - underbust_share * stature_, waist + least_band * (bust - waist));
    // The crease: farthest behind the straight line from bust to waist.
    const auto at = [this](double y) {
      return *std::min_element(
          profile_.begin(), profile_.end(),
          [y](const Level& a, const Level& b) { return std::abs(a.y - y) < std::abs(b.y - y); });
    };
    const double slope = (at(bust).front - at(waist).front) / (bust - waist);
    const auto behind = curve(profile_, waist, bust, [&](const Level& l) {
      return at(waist).front + slope * (l.y - waist) - l.front;
    });
    levels_.underbust = {below, levels_.bust.confidence * 0.8, levels_.bust.reason};
    if (behind.size() >= 5) {
      const Extreme crease = greatest(behind, reach_);
      if (!crease.is_end) {
        // A flat chest has no crease: noise would place it anywhere.
        const double depth = crease.value / stature_;
        const double seen = std::clamp((depth - no_crease) / (a_crease - no_crease), 0.0, 1.0);
        // A low bust's crease is near the waist: the band lies between them.
        const double band = std::max(std::min(below, crease.at), (crease.at + waist) / 2);
        levels_.underbust.height = below + seen * (band - below);
      }
    }
  }

  const BodyFrame& body_;
  double stature_;  // metres: of a form, that of a person of its girth
  double reach_;
  Profile profile_;
  TrunkLevels levels_;
};

}  // namespace

TrunkLevels trunk_levels(const BodyFrame& body) { return TrunkLevelFinder(body).find(); }

TrunkLevels facing_trunk_levels(BodyFrame& body) {
  TrunkLevels levels = trunk_levels(body);
  if (!levels.is_backward) return levels;
  const Eigen::Matrix3d half_turn = Vec3(-1, 1, -1).asDiagonal();
  for (Vec3& p : body.mesh.points) p = half_turn * p;
  body.rotation = half_turn * body.rotation;
  body.translation = half_turn * body.translation;
  return trunk_levels(body);
}

std::optional<Skeleton> torso_joints(const BodyFrame& body, const TrunkLevels& levels) {
  if (!levels.waist.height || !levels.bust.height) return std::nullopt;
  const auto waist = torso_section(body.mesh, *levels.waist.height);
  if (!waist) return std::nullopt;
  const double stature = waist_to_stature * waist->girth;
  const double chest = *levels.bust.height + chest_share * stature;
  Skeleton skeleton;
  // A form may end below: each joint then is at the highest level that there is.
  const auto add = [&](const std::string& name, double height) {
    for (double y = height; y > 0; y -= step_share * stature) {
      const auto section = torso_section(body.mesh, y);
      if (!section) continue;
      skeleton.joints[name] = section->centroid;
      return;
    }
  };
  add("pelvis", levels.low);
  add("waist", *levels.waist.height);
  add("chest", chest);
  add("neck", chest + neck_share * stature);
  double last = -1;
  for (const Segment& segment : body_segments()) {
    if (segment.part != "torso") continue;
    for (const std::string& name : {segment.from, segment.to}) {
      const auto joint = skeleton.joints.find(name);
      if (joint == skeleton.joints.end() || joint->second.y() < last) return std::nullopt;
      last = joint->second.y();
    }
    skeleton.segments.push_back(segment);
  }
  return skeleton;
}

std::vector<NamedLevel> girth_levels(const TriangleMesh& body, const Skeleton& skeleton) {
  BodyFrame frame{body, skeleton, "", Eigen::Matrix3d::Identity(), Vec3::Zero(), 0};
  for (const Vec3& point : body.points) frame.height = std::max(frame.height, point.y());
  TrunkLevels found = trunk_levels(frame);
  if (!skeleton.joints.contains("left_hip")) {
    // The height of a form tells nothing of the stature, so the surface alone counts where it can.
    frame.skeleton.reset();
    TrunkLevels seen = trunk_levels(frame);
    if (seen.waist.height) found = std::move(seen);
  }
  std::vector<NamedLevel> levels;
  if (found.bust.height) levels.push_back({"bust", *found.bust.height});
  if (found.waist.height) levels.push_back({"waist", *found.waist.height});
  if (found.hip.height) levels.push_back({"hip", *found.hip.height});
  return levels;
}

}  // namespace toile
