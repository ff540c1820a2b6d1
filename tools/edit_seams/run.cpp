#include "tools/edit_seams/run.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/text.h"
#include "io/view/seam_editor_page.h"
#include "pattern/file/pattern_file.h"
#include "tools/clean_body/scan.h"
#include "tools/edit_seams/pattern_check.h"
#include "tools/edit_seams/proposals.h"
#include "tools/edit_seams/server.h"
#include "tools/edit_seams/trial.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// The JSON of a file, as text. Throws Error when it is none.
std::string json_of(const fs::path& path) {
  std::string text = read_file(path);
  parse_json(text, path.string());
  return text;
}

/// Says what is remarkable in the pattern, and reports it. Throws Error when it is none, when the
/// proposals are another pattern's, and when the body can't be read.
void check_and_report(const EditSeamsSettings& settings, const CommonSettings& common) {
  std::vector<Remark> remarks;
  const Pattern pattern = read_pattern(settings.pattern, remarks);
  if (settings.proposals) {
    std::vector<Remark> said_before;
    read_proposals(
        *settings.proposals,
        parse_drawn_pattern(read_file(settings.pattern), settings.pattern.string(), said_before));
  }
  // To learn it when the garment is dressed would be late.
  if (settings.body) read_body_input({.inputs = {*settings.body}});
  say_remarks(remarks, common);
  nlohmann::ordered_json report = {{"pattern", settings.pattern.string()},
                                   {"served", settings.serve},
                                   {"panels", pattern.panels.size()},
                                   {"seams", pattern.stitches.size()}};
  add_remarks(remarks, report);
  OutputFiles files;
  write_report(files, common, report);
  files.commit();
}

SeamEditorPage page_of(const EditSeamsSettings& settings, const CommonSettings& common) {
  SeamEditorPage page;
  page.name =
      settings.serve ? common.output.filename().string() : settings.pattern.filename().string();
  page.pattern = json_of(settings.pattern);
  if (settings.proposals) page.proposals = json_of(*settings.proposals);
  page.served = settings.serve;
  if (settings.body) page.body = settings.body->filename().string();
  return page;
}

/// Tells a file's content from others; empty where there is no file.
std::string version_of(const fs::path& file) {
  std::error_code unreachable;
  if (!fs::exists(file, unreachable)) return "";
  return std::to_string(std::hash<std::string>{}(read_file(file)));
}

/// What the page asks of its server.
class Service {
 public:
  Service(const EditSeamsSettings& settings, const CommonSettings& common)
      : output_(common.output),
        input_page_(page_of(settings, common)),
        found_(version_of(output_)),
        trial_(settings, common.threads) {}

  Answer answer(const Request& request);

 private:
  Answer answer_to(const Request& request);
  std::string page() const;
  Answer save(const Request& request, const std::string& replaced);
  /// Throws Error when the page sent no pattern.
  static void check_pattern_of(const Request& request);
  /// The page need not know where the server keeps its files.
  std::string without_folder(std::string text) const;

  fs::path output_;
  SeamEditorPage input_page_;
  std::string found_;  // version of the output at the start: what this server did not save
  bool has_saved_ = false;
  Trial trial_;
};

void Service::check_pattern_of(const Request& request) {
  std::vector<Remark> remarks;
  parse_pattern(request.body, "pattern", remarks);
}

/// The page shows what was saved, else the input.
std::string Service::page() const {
  SeamEditorPage page = input_page_;
  const std::string now = version_of(output_);
  if (has_saved_ || now != found_) {
    page.pattern = json_of(output_);
    page.version = now;
  }
  return seam_editor_page(page);
}

/// Writes the output if it is still what the page knows it to be.
Answer Service::save(const Request& request, const std::string& replaced) {
  check_pattern_of(request);
  const std::string name = output_.filename().string();
  if (version_of(output_) != replaced) {
    return {409, "text/plain", name + " on disk is not what this page has shown or saved."};
  }
  write_file(OutputPath(output_), request.body);
  has_saved_ = true;
  return {200, "application/json",
          nlohmann::json{{"text", "Saved as " + valid_utf8(name) + "."},
                         {"version", version_of(output_)}}
              .dump()};
}

// No request waits for a program: others, and the end of the server, would wait with it.
Answer Service::answer_to(const Request& request) {
  const auto is = [&](const char* method, const char* target) {
    return request.method == method && request.target == target;
  };
  const auto data = [](const std::string& text) { return Answer{200, "application/json", text}; };
  if (is("GET", "")) return {200, "text/html; charset=utf-8", page()};
  constexpr std::string_view over = "pattern/over/";  // the version that is replaced follows
  if (request.method == "PUT" && request.target == "pattern") {
    return save(request, version_of(output_));
  }
  if (request.method == "PUT" && request.target.starts_with(over)) {
    return save(request, request.target.substr(over.size()));
  }
  if (is("POST", "check")) return data(pattern_check_json(request.body));
  if (is("POST", "propose")) {
    check_pattern_of(request);
    trial_.find_seams(request.body);
    return {200, "text/plain", ""};
  }
  if (is("POST", "dress")) {
    check_pattern_of(request);
    trial_.dress(request.body);
    return {200, "text/plain", ""};
  }
  if (is("GET", "propose/progress")) return data(without_folder(trial_.finding().progress()));
  if (is("GET", "dress/progress")) return data(without_folder(trial_.dressing().progress()));
  if (is("GET", "proposals")) return data(trial_.finding().result());
  if (is("GET", "drape")) return data(trial_.dressing().result());
  return {404, "text/plain", "There is nothing here."};
}

std::string Service::without_folder(std::string text) const {
  const std::string folder = trial_.folder().string() + "/";
  for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) {
    text.erase(at, folder.size());
  }
  return text;
}

Answer Service::answer(const Request& request) {
  try {
    return answer_to(request);
  } catch (const std::exception& problem) {
    return {422, "text/plain", without_folder(problem.what())};
  }
}

void serve(const EditSeamsSettings& settings, const CommonSettings& common) {
  Service service(settings, common);
  Server server(settings.port);
  // Nobody guesses the address: it is said with -q, too.
  std::cerr << "edit-seams: open " << server.address() << " (Ctrl+C ends it)" << std::endl;
  server.run([&](const Request& request) { return service.answer(request); });
}

}  // namespace

void run_edit_seams(const EditSeamsSettings& settings, const CommonSettings& common) {
  check_and_report(settings, common);
  if (settings.serve) {
    serve(settings, common);
    return;
  }
  OutputFile page(common.output);
  page.stream() << seam_editor_page(page_of(settings, common));
  page.commit();
  common.say("edit-seams: open " + common.output.string() + " in a browser");
}

}  // namespace toile
