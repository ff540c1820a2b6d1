// The sample mannequin, dressed by the built programs.
#pragma once

#include <gtest/gtest.h>

#include <map>
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

/// The mannequin as make-mannequin writes it at this edge length, its joints beside it: a file to
/// read only, made once by a test program.
inline const fs::path& mannequin(const std::string& edge_length = "9mm") {
  static const ScratchFolder folder;
  static std::map<std::string, fs::path> made;
  fs::path& file = made[edge_length];
  if (file.empty()) {
    file = folder / (edge_length + ".ply");
    succeed("make-mannequin", {"-o", file, "--edge-length", edge_length, "-q"});
  }
  return file;
}

/// The same, as clean-body writes it.
inline const fs::path& clean_mannequin() {
  static const ScratchFolder folder;
  static const fs::path file = [] {
    succeed("clean-body", {mannequin(), "-o", folder / "body.ply", "-q"});
    return folder / "body.ply";
  }();
  return file;
}

/// A folder of its own for a mannequin, its garment, and what comes of dressing it.
class WornSample : public testing::Test {
 protected:
  /// `fineness`: the mannequin's edges; none: as it comes.
  void make_body(const std::string& fineness = "9mm") const {
    const fs::path& made = mannequin(fineness);
    constexpr auto anew = fs::copy_options::overwrite_existing;
    fs::copy(made, body, anew);
    fs::copy(fs::path(made).replace_extension("body.json"), folder / "body.body.json", anew);
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
