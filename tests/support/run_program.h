// Runs a built program and keeps what it said.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace toile::pipeline {

namespace fs = std::filesystem;

/// What a run ended with. A run that was killed by a signal has exit_code 128 + signal.
struct Run {
  int exit_code = -1;
  std::string out;
  std::string err;
  double seconds = 0;            ///< from its start to its end
  double processor_seconds = 0;  ///< of all its threads
  double peak_MiB = 0;           ///< of memory; at least what the caller itself had
};

/// A new empty folder, removed with all that is in it at the end of the scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "toile-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }
  fs::path operator/(const std::string& name) const { return path_ / name; }
  /// Names of what is in it, sorted: to find files that should not be there.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(path_)) all.push_back(entry.path().filename());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  fs::path path_;
};

inline std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// How many times as long the built programs may take as those of the release.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int slower = 20;
#else
inline constexpr int slower = 1;
#endif

/// Runs the program `name` from the build's tools folder, or at an absolute path, its stdin empty.
/// A run that takes longer than `seconds` (of a release) is killed, so a program that hangs fails
/// its test instead of stopping the suite.
inline Run run(const std::string& name, const std::vector<std::string>& arguments,
               int seconds = 280) {
  const ScratchFolder scratch;
  const fs::path program = fs::path(TOILE_TOOLS_DIR) / name;
  const fs::path out = scratch / "out";
  const fs::path err = scratch / "err";
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("can't start " + program.string());
  if (child == 0) {
    const auto redirect = [](const char* path, int flags, int to) {
      const int file = open(path, flags, 0600);
      if (file < 0 || dup2(file, to) < 0) _exit(126);
      close(file);
    };
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    alarm(static_cast<unsigned>(slower * seconds));
    execv(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  rusage used = {};
  if (wait4(child, &status, 0, &used) != child) {
    throw std::runtime_error("lost " + program.string());
  }
  Run result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto seconds_of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  result.processor_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  result.peak_MiB = static_cast<double>(used.ru_maxrss) / 1024;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = read_text(out);
  result.err = read_text(err);
  return result;
}

/// A file of the real data, which is not part of the project: beside the project's root, or where
/// TOILE_DATA says. Nothing when it is absent: print why and skip.
inline std::optional<fs::path> real_data(const std::string& name) {
  const char* given = std::getenv("TOILE_DATA");
  const fs::path folder =
      given != nullptr ? fs::path(given) : fs::path(TOILE_SOURCE_DIR) / ".." / "shared" / "data";
  const fs::path path = folder / name;
  return fs::exists(path) ? std::optional(path) : std::nullopt;
}

}  // namespace toile::pipeline

/// Sets `variable` to the path of a real data file, or skips the test and says why.
#define TOILE_REAL_DATA(variable, name)                                                       \
  const auto variable##_or_none = toile::pipeline::real_data(name);                           \
  if (!variable##_or_none) GTEST_SKIP() << name << " is not in ../shared/data or TOILE_DATA"; \
  const std::filesystem::path variable = *variable##_or_none
