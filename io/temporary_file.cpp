#include "io/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "geometry/error.h"

namespace toile {

namespace fs = std::filesystem;

namespace {

/// The names of the temporary files, where a signal's handler may read them: it must not allocate.
struct Slot {
  std::atomic<bool> taken = false;
  std::atomic<bool> named = false;
  std::array<char, 4096> name = {};  // no longer path can be opened
};

// Of a scene of 100 layers and its report. Of more files than that, the rest would be left behind.
constexpr std::size_t slots_count = 256;
std::array<Slot, slots_count> slots;

std::atomic<int> waits = 0;           // how many SignalsWait there are
std::atomic<int> waiting_signal = 0;  // what came meanwhile; 0: nothing

std::size_t take_slot(const std::string& name) {
  for (std::size_t i = 0; i < slots_count; ++i) {
    if (name.size() >= slots[i].name.size() || slots[i].taken.exchange(true)) continue;
    std::copy(name.begin(), name.end(), slots[i].name.begin());
    slots[i].name[name.size()] = '\0';
    slots[i].named = true;
    return i;
  }
  return slots_count;
}

void free_slot(std::size_t slot) {
  if (slot == slots_count) return;
  slots[slot].named = false;
  slots[slot].taken = false;
}

void end_by(int signal) {
  for (const Slot& slot : slots) {
    if (slot.named) unlink(slot.name.data());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

extern "C" void on_signal(int signal) {
  if (waits > 0) {
    waiting_signal = signal;
  } else {
    end_by(signal);
  }
}

/// The end of a temporary file's name: 36^8 of them, from the system's source of chance.
std::string random_ending() {
  constexpr std::string_view characters = "abcdefghijklmnopqrstuvwxyz0123456789";
  constexpr int length = 8;  // a longer name than the file's own might be too long for the disk
  std::random_device source;
  std::uniform_int_distribution<std::size_t> any(0, characters.size() - 1);
  std::string ending = ".part";
  for (int i = 0; i < length; ++i) ending += characters[any(source)];
  return ending;
}

}  // namespace

int make_new_file(const fs::path& name) {
  constexpr mode_t mode = 0666;  // less what the umask takes away
  int descriptor = -1;
  do {
    descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

TemporaryFile::TemporaryFile(const fs::path& path) : slot_(slots_count) {
  constexpr int tries = 100;
  const SignalsWait wait;  // a file that is made has its slot
  for (int i = 0; i < tries && !is_open(); ++i) {
    name_ = path;
    name_ += random_ending();
    descriptor_ = make_new_file(name_);
    if (!is_open() && errno != EEXIST) break;
  }
  if (is_open()) {
    slot_ = take_slot(fs::absolute(name_).string());
  } else {
    name_.clear();
  }
}

bool TemporaryFile::close() {
  if (!is_open()) return true;
  const int descriptor = descriptor_;
  descriptor_ = -1;
  return ::close(descriptor) == 0;
}

TemporaryFile::~TemporaryFile() {
  close();
  std::error_code ignored;
  if (!name_.empty()) fs::remove(name_, ignored);
  free_slot(slot_);
}

void TemporaryFile::put_in_place(const fs::path& path) {
  std::error_code failed;
  fs::rename(name_, path, failed);
  if (failed) throw Error(path.string(), "could not be put in place", failed.message());
  name_.clear();
}

void remove_temporary_files_on_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGXCPU}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = on_signal;
    sigaction(signal, &action, nullptr);
  }
}

SignalsWait::SignalsWait() { ++waits; }

bool SignalsWait::has_come() { return waiting_signal != 0; }

SignalsWait::~SignalsWait() {
  if (--waits > 0) return;
  if (const int signal = waiting_signal.exchange(0); signal != 0) std::raise(signal);
}

}  // namespace toile
