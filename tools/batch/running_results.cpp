#include "tools/batch/running_results.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "tools/batch/contact_sheet.h"

namespace toile {

namespace {

using Clock = std::chrono::steady_clock;

/// How soon a signal is seen.
constexpr std::chrono::milliseconds look_every{100};
/// From one writing to the next.
constexpr Clock::duration min_pause = std::chrono::seconds(2);
/// A pause is at least that many times as long as the writing before it.
constexpr int pause_per_writing = 20;

}  // namespace

RunningResults::RunningResults(const Batch& batch, const BatchFiles& files, RowReports reports)
    : batch_(batch), files_(files), reports_(std::move(reports)) {
  write();
  signals_wait_.emplace();
  watching_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

RunningResults::~RunningResults() {
  stop();
  try {
    if (!is_written_) write();
  } catch (const Error&) {
    // What is under way says what is wrong.
  }
}

void RunningResults::add(std::size_t row, nlohmann::ordered_json report) {
  const std::lock_guard lock(of_reports_);
  reports_[row] = std::move(report);
  is_written_ = false;
}

const RowReports& RunningResults::finish() {
  stop();
  OutputFiles output;
  put_in(output);
  output.add(files_.summary, summary_of(reports_));
  output.commit();
  is_written_ = true;
  return reports_;
}

void RunningResults::put_in(OutputFiles& output) const {
  output.add(files_.results, results_csv(batch_, reports_));
  output.add(files_.sheet, contact_sheet(reports_));
}

void RunningResults::write() {
  OutputFiles output;
  put_in(output);
  output.commit();
  is_written_ = true;
}

void RunningResults::watch(const std::stop_token& stop) {
  std::condition_variable_any stopped;
  std::unique_lock lock(of_reports_);
  Clock::time_point next;
  while (!stopped.wait_for(lock, stop, look_every, [&] { return stop.stop_requested(); })) {
    const bool is_ending = SignalsWait::has_come();
    if (!is_written_ && (is_ending || Clock::now() >= next)) {
      const auto start = Clock::now();
      try {
        write();
      } catch (const Error&) {
        // finish() tries again, and says what is wrong.
      }
      const auto end = Clock::now();
      next = end + std::max(min_pause, pause_per_writing * (end - start));
    }
    if (is_ending) signals_wait_.reset();  // ends the program
  }
}

void RunningResults::stop() {
  watching_.request_stop();
  if (watching_.joinable()) watching_.join();
  signals_wait_.reset();
}

}  // namespace toile
