#include "tools/batch/dress_row.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/checksum.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tools/batch/outcome.h"
#include "tools/child.h"
#include "tools/program.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The message of a program that failed: what follows "PROGRAM: error: " in its last such line.
std::string message_of(const std::string& output) {
  const std::string mark = ": error: ";
  const std::size_t at = output.rfind(mark);
  if (at == std::string::npos) {
    const std::size_t end = output.find_last_not_of('\n');
    if (end == std::string::npos) return "";
    const std::size_t start = output.rfind('\n', end);
    const std::size_t first = start == std::string::npos ? 0 : start + 1;
    return valid_utf8(output.substr(first, end + 1 - first));
  }
  const std::size_t start = at + mark.size();
  return valid_utf8(output.substr(start, output.find('\n', start) - start));
}

/// Why a process did not do its work; empty: it did.
std::string problem_of(const ChildEnd& ended, const RowLimits& limits) {
  if (ended.timed_out) {
    return "time: out of time; it may take " + number_text(*limits.seconds) +
           " s, give more by --timeout";
  }
  if (ended.signal != 0) {
    return std::string("crash: ended by signal ") + std::to_string(ended.signal) + " (" +
           strsignal(ended.signal) + "); report it together with the input";
  }
  if (ended.exit_code == exit_done || ended.exit_code == exit_negative) return "";
  std::string message = message_of(ended.output);
  if (limits.memory && message.starts_with("out of memory"))
    message += ", or give more by --memory";
  return message.empty() ? "exit code: " + std::to_string(ended.exit_code) : message;
}

/// When what starts now has to be done.
std::optional<Clock::time_point> end_by(const RowLimits& limits) {
  if (!limits.seconds) return std::nullopt;
  constexpr double max_seconds = 1e9;  // a clock can count them
  const std::chrono::duration<double> seconds(std::min(*limits.seconds, max_seconds));
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(seconds);
}

/// The programs of one garment, one after another.
class RowRun {
 public:
  RowRun(const GarmentFiles& files, const RowLimits& limits)
      : files_(files), limits_(limits), end_(end_by(limits)) {}

  /// Writes the problem to the log, and throws Failed.
  [[noreturn]] void fail(const std::string& program, const std::string& problem);
  /// Seconds. An output that is empty is none. Throws Failed.
  double run(const std::string& program, const fs::path& output, Words words);

  /// Gives the programs to come the whole time of a garment again.
  void renew_time() { end_ = end_by(limits_); }

  double seconds() const { return seconds_since(start_); }
  double peak_memory() const { return peak_memory_; }  // MiB

  struct Failed {
    std::string program, problem;
  };

 private:
  const GarmentFiles& files_;
  const RowLimits& limits_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> end_;
  double peak_memory_ = 0;
};

void RowRun::fail(const std::string& program, const std::string& problem) {
  std::ofstream(files_.log, std::ios::app | std::ios::binary)
      << "toile batch: " << program << " failed: " << problem << '\n';
  throw Failed{program, problem};
}

double RowRun::run(const std::string& program, const fs::path& output, Words words) {
  words.insert(words.begin(), program);
  if (!output.empty()) words.insert(words.end(), {"-o", output.string()});
  words.insert(words.end(), {"--threads", std::to_string(limits_.threads)});
  const ChildEnd ended = run_toile(words, {end_, limits_.memory});
  peak_memory_ = std::max(peak_memory_, ended.peak_MiB);
  std::ofstream log(files_.log, std::ios::app | std::ios::binary);
  log << "toile";
  for (const std::string& word : words) log << ' ' << word;
  log << '\n' << ended.output;
  const std::string problem = problem_of(ended, limits_);
  log.close();
  if (!problem.empty()) fail(program, problem);
  return ended.seconds;
}

/// The `warnings` of a program's report.
std::vector<Warning> warnings_of_report(const fs::path& report) {
  const JsonDocument document(read_file(report), report.string());
  return read_warnings(document.root());
}

}  // namespace

CleanedBody clean_body_of_batch(const fs::path& body, const fs::path& output,
                                const RowLimits& limits) {
  const fs::path report = fs::path(output).replace_extension("report.json");
  const ChildEnd ended = run_toile({"clean-body", body.string(), "-o", output.string(), "--report",
                                    report.string(), "--threads", std::to_string(limits.threads)},
                                   {end_by(limits), limits.memory});
  write_file(fs::path(output).replace_extension("log.txt"), ended.output);
  CleanedBody cleaned{output, problem_of(ended, limits)};
  cleaned.is_usable = cleaned.problem.empty() && ended.exit_code == exit_done;
  if (cleaned.problem.empty()) cleaned.warnings = warnings_of_report(report);
  return cleaned;
}

Json dress_row(const BatchRow& row, const CleanedBody& body, const GarmentFiles& files,
               const RowLimits& limits) {
  RowRun run(files, limits);
  Json times = Json::object();
  Json outcome;
  try {
    if (!body.problem.empty()) run.fail("clean-body", body.problem);
    const Words on_body = {"--body", body.file.string(), files.dressed.string()};
    const auto with = [&](Words more) {
      more.insert(more.begin(), on_body.begin(), on_body.end());
      return more;
    };
    times["mesh_seconds"] = run.run("mesh-pattern", files.garment,
                                    {row.pattern.string(), "--edge-length", row.edge_length,
                                     "--report", files.mesh_report.string()});
    Words dress = {"--body",   body.file.string(),          files.garment.string(),
                   "--report", files.dress_report.string(), "--cache"};
    for (const std::string& fabric : row.fabrics) dress.insert(dress.end(), {"--fabric", fabric});
    dress.insert(dress.end(), row.options.begin(), row.options.end());
    times["dress_seconds"] = run.run("dress", files.dressed, dress);
    outcome = outcome_of(read_file(files.dress_report), files.dress_report.string());
    // A drape that took nearly all of the time keeps its verdict.
    run.renew_time();
    run.run("ease-map", limits.pictures ? files.ease : fs::path(),
            with({"--report", files.ease_report.string()}));
    add_girth_ease(read_file(files.ease_report), files.ease_report.string(), outcome["figures"]);
    if (limits.pictures) {
      run.run("render", files.front, with({"--views", "front", "--whole", "--width", "420"}));
      run.run("render", files.back, with({"--views", "back", "--whole", "--width", "420"}));
    }
    for (const fs::path& file : files.made(limits.pictures)) {
      outcome["outputs"][file.filename().string()] = sha256_of_file(file);
    }
    std::vector<Warning> warnings = body.warnings;
    for (const fs::path& report : {files.mesh_report, files.dress_report}) {
      std::ranges::move(warnings_of_report(report), std::back_inserter(warnings));
    }
    outcome["warnings"] = warnings_json(warnings);
  } catch (const RowRun::Failed& failed) {
    outcome = failure(failed.program, failed.problem);
  } catch (const Error& failed) {
    outcome = failure("batch", failed.what());
  }
  outcome.update(times);
  outcome["body_usable"] = body.is_usable;
  outcome["seconds"] = run.seconds();
  outcome["peak_MiB"] = run.peak_memory();
  return outcome;
}

}  // namespace toile
