// A pattern tried on a body while its seams are drawn: the chain of programs, on the server's side.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/edit_seams/background.h"
#include "tools/edit_seams/run.h"

namespace toile {

/// Runs the programs of the chain in a folder of its own, which is gone at the end. What runs then
/// is ended. No call waits for a program.
class Trial {
 public:
  Trial(const EditSeamsSettings& settings, int threads);
  ~Trial();

  const std::filesystem::path& folder() const { return folder_; }

  /// Begins to look for the seams of that pattern. Throws Error while it does so already.
  void find_seams(const std::string& pattern);
  /// Its result is the report of find-seams, as JSON.
  const Background& finding() const { return finding_; }

  /// Begins to dress the body in that pattern. Throws Error while it does so already, and without a
  /// body.
  void dress(const std::string& pattern);
  /// Its result is the drape as the page draws it, see drape_json().
  const Background& dressing() const { return dressing_; }

 private:
  /// Runs a program of the chain. Returns the warnings that it said.
  std::vector<std::string> run(std::vector<std::string> words) const;
  std::string drape(const Background::Say& say);

  const EditSeamsSettings& settings_;
  int threads_;
  std::filesystem::path folder_;
  int stop_;  // a file descriptor that can be read once the programs have to end
  bool body_is_clean_ = false;
  std::vector<std::string> body_warnings_;
  Background finding_{"find-seams"};
  Background dressing_{"dress"};
};

}  // namespace toile
