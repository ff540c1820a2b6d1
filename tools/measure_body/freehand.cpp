#include "tools/measure_body/freehand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "geometry/body/bones.h"
#include "geometry/body/centreline.h"
#include "geometry/body/tape.h"
#include "geometry/error.h"
#include "geometry/geodesic.h"
#include "io/json_words.h"
#include "io/text.h"
#include "tools/program.h"

namespace toile {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::array<std::string_view, 5> kinds = {"girth", "distance", "curve", "height", "slope"};

/// The words of an expression.
struct Words {
  std::string kind;
  std::map<std::string, std::string> values;
};

class Taker {
 public:
  Taker(const BodyShape& shape, const std::string& expression, const std::string& place)
      : shape_(shape), expression_(expression), place_(place) {}

  Measure take() {
    read();
    measure_.name = words_.values.contains("name") ? words_.values["name"] : expression_;
    measure_.definition = expression_;
    measure_.confidence = 1;
    if (words_.kind == "girth") {
      girth();
    } else if (words_.kind == "height") {
      const Vec3 p = point("of");
      finish(p.y(), {Vec3(p.x(), 0, p.z()), p});
    } else {
      line();
    }
    if (!measure_.reason.empty()) {
      measure_.value.reset();
      measure_.confidence = 0;
      measure_.lines.clear();
    }
    return measure_;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(place_, problem + " in " + in_quotes(expression_), remedy);
  }

  void read() {
    std::istringstream stream(expression_);
    if (!(stream >> words_.kind) ||
        std::find(kinds.begin(), kinds.end(), words_.kind) == kinds.end()) {
      fail("there is no kind of measure", "begin with one of " + listed(kinds));
    }
    const std::map<std::string, std::set<std::string>> known = {
        {"girth", {"plane", "tilt", "roll", "part", "share", "name"}},
        {"distance", {"from", "to", "name"}},
        {"curve", {"from", "to", "name"}},
        {"slope", {"from", "to", "name"}},
        {"height", {"of", "name"}}};
    for (std::string word; stream >> word;) {
      const std::size_t equals = word.find('=');
      const std::string key = word.substr(0, equals);
      if (equals == std::string::npos || !known.at(words_.kind).contains(key)) {
        fail(in_quotes(word) + " is not understood",
             "a " + words_.kind + " takes " + listed(known.at(words_.kind)));
      }
      if (!words_.values.emplace(key, word.substr(equals + 1)).second) {
        fail(in_quotes(key) + " is there twice", "leave one out");
      }
    }
  }

  std::string word(const std::string& key) const {
    const auto found = words_.values.find(key);
    if (found == words_.values.end()) fail("there is no " + key + "=", "add it");
    return found->second;
  }

  double angle(const std::string& key) const {
    if (!words_.values.contains(key)) return 0;
    std::string text = word(key);
    if (text.ends_with("deg")) text.resize(text.size() - 3);
    const auto value = parse_number(text);
    if (!value || !(std::abs(*value) <= 80)) {
      fail(in_quotes(word(key)) + " is no angle", "give -80deg to 80deg");
    }
    return degree * *value;
  }

  void lack(const std::string& reason) {
    if (measure_.reason.empty()) measure_.reason = reason;
  }

  const Skeleton* skeleton() const {
    return shape_.frame.skeleton ? &*shape_.frame.skeleton : nullptr;
  }

  /// A landmark, a joint or coordinates, in the frame.
  Vec3 named(const std::string& name) {
    for (const Landmark& landmark : shape_.landmarks) {
      if (landmark.name != name) continue;
      if (!landmark.place) lack("no landmark " + name + ": " + landmark.reason);
      measure_.confidence = std::min(measure_.confidence, landmark.confidence);
      return landmark.place.value_or(Vec3::Zero());
    }
    if (std::find(joint_names.begin(), joint_names.end(), name) != joint_names.end()) {
      if (skeleton() != nullptr && skeleton()->joints.contains(name)) {
        return skeleton()->joint(name);
      }
      lack("no joint " + name + ": " +
           (skeleton() == nullptr ? shape_.frame.no_skeleton : "the body lacks this part"));
      return Vec3::Zero();
    }
    std::istringstream stream(name);
    Vec3 given;
    int count = 0;
    for (std::string part; std::getline(stream, part, ',') && count < 4; ++count) {
      const auto value = parse_number(part);
      if (!value || !(std::abs(*value) < 100) || count == 3) {
        fail(in_quotes(name) + " is no point", "give a landmark, a joint, or x,y,z in metres");
      }
      given[count] = *value;
    }
    if (count != 3) {
      fail(in_quotes(name) + " is no point", "give a landmark, a joint, or x,y,z in metres");
    }
    return shape_.frame.rotation * given + shape_.frame.translation;
  }

