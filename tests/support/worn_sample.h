// The sample mannequin, dressed by the built programs.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace toile::pipeline {

/// Runs a program that has to end well; its stdout is for data.
inline void succeed(const std::string& program, const std::vector<std::string>& words) {
  const Run done = run(program, words);
  ASSERT_EQ(done.exit_code, 0) << program << ": " << done.err;
  EXPECT_EQ(done.out, "");
}

inline fs::path sample(const std::string& name) {
  return fs::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json");
}

/// A folder of its own for a mannequin, its garment, and what comes of dressing it.
class WornSample : public testing::Test {
 protected:
  /// `fineness`: the mannequin's edges; none: as it comes.
  void make_body(const std::string& fineness = "") const {
    std::vector<std::string> words = {"-o", body, "-q"};
    if (!fineness.empty()) words.insert(words.end(), {"--edge-length", fineness});
    succeed("make-mannequin", words);
  }

  void mesh(const fs::path& pattern, const std::string& edge_length) const {
    succeed("mesh-pattern", {pattern, "-o", garment, "--edge-length", edge_length, "-q"});
  }

  /// Writes NAME.obj, and NAME.json with the report.
  pipeline::Run dress(const std::string& name, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"--body",
                                      body,
                                      garment,
                                      "-o",
                                      folder / (name + ".obj"),
                                      "--report",
                                      folder / (name + ".json"),
                                      "-q"};
    words.insert(words.end(), options.begin(), options.end());
    return run("dress", words);
  }

  nlohmann::json report(const std::string& name) const {
    return nlohmann::json::parse(read_text(folder / (name + ".json")));
  }

  ScratchFolder folder;
  fs::path body = folder / "body.ply";
  fs::path garment = folder / "garment.obj";
};

}  // namespace toile::pipeline
