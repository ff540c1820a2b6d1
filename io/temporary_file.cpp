#include "io/temporary_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
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

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& path) : name_(path) {
  // The process id keeps the temporary files of two runs apart that write the same file.
  name_ += ".part" + std::to_string(getpid());
  slot_ = take_slot(fs::absolute(name_).string());
}

TemporaryFile::~TemporaryFile() {
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

SignalsWait::~SignalsWait() {
  if (--waits > 0) return;
  if (const int signal = waiting_signal.exchange(0); signal != 0) std::raise(signal);
}

}  // namespace toile
