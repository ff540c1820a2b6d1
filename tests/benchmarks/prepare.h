// Bodies and garments for benchmarks, made by the programs as a user makes them.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace toile::pipeline {

/// The first line of what a program complained about.
inline std::string complaint(const Run& run) {
  if (run.exit_code > 128) return "killed by signal " + std::to_string(run.exit_code - 128);
  return run.err.substr(0, run.err.find('\n'));
}

inline Run run_or_throw(const std::string& name, const std::vector<std::string>& arguments) {
  Run done = run(name, arguments);
  if (done.exit_code != 0) throw std::runtime_error(name + ": " + complaint(done));
  return done;
}

/// Writes the bodies once each.
class Bodies {
 public:
  explicit Bodies(const fs::path& folder) : folder_(folder) {}
  /// A pose of the sample mannequin, or mean_all: nothing where the real data is absent.
  std::optional<fs::path> get(const std::string& name) {
    const fs::path body = folder_ / (name + "_body.ply");
    if (fs::exists(body)) return body;
    fs::path raw = folder_ / (name + ".ply");
    if (name == "mean_all") {
      const auto found = real_data("bodies/mean_all.obj");
      if (!found) return std::nullopt;
      raw = *found;
    } else {
      run_or_throw("make-mannequin", {"--pose", name, "-o", raw.string()});
    }
    run_or_throw("clean-body", {raw.string(), "-o", body.string(), "-q"});
    return body;
  }

 private:
  fs::path folder_;
};

/// A sample pattern, or one of the real data where the body is: nothing where that is absent.
inline std::optional<fs::path> pattern_for(const std::string& body, const std::string& pattern) {
  if (body == "mean_all") return real_data(pattern);
  return fs::path(TOILE_SOURCE_DIR) / "samples" / pattern;
}

}  // namespace toile::pipeline
