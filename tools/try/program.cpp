// toile try: from a drawing to the page, with what was guessed on the way.
#include <algorithm>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "pattern/import/half_pieces.h"
#include "tools/find_seams/run.h"
#include "tools/fit/chain.h"
#include "tools/import_pattern/run.h"
#include "tools/make_mannequin/run.h"
#include "tools/programs.h"
#include "tools/report.h"
#include "tools/try/lay_aside.h"
#include "tools/try/taken.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

/// What the folder holds beside FitFiles.
struct TryFiles {
  explicit TryFiles(const fs::path& of)
      : folder(of),
        pattern(folder / "pattern.json"),
        import_report(folder / "import.json"),
        sewn(folder / "sewn.json"),
        seams_report(folder / "seams.json"),
        mannequin(folder / "mannequin.ply"),
        mannequin_skeleton(skeleton_path(mannequin)),
        mannequin_report(folder / "mannequin.json"),
        report(folder / "report.json"),
        fit(folder) {}

  /// What is written once the drawing is read.
  std::vector<fs::path> later() const {
    std::vector<fs::path> all = {sewn,   seams_report,    mannequin, mannequin_skeleton,
                                 report, mannequin_report};
    std::ranges::copy(fit.all(), std::back_inserter(all));
    return all;
  }

  fs::path folder;
  fs::path pattern, import_report;
  fs::path sewn, seams_report;
  fs::path mannequin, mannequin_skeleton, mannequin_report;
  fs::path report;
  FitFiles fit;
};

/// What the command line asks for.
struct TrySettings {
  ImportPatternSettings drawing;
  FindSeamsSettings seams;
  std::optional<MakeMannequinSettings> mannequin;  ///< none: a body is given
  FitSettings fit;
};

/// The command that shows the seams on the body, to correct them.
std::string edit_seams_command(const TrySettings& settings, const TryFiles& files) {
  return "toile edit-seams " + shell_word(files.sewn.string()) + " --serve --proposals " +
         shell_word(files.seams_report.string()) + " --body " +
         shell_word(settings.fit.dress.body.string()) + " -o " +
         shell_word((files.folder / "corrected.json").string());
}

/// What to do where no seam was found. Halves have none where whole pieces have theirs.
std::string remedy_for_no_seams(const ImportEnd& imported, const std::string& edit_seams) {
  const bool has_halves =
      std::ranges::any_of(imported.pattern.panels,
                          [](const ImportedPanel& panel) { return panel.likely_fold.has_value(); });
  return "draw them: " + edit_seams +
         (has_halves ? "; if halves are drawn, unfold them first, as said above" : "");
}

void say(const std::vector<Taken>& all) {
  for (const Taken& taken : all) std::cout << line_of(taken) << '\n';
}

/// ", with undecided seams": what is wrong besides the verdict.
std::string besides(const std::vector<std::string>& reasons) {
  std::string text;
  for (std::string reason : reasons) {
    if (reason == "verdict") continue;
    std::ranges::replace(reason, '_', ' ');
    text += (text.empty() ? ", with " : ", ") + reason;
  }
  return text;
}

/// Share of what is dressed that a panel may be to be spare: a placket, an interfacing, a binding.
/// Of 29 drawings, a tank's binding is 0.048, a polo's placket 0.014, a T-shirt's sleeve 0.34. With
/// half of it the tank is `unsewable`, with double none changes.
constexpr double largest_spare = 0.05;

/// Whether a panel may belong to the rest by a seam that is not decided.
bool has_undecided_seam(const std::vector<LeftOut>& panels, const FindSeamsEnd& seams) {
  return std::ranges::any_of(seams.undecided, [&](const UndecidedSeam& seam) {
    const bool first = std::ranges::any_of(
        panels, [&](const LeftOut& panel) { return seam.name.starts_with(panel.name + ":"); });
    const std::string second_side = seam.name.substr(0, seam.name.rfind(':') + 1);
    const bool second = std::ranges::any_of(panels, [&](const LeftOut& panel) {
      return second_side.ends_with(" " + panel.name + ":");
    });
    return first != second;
  });
}

std::set<std::string> panels_of(const AskedPlaces& places) {
  std::set<std::string> panels;
  for (const auto& [panel, place] : places) panels.insert(panel);
  return panels;
}