  Vec3 point(const std::string& key) { return named(word(key)); }

  void finish(double value, std::vector<Vec3> line) {
    measure_.value = value;
    measure_.lines = {std::move(line)};
    for (Vec3& p : measure_.lines.front()) p = shape_.frame.given(p);
  }

  void line() {
    const Vec3 a = point("from");
    const Vec3 b = point("to");
    if (!measure_.reason.empty()) return;
    if (words_.kind == "distance") return finish((b - a).norm(), {a, b});
    if (words_.kind == "slope") {
      const Vec3 d = b - a;
      finish(std::atan2(-d.y(), std::hypot(d.x(), d.z())) / degree, {a, b});
      measure_.is_angle = true;
      return;
    }
    std::vector<Vec3> skin = geodesic(shape_.frame.mesh, a, b);
    if (skin.empty()) return lack("no line on the skin joins the points");
    const double length = length_of(skin);
    finish(length, std::move(skin));
  }

  const TrunkLevel* level_named(const std::string& name) const {
    const TrunkLevels& levels = shape_.levels;
    const std::map<std::string, const TrunkLevel*> named = {{"bust", &levels.bust},
                                                            {"underbust", &levels.underbust},
                                                            {"waist", &levels.waist},
                                                            {"abdomen", &levels.abdomen},
                                                            {"hip", &levels.hip}};
    const auto found = named.find(name);
    return found == named.end() ? nullptr : found->second;
  }

  void girth() {
    Vec3 at = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();
    bool largest = false;
    const bool has_part = words_.values.contains("part");
    if (has_part && words_.values.contains("plane")) {
      fail("there are both plane= and part=", "give one of them");
    }
    if (!has_part && words_.values.contains("share")) {
      fail("share= goes with part=", "leave it out");
    }
    if (has_part) {
      along_part(at, normal);
    } else {
      const std::string plane = word("plane");
      const double height =
          plane.empty() || plane.find(',') != std::string::npos ? 0 : height_of(plane);
      if (const TrunkLevel* level = level_named(plane)) {
        if (!level->height) return lack("no " + plane + " level: " + level->reason);
        measure_.confidence = level->confidence;
        at.y() = *level->height;
        largest = true;
      } else if (height > 0) {
        at.y() = height;
        largest = true;
      } else {
        at = named(plane);
      }
    }
    if (!measure_.reason.empty()) return;
    if (largest) {
      const std::vector<Section> sections = slice(shape_.frame.mesh, at, Vec3::UnitY());
      if (sections.empty()) return lack("the plane misses the body");
      at = sections.front().centroid;
    }
    normal = Eigen::AngleAxisd(angle("tilt"), Vec3::UnitX()) *
             (Eigen::AngleAxisd(-angle("roll"), Vec3::UnitZ()) * normal);
    const auto section =
        section_at(slice(shape_.frame.mesh, at, normal), at, normal, 0, shape_.frame.height);
    if (!section) return lack("the plane has no closed section there");
    std::vector<Vec3> around = tape_around(*section, normal);
    around.push_back(around.front());
    const double length = length_of(around);
    finish(length, std::move(around));
  }

  /// Metres, where the word is a length with a unit; else 0.
  double height_of(const std::string& text) const {
    if (text.find_first_of("0123456789") != 0) return 0;
    return parse_length(text, place_);
  }

  void along_part(Vec3& at, Vec3& normal) {
    const std::string part = word("part");
    if (body_part(part) == BodyPart::none) {
      fail(in_quotes(part) + " is no part", "use one of " + listed(body_parts));
    }
    const auto share = parse_number(word("share"));
    if (!share || !(*share >= 0 && *share <= 1)) {
      fail(in_quotes(word("share")) + " is no share", "give 0 to 1");
    }
    if (skeleton() == nullptr) return lack("no joints: " + shape_.frame.no_skeleton);
    const Bones bones(*skeleton(), body_part(part));
    if (bones.joints.empty()) return lack("the body has no joints of " + part);
    const auto [middle, direction] = bones.at(*share * bones.along.back());
    at = middle;
    normal = direction;
  }

  const BodyShape& shape_;
  const std::string& expression_;
  const std::string& place_;
  Words words_;
  Measure measure_;
};

}  // namespace

Measure take_freehand(const BodyShape& shape, const std::string& expression,
                      const std::string& place) {
  return Taker(shape, expression, place).take();
}

}  // namespace toile
