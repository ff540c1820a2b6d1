// Programs, run as processes of their own with limits.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace toile {

struct ChildLimits {
  std::optional<std::chrono::steady_clock::time_point> end;  ///< when it is ended; none: never
  std::optional<std::uint64_t> memory;                       ///< bytes of addresses; none: no limit
  int stop = -1;  ///< a file descriptor: the process is ended when it can be read; -1: none
};

/// How a process ended.
struct ChildEnd {
  int exit_code = 0;       ///< of no use where a signal ended it
  int signal = 0;          ///< that ended it; 0: none
  bool timed_out = false;  ///< it was ended because its time was over, or by ChildLimits::stop
  double seconds = 0;      ///< on the clock
  double peak_MiB = 0;     ///< of memory
  std::string output;      ///< what it said
};

/// Runs `toile WORDS...` and waits for its end. `toile` is this executable, or stands beside it. It
/// ends with its process group when its time is
/// over, and when the caller ends. May be called from several threads at once. Throws Error when no
/// process can be started.
ChildEnd run_toile(const std::vector<std::string>& words, const ChildLimits& limits);

/// The same of any program, at `program`.
ChildEnd run_program(const std::filesystem::path& program, const std::vector<std::string>& words,
                     const ChildLimits& limits);

}  // namespace toile