ExitCode try_drawing(const TrySettings& settings, const TryFiles& files,
                     const CommonSettings& common) {
  common.say("Reading the drawing:");
  const ImportEnd imported = run_import_pattern(
      settings.drawing, step_of(common, "import-pattern", files.pattern, files.import_report));
  remove_earlier(files.later());
  std::vector<std::string> reasons;
  if (!imported.pattern.left_out.empty()) reasons.emplace_back("left_out_pieces");
  if (settings.mannequin) {
    common.say("Making the body:");
    const CommonSettings step =
        step_of(common, "make-mannequin", files.mannequin, files.mannequin_report);
    if (run_make_mannequin(*settings.mannequin, step) != exit_done) {
      reasons.emplace_back("missed_measures");
    }
  }
  const CleanBodyResult body = fit_body(settings.fit, files.fit, common);
  common.say("Finding the seams:");
  const FindSeamsEnd seams =
      run_find_seams(settings.seams, step_of(common, "find-seams", files.sewn, files.seams_report));
  if (!seams.undecided.empty()) reasons.emplace_back("undecided_seams");
  const std::string edit_seams = edit_seams_command(settings, files);
  LaidAside aside;
  std::vector<Taken> all;
  FitEnd end;
  try {
    all = taken_for_granted(imported, seams, aside.panels, edit_seams);
    check_pattern_file(files.sewn, remedy_for_no_seams(imported, edit_seams));
    // Drawings state no places. Without a seam nothing tells where a panel goes.
    if (!imported.drawing.pieces.empty()) {
      aside = lay_aside(files.sewn, panels_of(settings.fit.dress.layers.front().places));
    }
    if (!aside.panels.empty()) reasons.emplace_back("loose_panels");
    all = taken_for_granted(imported, seams, aside.panels, edit_seams);
    end = fit_pattern(settings.fit, files.fit, body, common);
  } catch (...) {
    say(all);  // a wrong guess may be why
    throw;
  }
  if (!end.body_is_usable) reasons.emplace_back("unreliable_body");
  if (!end.keeps_spec) reasons.emplace_back("out_of_spec");
  if (end.dress.verdict != Verdict::sewn) reasons.emplace_back("verdict");
  // What was dressed may be sewn. The garment that was drawn is not.
  const bool lacks_seams =
      end.dress.verdict == Verdict::sewn &&
      (aside.largest > largest_spare || has_undecided_seam(aside.panels, seams));
  const std::string verdict = to_string(lacks_seams ? Verdict::unsewable : end.dress.verdict);
  Json report = {{"drawing", settings.drawing.drawing.string()},
                 {"body", settings.fit.body.inputs.front().string()},
                 {"taken", Json::array()},
                 {"verdict", verdict},
                 {"reason", reasons}};
  for (const Taken& taken : all) {
    report["taken"].push_back({{"what", taken.what},
                               {"taken", valid_utf8(taken.taken)},
                               {"change", valid_utf8(taken.change)}});
  }
  CommonSettings of_report = common;
  of_report.report = files.report;
  OutputFiles written;
  write_report(written, of_report, report);
  written.commit();
  say(all);  // below all progress
  std::cout << verdict << besides(reasons) << ": see " << files.fit.ease.string() << " and "
            << files.report.string() << std::endl;
  return reasons.empty() ? exit_done : exit_negative;
}

Job prepare_try(const po::variables_map& given, const CommonSettings& common) {
  const TryFiles files(common.output);
  TrySettings settings;
  settings.drawing.drawing = given["drawing"].as<std::string>();
  read_import_options(given, settings.drawing);
  settings.drawing.makes_whole = true;
  settings.seams.pattern = files.pattern;
  settings.seams.keep = true;  // a pattern in JSON may have seams
  read_seam_options(given, settings.seams);
  fs::path body = files.mannequin;
  if (given.count("measures") != 0) {
    MeasureSettings measures;
    add_measures(given["measures"].as<std::vector<std::string>>(), measures);
    measures.scales_edges = true;
    settings.mannequin.emplace();
    settings.mannequin->mannequin.pose_name = "standing";
    settings.mannequin->measures = measures;
  } else {
    body = given["body"].as<std::string>();
  }
  read_fit_options(given, body, files.fit, settings.fit);
  settings.fit.pattern.pattern = files.sewn;
  Job job;
  job.files = files_of(settings.fit, files.fit);
  job.files.reads.push_back(settings.drawing.drawing);
  if (settings.mannequin) {
    // The body is written, and read by a later step.
    std::erase(job.files.reads, files.mannequin);
    std::erase(job.files.reads, skeleton_beside(files.mannequin));
    std::ranges::copy(settings.mannequin->measures->files, std::back_inserter(job.files.reads));
  }
  job.files.writes = files.later();
  job.files.writes.push_back(files.pattern);
  job.files.writes.push_back(files.import_report);
  job.work = [settings, files, &common] { return try_drawing(settings, files, common); };
  return job;
}

}  // namespace

CommandLineProgram try_program() {
  CommandLineProgram program;
  program.name = "toile try";
  program.summary =
      "dresses a body with a drawing: reads it, finds its seams, says what it guessed";
  program.usage = "DRAWING --body BODY | --measures FILE -o OUT/ [options]";
  program.options.add_options()("drawing", po::value<std::string>()->required(),
                                "a DXF or SVG drawing, or a pattern; also as argument")(
      "body", po::value<std::string>(),
      "a mesh or scan of a standing person; with --from, a posed body")(
      "measures", po::value<std::vector<std::string>>()->composing(),
      "instead of a body: a file of measures or NAME=NUMBER, as of make-mannequin; may be "
      "repeated");
  add_import_options(program.options);
  add_seam_options(program.options);
  add_fit_options(program.options);
  program.positional.add("drawing", 1);
  program.writes_folder = true;
  program.check = [](const po::variables_map& given) {
    if (given.count("body") + given.count("measures") != 1) {
      throw po::error("give --body BODY or --measures FILE, one of them");
    }
    if (given.count("measures") != 0 && given.count("from") != 0) {
      throw po::error("--from is for a posed body: give it by --body");
    }
    check_method_options(given);
    check_pom_options(given, true);
  };
  program.prepare = prepare_try;
  return program;
}

}  // namespace toile
