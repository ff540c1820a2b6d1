#include "tools/batch/run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "geometry/error.h"
#include "io/checksum.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "tools/batch/results.h"
#include "tools/batch/row_report.h"
#include "tools/batch/running_results.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// Calls work(0) to work(count - 1), `jobs` at once. An exception ends it after what is under way.
void for_each_at_once(std::size_t count, std::size_t jobs,
                      const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failed;
  std::mutex of_failed;
  {
    std::vector<std::jthread> workers;
    for (std::size_t j = 0; j < std::min(jobs, count); ++j) {
      workers.emplace_back([&] {
        try {
          for (std::size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
          next = count;
          const std::lock_guard lock(of_failed);
          if (!failed) failed = std::current_exception();
        }
      });
    }
  }
  if (failed) std::rethrow_exception(failed);
}

/// "1 h 20 min", "3 min", "40 s".
std::string duration_text(double seconds) {
  const auto all = static_cast<long>(seconds);
  if (all < 100) return std::to_string(all) + " s";
  const long minutes = (all + 30) / 60;
  if (minutes < 100) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

class BatchRun {
 public:
  BatchRun(const BatchSettings& settings, const CommonSettings& common)
      : settings_(settings),
        common_(common),
        rows_(settings.batch.rows),
        files_(settings.output),
        keys_(rows_.size()) {}

  int run();

 private:
  GarmentFiles files_of(std::size_t row) const {
    return GarmentFiles(settings_.output / rows_[row].name);
  }
  /// The reports of what is kept; null: the row is to be run.
  RowReports find_what_is_left();
  void remove_earlier() const;
  void clean_bodies();
  void dress(std::size_t row, RunningResults& results);
  void say_progress(std::size_t row, const Json& report);

  const BatchSettings& settings_;
  const CommonSettings& common_;
  const std::vector<BatchRow>& rows_;
  BatchFiles files_;
  std::vector<Json> keys_;
  std::vector<std::size_t> left_;  // rows that are to be run
  std::map<fs::path, CleanedBody> bodies_;
  std::mutex of_progress_;
  std::size_t done_ = 0;
  Clock::time_point start_;
};

RowReports BatchRun::find_what_is_left() {
  RowKeys keys(settings_.limits);
  for (std::size_t i = 0; i < rows_.size(); ++i) keys_[i] = keys.key_of(rows_[i]);
  RowReports kept(rows_.size());
  if (settings_.resume) {
    for_each_at_once(rows_.size(), settings_.jobs, [&](std::size_t i) {
      if (auto report = kept_report(files_of(i), keys_[i], settings_.limits.pictures))
        kept[i] = std::move(*report);
    });
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (kept[i].is_null()) left_.push_back(i);
  }
  return kept;
}

/// The files of all garments that are to be run, before the first: a batch that is killed leaves
/// none of them.
void BatchRun::remove_earlier() const {
  remove_files({files_.summary});
  for (const std::size_t i : left_) {
    const GarmentFiles files = files_of(i);
    std::error_code failed;
    fs::create_directories(files.folder, failed);
    if (failed) throw Error(files.folder.string(), "can't be made", failed.message());
    std::vector<fs::path> all = files.made();
    all.insert(all.begin(), files.report);  // without it, nothing there counts
    all.push_back(files.log);
    remove_files(all);
  }
}

/// Each body once. Two of one name get names by their content, whatever their order.
void BatchRun::clean_bodies() {
  std::map<std::string, std::set<fs::path>> named;
  for (const BatchRow& row : rows_) named[row.body.stem().string()].insert(row.body);
  for (const std::size_t i : left_) {
    const fs::path& body = rows_[i].body;
    std::string name = body.stem().string();
    if (named[name].size() > 1) {
      const Json& checksum = keys_[i]["inputs"]["body"]["sha256"];
      // Two paths of one content may stand beside different joints.
      const std::string path = sha256(fs::absolute(body).lexically_normal().string());
      name += "-" + (checksum.is_null() ? "" : checksum.get<std::string>().substr(0, 8) + "-") +
              path.substr(0, 8);
    }
    bodies_[body] = {files_.bodies / (name + ".ply"), ""};
  }
  fs::create_directories(files_.bodies);
  std::vector<std::pair<const fs::path, CleanedBody>*> all;
  for (auto& body : bodies_) {
    const fs::path& file = body.second.file;
    remove_files({file, skeleton_path(file), fs::path(file).replace_extension("distances"),
                  fs::path(file).replace_extension("log.txt"),
                  fs::path(file).replace_extension("report.json")});
    all.push_back(&body);
  }
  for_each_at_once(all.size(), settings_.jobs, [&](std::size_t i) {
    all[i]->second = clean_body_of_batch(all[i]->first, all[i]->second.file, settings_.limits);
  });
  for (const auto& [body, cleaned] : bodies_) {
    for (const Warning& warning : cleaned.warnings) {
      CommonSettings::warn(body.string() + ": " + warning.text);
    }
  }
}

void BatchRun::say_progress(std::size_t row, const Json& report) {
  const std::size_t left = left_.size() - ++done_;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string line = rows_[row].name + ": " + report["verdict"].get<std::string>();
  if (const auto cause = report["cause"].get<std::string>(); !cause.empty()) line += ", " + cause;
  line += ", " + fixed_number(report["seconds"].get<double>(), 1) +
          " s; left: " + std::to_string(left) + " of " + std::to_string(rows_.size());
  if (left > 0) {
    const double each = seconds / static_cast<double>(done_);
    line += ", some " + duration_text(each * static_cast<double>(left));
  }
  common_.say(line);
}

void BatchRun::dress(std::size_t row, RunningResults& results) {
  const GarmentFiles files = files_of(row);
  const Json outcome = dress_row(rows_[row], bodies_.at(rows_[row].body), files, settings_.limits);
  const Json report = write_report(files, keys_[row], outcome);
  results.add(row, report);
  const std::lock_guard lock(of_progress_);
  say_progress(row, report);
}

int BatchRun::run() {
  for (const std::string& note : settings_.batch.notes) common_.say("note: " + note);
  RowReports kept_reports = find_what_is_left();
  const std::size_t kept = rows_.size() - left_.size();
  if (kept > 0)
    common_.say(std::to_string(kept) + " of " + std::to_string(rows_.size()) +
                " garments are done already and kept");
  remove_earlier();
  RunningResults results(settings_.batch, files_, std::move(kept_reports));
  clean_bodies();
  start_ = Clock::now();
  for_each_at_once(left_.size(), settings_.jobs, [&](std::size_t i) { dress(left_[i], results); });
  const RowReports& reports = results.finish();
  std::cout << summary_of(reports) << std::flush;
  return exit_code_of(reports);
}

}  // namespace

void refuse_inputs_in(const BatchSettings& settings) {
  const fs::path folder = fs::weakly_canonical(settings.output);
  const auto refuse = [&](const fs::path& file) {
    const fs::path holder = fs::weakly_canonical(file).parent_path();
    const auto ends = std::mismatch(folder.begin(), folder.end(), holder.begin(), holder.end());
    if (ends.first != folder.end()) return;
    throw Error(file.string(), "lies in the folder that is written",
                "give -o another folder than that of the inputs");
  };
  std::set<fs::path> seen;
  for (const BatchRow& row : settings.batch.rows) {
    refuse(row.pattern);
    if (seen.insert(row.body).second) refuse(row.body);
    for (const fs::path& file : row.fabric_files) {
      if (seen.insert(file).second) refuse(file);
    }
  }
}

int run_batch(const BatchSettings& settings, const CommonSettings& common) {
  return BatchRun(settings, common).run();
}

}  // namespace toile
