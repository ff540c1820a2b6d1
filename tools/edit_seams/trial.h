// A pattern tried on a body while its seams are drawn: the chain of programs, on the server's side.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tools/edit_seams/run.h"

namespace toile {

/// Runs the programs of the chain in a folder of its own, which is gone at the end. What runs then
/// is ended.
class Trial {
 public:
  Trial(const EditSeamsSettings& settings, int threads);
  ~Trial();

  const std::filesystem::path& folder() const { return folder_; }

  /// The report of find-seams on that pattern, as JSON. Waits for it. Throws Error with what the
  /// program said.
  std::string find_seams(const std::filesystem::path& pattern) const;

  /// Begins to dress the body in that pattern. Throws Error while another one is being dressed, and
  /// without a body.
  void start(const std::filesystem::path& pattern);

  /// JSON: `state` (idle, working, done, failed) and `text` for people.
  std::string progress() const;

  /// JSON: the last drape, as the page draws it. Throws Error when there is none.
  std::string drape() const;

 private:
  void run();
  /// Returns the warnings that the program said.
  std::vector<std::string> step(const std::string& text, std::vector<std::string> words);
  void set(const std::string& state, const std::string& text);

  const EditSeamsSettings& settings_;
  int threads_;
  std::filesystem::path folder_;
  int stop_;  // a file descriptor that can be read once the programs have to end
  bool body_is_clean_ = false;
  std::vector<std::string> body_warnings_;
  mutable std::mutex mutex_;  // of what follows
  std::string state_ = "idle";
  std::string text_;
  std::string drape_;
  std::thread work_;
};

}  // namespace toile
