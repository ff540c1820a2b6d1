#include "io/skeleton_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& problem) {
  throw Error(path.string(), problem, "write it anew with clean-body");
}

Vec3 parse_joint(const fs::path& path, const std::string& name, const Json& value) {
  Vec3 point;
  bool good = value.is_array() && value.size() == 3;
  for (int axis = 0; good && axis < 3; ++axis) {
    good = value[axis].is_number() && std::isfinite(value[axis].get<double>());
    if (good) point[axis] = value[axis].get<double>();
  }
  if (!good) fail(path, "joint '" + name + "' is not three finite numbers");
  return point;
}

std::string text(const fs::path& path, const Json& object, const std::string& key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !found->is_string()) fail(path, "'" + key + "' is no text");
  return found->get<std::string>();
}

}  // namespace

void write_skeleton(const fs::path& path, const Skeleton& skeleton) {
  Json json = {{"format", "toile-body"}, {"version", 1}, {"units", "m"}, {"up", "y"}};
  json["joints"] = Json::object();
  for (const auto& [name, point] : skeleton.joints) {
    json["joints"][name] = {point.x(), point.y(), point.z()};
  }
  json["segments"] = Json::array();
  for (const Segment& segment : skeleton.segments) {
    json["segments"].push_back(
        {{"part", segment.part}, {"from", segment.from}, {"to", segment.to}});
  }
  write_file(path, json.dump(1) + "\n");
}

Skeleton read_skeleton(const fs::path& path) {
  const std::string content = read_file(path);
  Json json;
  try {
    json = Json::parse(content);
  } catch (const Json::exception& wrong) {
    fail(path, std::string("is not JSON (") + wrong.what() + ")");
  }
  if (!json.is_object()) fail(path, "is no JSON object");
  if (text(path, json, "units") != "m") fail(path, "'units' is not m");
  if (text(path, json, "up") != "y") fail(path, "'up' is not y");
  Skeleton skeleton;
  const auto joints = json.find("joints");
  if (joints == json.end() || !joints->is_object()) fail(path, "'joints' is missing");
  for (const auto& [name, value] : joints->items()) {
    skeleton.joints[name] = parse_joint(path, name, value);
  }
  const auto segments = json.find("segments");
  if (segments == json.end() || !segments->is_array()) fail(path, "'segments' is missing");
  for (const Json& value : *segments) {
    Segment segment{text(path, value, "part"), text(path, value, "from"), text(path, value, "to")};
    if (std::find(body_parts.begin(), body_parts.end(), segment.part) == body_parts.end()) {
      fail(path, "'" + segment.part + "' is not a part of a body");
    }
    for (const std::string& end : {segment.from, segment.to}) {
      if (!skeleton.joints.contains(end)) fail(path, "segment joint '" + end + "' is missing");
    }
    skeleton.segments.push_back(std::move(segment));
  }
  return skeleton;
}

bool is_skeleton_file(const fs::path& path) {
  if (!fs::is_regular_file(path)) return false;
  const Json json = Json::parse(read_file(path), nullptr, false);
  const auto format = json.is_object() ? json.find("format") : json.end();
  return format != json.end() && *format == "toile-body";
}

fs::path skeleton_path(const fs::path& body) {
  fs::path path = body;
  return path.replace_extension(".json");
}

}  // namespace toile
