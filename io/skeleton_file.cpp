#include "io/skeleton_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "io/landmarks_json.h"
#include "io/limits.h"
#include "io/output_file.h"
#include "io/sidecar.h"

namespace toile {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* remedy = "write it anew with clean-body";
constexpr const char* sidecar_kind = "body";

bool is_skeleton(const JsonValue& root) {
  if (!root.is_object()) return false;
  const auto format = root.find("format");
  return root.find("joints") || (format && format->is_text() && format->text() == "toile-body");
}

void expect(const JsonValue& root, const std::string& key, const std::string& wanted) {
  const JsonValue value = root.get(key);
  if (value.text() != wanted) value.fail("is not " + wanted, remedy);
}

Vec3 point_of(const JsonValue& value) {
  value.size(3, 3);
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = value.item(static_cast<std::size_t>(axis)).number();
    const std::string problem = coordinate_problem(point[axis], max_metres);
    if (!problem.empty()) value.fail(problem, remedy);
  }
  return point;
}

BodyMove move_of(const JsonValue& value) {
  BodyMove move;
  const JsonValue rotation = value.get("rotation");
  rotation.size(3, 3);
  for (std::size_t row = 0; row < 3; ++row) {
    rotation.item(row).size(3, 3);
    for (std::size_t column = 0; column < 3; ++column) {
      move.rotation(row, column) = rotation.item(row).item(column).number();
    }
  }
  const Eigen::Matrix3d off = move.rotation * move.rotation.transpose();
  if (!(off - Eigen::Matrix3d::Identity()).isZero(1e-6) || !(move.rotation.determinant() > 0)) {
    rotation.fail("is no rotation", remedy);
  }
  const JsonValue translation = value.get("translation_m");
  translation.size(3, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    move.translation[static_cast<int>(axis)] = translation.item(axis).number();
  }
  move.metres_per_unit = value.get("metres_per_unit").number();
  if (!(move.metres_per_unit > 0)) value.get("metres_per_unit").fail("is not positive", remedy);
  return move;
}

double length_of(const JsonValue& value) {
  const double length = value.number();
  if (!(length >= 0 && length <= max_metres)) value.fail("is no length in metres", remedy);
  return length;
}

BodyMeasures measures_of(const JsonValue& value) {
  BodyMeasures measures;
  const JsonValue girths = value.get("girths");
  for (std::size_t i = 0; i < girths.size(); ++i) {
    const JsonValue girth = girths.item(i);
    measures.girths.push_back({girth.get("name").text(), point_of(girth.get("origin_m")),
                               point_of(girth.get("normal")), length_of(girth.get("girth_m"))});
    if (std::abs(measures.girths.back().normal.norm() - 1) > 1e-6) {
      girth.get("normal").fail("is not of length 1", remedy);
    }
  }
  const JsonValue lengths = value.get("lengths_m");
  for (const std::string& name : lengths.keys()) {
    measures.lengths[name] = length_of(lengths.get(name));
  }
  const JsonValue points = value.get("shoulder_points_m");
  for (const std::string& side : points.keys()) {
    measures.shoulder_points[side] = point_of(points.get(side));
  }
  return measures;
}

Json json_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

Json json_of(const BodyMeasures& measures) {
  Json json = {{"girths", Json::array()},
               {"lengths_m", measures.lengths},
               {"shoulder_points_m", Json::object()}};
  for (const BodyGirth& girth : measures.girths) {
    json["girths"].push_back({{"name", girth.name},
                              {"origin_m", json_of(girth.origin)},
                              {"normal", json_of(girth.normal)},
                              {"girth_m", girth.girth}});
  }
  for (const auto& [side, point] : measures.shoulder_points) {
    json["shoulder_points_m"][side] = json_of(point);
  }
  return json;
}

bool has_segment(const Skeleton& skeleton, const Segment& wanted) {
  return std::any_of(skeleton.segments.begin(), skeleton.segments.end(),
                     [&](const Segment& segment) {
                       return segment.part == wanted.part && segment.from == wanted.from &&
                              segment.to == wanted.to;
                     });
}

}  // namespace

std::string format_skeleton(const Skeleton& skeleton, const Landmarks& landmarks) {
  Json json = {{"format", "toile-body"}, {"version", 1}, {"units", "m"}, {"up", "y"}};
  json["joints"] = Json::object();
  for (const auto& [name, point] : skeleton.joints) {
    json["joints"][name] = json_of(point);
  }
  json["segments"] = Json::array();
  for (const Segment& segment : skeleton.segments) {
    json["segments"].push_back(
        {{"part", segment.part}, {"from", segment.from}, {"to", segment.to}});
  }
  if (!landmarks.empty()) json["landmarks"] = landmarks_json(landmarks);
  if (skeleton.measures) json["measures"] = json_of(*skeleton.measures);
  if (skeleton.cleaned) {
    const BodyMove& move = *skeleton.cleaned;
    Json rotation = Json::array();
    for (int row = 0; row < 3; ++row) {
      rotation.push_back({move.rotation(row, 0), move.rotation(row, 1), move.rotation(row, 2)});
    }
    json["cleaned"] = {
        {"rotation", rotation},
        {"translation_m", {move.translation.x(), move.translation.y(), move.translation.z()}},
        {"metres_per_unit", move.metres_per_unit}};
  }
  return json.dump(1) + "\n";
}

void write_skeleton(const OutputPath& path, const Skeleton& skeleton, const Landmarks& landmarks) {
  write_file(path, format_skeleton(skeleton, landmarks));
}

Skeleton read_skeleton(const fs::path& path) {
  return parse_skeleton(read_file(path), path.string());
}

Skeleton parse_skeleton(const std::string& text, const std::string& file) {
  const JsonDocument document(text, file);
  const JsonValue root = document.root();
  expect(root, "units", "m");
  expect(root, "up", "y");
  Skeleton skeleton;
  const JsonValue joints = root.get("joints");
  for (const std::string& name : joints.keys()) {
    skeleton.joints[name] = point_of(joints.get(name));
  }
  const JsonValue segments = root.get("segments");
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const JsonValue value = segments.item(i);
    const Segment segment{std::string(body_parts.at(word_of(value.get("part"), body_parts))),
                          value.get("from").text(), value.get("to").text()};
    for (const std::string& end : {segment.from, segment.to}) {
      if (skeleton.joints.contains(end)) continue;
      value.fail("joint " + in_quotes(end) + " is missing", remedy);
    }
    skeleton.segments.push_back(segment);
  }
  for (const Segment& wanted : body_segments()) {
    const bool has_joints =
        skeleton.joints.contains(wanted.from) && skeleton.joints.contains(wanted.to);
    if (!has_joints || has_segment(skeleton, wanted)) continue;
    segments.fail("has no segment of " + wanted.part + " from " + wanted.from + " to " + wanted.to,
                  remedy);
  }
  if (const auto cleaned = root.find("cleaned")) {
    skeleton.cleaned = move_of(*cleaned);
  }
  if (const auto measures = root.find("measures")) skeleton.measures = measures_of(*measures);
  return skeleton;
}

bool is_skeleton_file(const fs::path& path) {
  if (!fs::is_regular_file(path)) return false;
  return is_skeleton(JsonDocument(read_file(path), path.string()).root());
}

fs::path skeleton_path(const fs::path& body) { return sidecar_path(body, sidecar_kind); }

fs::path skeleton_beside(const fs::path& body) {
  return sidecar_beside(body, sidecar_kind, is_skeleton);
}

}  // namespace toile
