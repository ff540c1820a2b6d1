// The table and the page of a batch that runs.
#pragma once

#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <thread>

#include "io/output_file.h"
#include "io/temporary_file.h"
#include "tools/batch/files.h"
#include "tools/batch/manifest.h"
#include "tools/batch/results.h"

namespace toile {

/// Keeps results.csv and index.html of a batch up to date while it runs. Rows that are kept are
/// there from the start, a row that ends within some seconds. Both files are put in place whole.
/// That takes a twentieth of the time at most, however many rows there are. A signal that ends the
/// program waits until what has ended is written.
class RunningResults {
 public:
  /// `reports` of rows that are not done are null. Throws Error where the files can't be written.
  RunningResults(const Batch& batch, const BatchFiles& files, RowReports reports);
  /// Writes what is not written, where that is possible.
  ~RunningResults();
  RunningResults(const RunningResults&) = delete;
  RunningResults& operator=(const RunningResults&) = delete;

  /// A row has ended. May be called from several threads at once.
  void add(std::size_t row, nlohmann::ordered_json report);

  /// Writes both files a last time, as one set with summary.md, and gives the reports. Nothing is
  /// added from then on. Throws Error where a file can't be written.
  const RowReports& finish();

 private:
  void put_in(OutputFiles& output) const;
  void write();
  void watch(const std::stop_token& stop);
  void stop();

  const Batch& batch_;
  const BatchFiles& files_;
  std::mutex of_reports_;
  RowReports reports_;
  bool is_written_ = false;  // all that reports_ have
  std::optional<SignalsWait> signals_wait_;
  std::jthread watching_;
};

}  // namespace toile
