#include "tools/edit_seams/trial.h"

#include <stdlib.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
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
  for (Background* work : {&finding_, &dressing_}) work->finish();
  close(stop_);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::vector<std::string> Trial::run(std::vector<std::string> words) const {
  words.insert(words.end(), {"-q", "--threads", std::to_string(threads_)});
  const ChildEnd ended = run_toile(words, {{}, {}, stop_});
  if (!is_done(ended)) throw Error(words.front(), reason_of(ended), "");
  return warnings_said(ended.output);
}

void Trial::find_seams(const std::string& pattern) {
  finding_.start([this, pattern](const Background::Say& say) {
    say("Finding seams …");
    const fs::path report = folder_ / "seams.json";
    write_file(OutputPath(folder_ / "pattern.json"), pattern);
    run({"find-seams", (folder_ / "pattern.json").string(), "-o", (folder_ / "sewn.json").string(),
         "--report", report.string()});
    return read_file(report);
  });
}

void Trial::dress(const std::string& pattern) {
  if (!settings_.body) throw Error("dress", "there is no body", "start edit-seams with --body");
  dressing_.start([this, pattern](const Background::Say& say) {
    write_file(OutputPath(folder_ / "tried.json"), pattern);
    return drape(say);
  });
}

std::string Trial::drape(const Background::Say& say) {
  const fs::path body = folder_ / "body.ply";
  const fs::path garment = folder_ / "garment.obj";
  const fs::path dressed = folder_ / "dressed.obj";
  if (!body_is_clean_) {
    say("Cleaning the body …");
    body_warnings_ =
        run({"clean-body", fs::absolute(*settings_.body).string(), "-o", body.string()});
    body_is_clean_ = true;
  }
  std::vector<std::string> warnings = body_warnings_;
  say("Meshing the panels …");
  const std::vector<std::string> of_meshing =
      run({"mesh-pattern", (folder_ / "tried.json").string(), "-o", garment.string(),
           "--edge-length", number_text(1000 * settings_.edge_length) + "mm"});
  warnings.insert(warnings.end(), of_meshing.begin(), of_meshing.end());
  say("Dressing …");
  run({"dress", "--body", body.string(), garment.string(), "-o", dressed.string(), "--report",
       (folder_ / "dressed.json").string(), "--quality", "figures", "--cache"});
  std::string made = drape_json(garment, dressed, folder_ / "dressed.json", body, warnings);
  say("Dressed.");
  return made;
}

}  // namespace toile
