// What the hard cases share: a body, runs of the programs on it that are looked at however they
// end, and the lines of docs/stability.md.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace toile::test {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// One row of the table. `outcome` is a verdict, "error", or what was found; `figures` may be
/// empty.
void state(const std::string& hard_case, const std::string& method, const std::string& outcome,
           const std::string& figures = "");

/// The value to so many significant digits.
std::string number(double value, int digits = 3);

/// How a run of `dress` ended.
struct Ending {
  int exit_code = -1;
  std::string outcome;  ///< the verdict, or "error"
  std::string said;     ///< all of its messages
  Json report;          ///< empty where there was an error
  double seconds = 0;

  bool says(const std::string& words) const { return said.find(words) != std::string::npos; }
  /// Strain, intersections and residual, for the table.
  std::string figures() const;
  /// Its first line, without the program's name and the scratch folder's: for the table.
  std::string first_words() const;
};

/// Cases that run the programs: in a folder of their own, on the sample mannequin.
class HardCase : public testing::Test {
 protected:
  /// The mannequin, made once per process, its joints beside it.
  static const fs::path& mannequin();
  /// A sample pattern.
  static Json sample(const std::string& name);

  /// Meshes a pattern as NAME.obj of the folder, or fails the test.
  fs::path meshed(const Json& pattern, const std::string& name = "garment",
                  const std::string& edge_length = "25mm");
  /// The sample band, 600 triangles around the waist, changed before it is meshed.
  fs::path band(const std::function<void(Json& panels, Json& stitches)>& change = {});

  /// Runs `dress` by a method. Fails the test unless the run ends as every run has to:
  ///
  /// - It ends within `seconds`, by one of the exit codes of dress.
  /// - An error is one line and leaves no file.
  /// - Anything else is written completely, with finite figures in mesh and report. The exit code
  ///   is the verdict's. The intersections in the report are those of the files.
  Ending dress(const fs::path& body, const fs::path& garment, const std::string& method,
               const std::vector<std::string>& options = {}, int seconds = 120);
  /// Runs any program that has to refuse its input, as above, and returns what it said.
  std::string refused(const std::string& program, std::vector<std::string> words,
                      int exit_code = 1);

  pipeline::ScratchFolder folder;

 private:
  void check_written(const Ending& ending, const fs::path& body, const fs::path& dressed) const;
};

/// The two methods that dress.
inline const std::vector<std::string> both_methods = {"relaxation", "paper"};

}  // namespace toile::test
