// Boost.Process of Debian 12 waits with signals of the whole process, which threads can't share; a
// process has a file descriptor to wait on instead.
#include "tools/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// The header of glibc 2.36 does not say that its functions are C's.
extern "C" {
#include <sys/pidfd.h>
}

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "geometry/error.h"

namespace toile {

namespace {

using Clock = std::chrono::steady_clock;

/// A file descriptor, closed at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// The program toile: this one, even when a newer one has taken its path, or the one beside it.
std::string toile_program() {
  const std::filesystem::path self = "/proc/self/exe";
  const std::filesystem::path place = std::filesystem::read_symlink(self);
  return place.filename().string().starts_with("toile") ? self.string()
                                                        : (place.parent_path() / "toile").string();
}

/// Between fork and exec: only calls that a process of several threads may make there.
[[noreturn]] void become_child(const char* program, char** words, const ChildLimits& limits,
                               int output, pid_t parent) {
  setpgid(0, 0);
  // It ends with the batch, whatever ends that, and removes its temporary files.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  if (limits.memory) {
    const rlimit limit = {*limits.memory, *limits.memory};
    if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(127);
  }
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
      dup2(output, STDERR_FILENO) < 0) {
    _exit(127);
  }
  execv(program, words);
  _exit(127);
}

/// Milliseconds for poll(), rounded up.
int wait_until(const std::optional<Clock::time_point>& end) {
  if (!end) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, 3'600'000));
}

/// Appends what can be read now. False at the end.
bool read_some(int from, std::string& text) {
  constexpr std::size_t max_output = 4 << 20;
  std::array<char, 4096> buffer = {};
  const ssize_t size = read(from, buffer.data(), buffer.size());
  if (size < 0) return errno == EINTR;
  if (text.size() < max_output) text.append(buffer.data(), static_cast<std::size_t>(size));
  return size > 0;
}

}  // namespace

ChildEnd run_toile(const std::vector<std::string>& words, const ChildLimits& limits) {
  return run_program(toile_program(), words, limits);
}

ChildEnd run_program(const std::filesystem::path& program, const std::vector<std::string>& words,
                     const ChildLimits& limits) {
  // The link that names this program, not what it is a link to: toile tells its commands apart by
  // it.
  std::vector<std::string> all = {program == toile_program() ? "toile" : program.string()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  argv.reserve(all.size() + 1);
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);
  const auto fail = [](const char* what) {
    throw Error("a garment's process", std::string(what) + " (" + std::strerror(errno) + ")",
                "run fewer garments at once: -j");
  };
  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("can't be listened to");
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const auto start = Clock::now();
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) fail("can't be started");
  if (child == 0) become_child(program.c_str(), argv.data(), limits, to.number(), parent);
  setpgid(child, child);  // whichever of both is first
  to.close();

  ChildEnd ended;
  const Descriptor process(pidfd_open(child, 0));
  if (process.number() < 0) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    fail("can't be watched");
  }
  std::optional<Clock::time_point> end = limits.end;
  for (bool is_running = true, is_heard = true; is_running;) {
    std::array<pollfd, 3> waits = {pollfd{process.number(), POLLIN, 0},
                                   pollfd{is_heard ? from.number() : -1, POLLIN, 0},
                                   pollfd{ended.timed_out ? -1 : limits.stop, POLLIN, 0}};
    poll(waits.data(), waits.size(), wait_until(end));
    if (waits[1].revents != 0) is_heard = read_some(from.number(), ended.output);
    is_running = waits[0].revents == 0;
    const bool is_over = waits[2].revents != 0 || (end && Clock::now() >= *end);
    if (!is_running || !is_over) continue;
    // It may remove its temporary files first.
    kill(-child, ended.timed_out ? SIGKILL : SIGTERM);
    ended.timed_out = true;
    end = Clock::now() + std::chrono::seconds(2);
  }
  // What is left of its group holds no garment's files, nor the pipe.
  kill(-child, SIGKILL);
  while (read_some(from.number(), ended.output)) {
  }
  int status = 0;
  rusage used = {};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  ended.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  ended.peak_MiB = static_cast<double>(used.ru_maxrss) / 1024;
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  if (WIFEXITED(status)) ended.exit_code = WEXITSTATUS(status);
  return ended;
}

}  // namespace toile
