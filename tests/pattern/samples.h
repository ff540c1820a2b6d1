// Small patterns that tests share.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "pattern/check/check_pattern.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"

namespace toile::samples {

/// A pattern file of the given panels and stitches (JSON text), in centimetres.
inline std::string file(
    const std::string& panels, const std::string& stitches = "",
    const std::string& properties = R"("curvature_coords": "relative", "units_in_meter": 100)") {
  return "{\"pattern\": {\"panels\": {" + panels + "}, \"stitches\": [" + stitches +
         "]}, \"properties\": {" + properties + "}}";
}

/// A panel of straight edges through `vertices` ("[0,0],[10,0],..."), `extra` keys first.
inline std::string polygon(const std::string& name, const std::string& vertices,
                           const std::string& extra = R"("translation": [0,0,0])") {
  int count = 0;
  for (const char c : vertices) count += c == '[';
  std::string edges;
  for (int i = 0; i < count; ++i) {
    edges += std::string(i == 0 ? "" : ",") + "{\"endpoints\": [" + std::to_string(i) + "," +
             std::to_string((i + 1) % count) + "]}";
  }
  return "\"" + name + "\": {" + extra + ", \"vertices\": [" + vertices + "], \"edges\": [" +
         edges + "]}";
}

/// A panel with one curved edge (its edge 2, over the top of a 20 x 20 cm square).
inline std::string curved(const std::string& curvature, const std::string& name = "curved") {
  return "\"" + name + R"(": {"vertices": [[0,0],[20,0],[20,20],[0,20]], "edges": [
      {"endpoints": [0,1]}, {"endpoints": [1,2]},
      {"endpoints": [2,3], "curvature": )" +
         curvature + R"(}, {"endpoints": [3,0]}]})";
}

/// Front and back of a bag with a curved bottom, sewn at both sides and the bottom, open at the
/// top. One is drawn counter-clockwise and one clockwise, as GarmentCode does.
inline const std::string bag = file(
    R"("front": {"translation": [0,100,20], "rotation": [0,0,0],
        "vertices": [[0,0],[30,0],[30,40],[0,40]],
        "edges": [{"endpoints": [0,1], "curvature": {"type": "quadratic", "params": [[0.5,-0.2]]}},
                  {"endpoints": [1,2]}, {"endpoints": [2,3]}, {"endpoints": [3,0]}]},
       "back": {"translation": [0,100,-20], "rotation": [0,0,0],
        "vertices": [[0,0],[0,41],[30,41],[30,0]],
        "edges": [{"endpoints": [0,1]}, {"endpoints": [1,2]}, {"endpoints": [2,3]},
                  {"endpoints": [3,0], "curvature": [0.5,0.2]}]})",
    R"([{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
       [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}, {"name": "left side"}],
       [{"panel": "front", "edge": 0}, {"panel": "back", "edge": 3}])");

inline Pattern parse(const std::string& text) {
  std::vector<Remark> remarks;
  return parse_pattern(text, "test.json", remarks);
}

/// The message of the Error that `work` throws; empty when it throws none.
inline std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A file of the real data, or nothing when it is absent.
inline std::optional<std::filesystem::path> real_pattern(const std::string& name) {
  const char* given = std::getenv("TOILE_DATA");
  const std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(TOILE_SOURCE_DIR) / ".." / "shared" / "data";
  const auto path = folder / "patterns" / "garmentcode" / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace toile::samples

#define EXPECT_HOLDS(text, part) \
  EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text)
