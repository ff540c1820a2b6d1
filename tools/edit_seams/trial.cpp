#include "tools/edit_seams/trial.h"

#include <stdlib.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/error.h"
#include "io/output_file.h"
#include "tools/child.h"
#include "tools/edit_seams/drape_data.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "toile-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw Error(name, "can't be made", "free some space for temporary files");
  }
  return name;
}

/// The last line that a program said, as the reason why it failed.
std::string reason_of(const ChildEnd& ended) {
  std::string said = ended.output;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  const std::size_t last = said.rfind('\n');
  return last == std::string::npos ? said : said.substr(last + 1);
}

/// What follows "warning: " in each line that begins so.
std::vector<std::string> warnings_said(const std::string& output) {
  constexpr std::string_view mark = "warning: ";
  std::vector<std::string> warnings;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(mark)) warnings.push_back(line.substr(mark.size()));
  }
  return warnings;
}

bool is_done(const ChildEnd& ended) {
  return ended.signal == 0 && (ended.exit_code == exit_done || ended.exit_code == exit_negative);
}

}  // namespace

Trial::Trial(const EditSeamsSettings& settings, int threads)
    : settings_(settings),
      threads_(threads),
      folder_(new_folder()),
      stop_(eventfd(0, EFD_CLOEXEC)) {}

Trial::~Trial() {
  eventfd_write(stop_, 1);
  if (work_.joinable()) work_.join();
  close(stop_);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Trial::find_seams(const fs::path& pattern) const {
  const fs::path report = folder_ / "seams.json";
  const ChildEnd ended =
      run_toile({"find-seams", pattern.string(), "-q", "-o", (folder_ / "sewn.json").string(),
                 "--report", report.string(), "--threads", std::to_string(threads_)},
                {{}, {}, stop_});
  if (!is_done(ended)) throw Error("find-seams", reason_of(ended), "");
  return read_file(report);
}

void Trial::set(const std::string& state, const std::string& text) {
  const std::lock_guard lock(mutex_);
  state_ = state;
  text_ = text;
}

void Trial::start(const fs::path& pattern) {
  if (!settings_.body) throw Error("dress", "there is no body", "start edit-seams with --body");
  {
    const std::lock_guard lock(mutex_);
    if (state_ == "working") throw Error("dress", "a garment is being dressed", "wait for it");
    state_ = "working";
    text_ = "";
  }
  if (work_.joinable()) work_.join();
  // The next request may write another pattern.
  fs::copy_file(pattern, folder_ / "tried.json", fs::copy_options::overwrite_existing);
  work_ = std::thread([this] {
    try {
      run();
    } catch (const std::exception& problem) {
      set("failed", problem.what());
    }
  });
}

std::vector<std::string> Trial::step(const std::string& text, std::vector<std::string> words) {
  set("working", text);
  words.insert(words.end(), {"-q", "--threads", std::to_string(threads_)});
  const ChildEnd ended = run_toile(words, {{}, {}, stop_});
  if (!is_done(ended)) throw Error(words.front(), reason_of(ended), "");
  return warnings_said(ended.output);
}

void Trial::run() {
  const fs::path body = folder_ / "body.ply";
  const fs::path garment = folder_ / "garment.obj";
  const fs::path dressed = folder_ / "dressed.obj";
  if (!body_is_clean_) {
    body_warnings_ =
        step("Cleaning the body …",
             {"clean-body", fs::absolute(*settings_.body).string(), "-o", body.string()});
    body_is_clean_ = true;
  }
  std::vector<std::string> warnings = body_warnings_;
  const std::vector<std::string> of_meshing =
      step("Meshing the panels …",
           {"mesh-pattern", (folder_ / "tried.json").string(), "-o", garment.string(),
            "--edge-length", number_text(1000 * settings_.edge_length) + "mm"});
  warnings.insert(warnings.end(), of_meshing.begin(), of_meshing.end());
  step("Dressing …", {"dress", "--body", body.string(), garment.string(), "-o", dressed.string(),
                      "--report", (folder_ / "dressed.json").string(), "--cache"});
  std::string drape = drape_json(garment, dressed, folder_ / "dressed.json", body, warnings);
  const std::lock_guard lock(mutex_);
  drape_ = std::move(drape);
  state_ = "done";
  text_ = "Dressed.";
}

std::string Trial::progress() const {
  const std::lock_guard lock(mutex_);
  return nlohmann::json{{"state", state_}, {"text", text_}}.dump();
}

std::string Trial::drape() const {
  const std::lock_guard lock(mutex_);
  if (drape_.empty()) throw Error("drape", "there is none", "dress the garment first");
  return drape_;
}

}  // namespace toile
