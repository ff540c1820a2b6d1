#include "tools/ease_map/run.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cloth/ease/standing_measures.h"
#include "cloth/judge/fit.h"
#include "cloth/loads/inner_face.h"
#include "cloth/scene/closed_body.h"
#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "pattern/file/garment_file.h"
#include "tools/ease_map/exchange.h"
#include "tools/ease_map/page.h"
#include "tools/ease_map/pdf.h"
#include "tools/ease_map/report.h"
#include "tools/ease_map/worn_loads.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// Share of the weight by which the skin's forces may miss it. Drapes that hang freely miss by 1.3
/// % at most, and cloth that bounds hold by five times the weight and more. So half or double of it
/// tells the same ones.
constexpr double unsure_loads = 0.05;

/// What the report of dress beside the garment says; none, with a note, where there is no such
/// report.
std::optional<DressReport> dressing_of(EaseReport& report, const EaseMapSettings& settings) {
  const fs::path file = settings.dress_report.value_or(dress_report_path(settings.garment));
  if (!settings.dress_report && !fs::exists(file)) {
    report.notes.push_back("no verdict: there is no report of dress at " + file.string());
    return std::nullopt;
  }
  std::optional<DressReport> read = read_dress_report(file, settings.garment);
  if (!read && settings.dress_report) {
    throw Error(file.string(), "is not the report of " + settings.garment.string(),
                "give the file that dress --report wrote with it");
  }
  if (!read) {
    report.notes.push_back("no verdict: " + file.string() + " is not the report of this drape");
  }
  return read;
}

/// The joints; none, with a note, where the body has none beside it.
std::optional<Skeleton> joints_of(EaseReport& report, const SurfaceDistance& skin,
                                  const EaseMapSettings& settings) {
  const fs::path path = settings.skeleton.value_or(skeleton_beside(settings.body));
  if (!settings.skeleton && !fs::exists(path)) {
    report.notes.push_back("no girth ease: there are no joints in " + path.string() +
                           "; clean-body writes them beside the body");
    return std::nullopt;
  }
  Skeleton skeleton = read_skeleton_of(skin, path);
  for (const char* joint : {"pelvis", "waist", "chest"}) {
    if (skeleton.joints.count(joint) == 0) {
      throw Error(path.string(), std::string("has no joint '") + joint + "'",
                  "let clean-body write it");
    }
  }
  return skeleton;
}

/// Measures drapes of one garment on one body.
class DrapeMeasurer {
 public:
  DrapeMeasurer(const EaseReport& report, const SurfaceDistance& skin, const Skeleton& skeleton,
                const EaseMapSettings& settings)
      : body_(report.body),
        skeleton_(skeleton),
        measures_(standing_measures(report.body, skeleton)) {
    options_.heights = settings.heights;
    options_.skin = &skin;
  }

  WornFigures figures(const DressedGarment& garment, const std::optional<DressReport>& dressing) {
    GirthOptions options = options_;
    std::vector<PanelRole> roles = worn_as(garment.panels);
    if (dressing) {
      options.touching = dressing->body_offset + contact_margin;
      options.grains = dressing->grains;
      roles = dressing->worn_as;
    }
    return measure_worn(garment, body_, skeleton_, roles, measures_, options);
  }

 private:
  const TriangleMesh& body_;
  const Skeleton& skeleton_;
  BodyMeasures measures_;
  GirthOptions options_;
};

/// Girths, edges and lengths, with errors from other drapes where there are such.
void measure_figures(EaseReport& report, const SurfaceDistance& skin,
                     const EaseMapSettings& settings) {
  const std::optional<Skeleton> skeleton = joints_of(report, skin, settings);
  if (!skeleton) return;
  DrapeMeasurer measurer(report, skin, *skeleton, settings);
  report.figures = measurer.figures(report.garment, report.dressing);
  std::vector<WornFigures> others;
  for (const fs::path& file : settings.repeats) {
    const DressedGarment garment = read_dressed(file);
    if (garment.panels != report.garment.panels) {
      throw Error(file.string(), "has other panels than " + settings.garment.string(),
                  "give another drape of the same garment");
    }
    std::optional<DressReport> dressing;
    const fs::path said = dress_report_path(file);
    if (fs::exists(said)) dressing = read_dress_report(said, file);
    others.push_back(measurer.figures(garment, dressing));
    report.repeats.push_back({file.string(), dressing ? dressing->verdict : ""});
  }
  take_errors_from(others, report.figures);
  if (!report.dressing) return;
  for (GarmentLevel& level : report.figures.levels) {
    const auto told = std::ranges::find(report.dressing->levels, level.name, &GarmentLevel::name);
    if (told == report.dressing->levels.end()) continue;
    level.drafted = told->drafted;
    level.drafted_body = told->drafted_body;
    level.drafted_body_error = told->drafted_body_error;
  }
}

/// Strain, tension and pressure; none, with a note, where it is not known what was dressed.
void measure_loads_of(EaseReport& report, const SurfaceDistance& skin,
                      const EaseMapSettings& settings) {
  if (!report.dressing) return;
  const std::string none = "no strain, tension and pressure: ";
  if (report.dressing->fabrics.empty()) {
    report.notes.push_back(none + "the report of dress has no fabrics; dress the garment anew");
    return;
  }
  if (!report.dressing->unknown_forces.empty()) {
    report.notes.push_back(none + report.dressing->unknown_forces);
    return;
  }
  if (settings.meshed) {
    report.loads = worn_loads(report.garment, *settings.meshed, *report.dressing, skin);
  } else {
    std::string why;
    for (const fs::path& meshed : meshed_garments_of(settings.garment, *report.dressing)) {
      try {
        report.loads = worn_loads(report.garment, meshed, *report.dressing, skin);
        break;
      } catch (const Error& error) {
        if (why.empty()) why = error.what();
      }
    }
    if (!report.loads) {
      report.notes.push_back(none + why + "; give the meshed garment by --garment-mesh");
      return;
    }
  }
  const Loads& loads = *report.loads;
  const Vec3 missing = loads.of_skin + loads.weight * report.dressing->gravity.normalized();
  if (missing.norm() > unsure_loads * loads.weight) {
    report.notes.push_back("pressure is not sure: the forces of the skin and the weight of " +
                           fixed_number(loads.weight, 2) + " N differ by " +
                           fixed_number(missing.norm(), 2) + " N");
  }
  report.load_rows = load_rows(report.garment, loads, report.figures.girths);
}

void warn(EaseReport& report, const Warning& warning) {
  CommonSettings::warn(warning.text);
  report.warnings.push_back(warning);
}

void warn_if_implausible(EaseReport& report) {
  const EaseStatistics& all = report.map.garment;
  if (all.p50 > 0.5) {
    warn(report, {"far_from_body", "",
                  "half of the garment is more than " + std::to_string(std::lround(100 * all.p50)) +
                      " cm away from the body: are both in metres and in the same place?"});
  } else if (all.inside > 0.01) {
    warn(report, {"inside_body", "",
                  std::to_string(std::lround(100 * all.inside)) +
                      " % of the garment's area lies inside the body"});
  }
}

/// What is cut smaller than the body goes around it by being stretched.
void warn_if_too_small(EaseReport& report) {
  for (const FitLevel& level : fit_of(report.figures.girths.rows, report.figures.levels).levels) {
    const std::string line = text_of(level);
    // The dressing may have found it.
    if (std::ranges::find(report.warnings, line, &Warning::text) == report.warnings.end()) {
      warn(report, {"too_small", level.level, line});
    }
  }
}

/// The whole report of a drape, but for its warnings of the ease map.
EaseReport measured_report(const EaseMapSettings& settings) {
  EaseReport report;
  report.garment = read_dressed(settings.garment);
  report.body = read_closed_body(settings.body);
  report.dressing = dressing_of(report, settings);
  if (report.dressing) report.warnings = report.dressing->warnings;
  report.warnings.insert(report.warnings.end(), settings.earlier_warnings.begin(),
                         settings.earlier_warnings.end());
  if (settings.contact) {
    report.options.contact = *settings.contact;
  } else if (report.dressing) {
    report.options.contact = report.dressing->body_offset + contact_margin;
  }
  report.garment_file = settings.garment.filename().string();
  report.body_file = settings.body.filename().string();
  report.garment_name = settings.garment_name.value_or(report.garment_file);
  report.body_name = settings.body_name.value_or(report.body_file);
  report.size = settings.size;
  report.points = settings.points;
  const SurfaceDistance skin(report.body);
  report.map = measure_ease(report.garment, skin, report.options);
  measure_figures(report, skin, settings);
  measure_loads_of(report, skin, settings);
  report.top = settings.top.value_or(suggested_top(report.map));
  if (settings.targets) {
    report.target = settings.targets->name;
    report.targets =
        compare_with_targets(*settings.targets, report.figures.girths.rows, report.figures.levels);
  }
  return report;
}

/// The other drape, on the body that its report names.
std::shared_ptr<const EaseReport> other_report(const fs::path& dressed) {
  EaseMapSettings settings;
  settings.garment = dressed;
  const fs::path said = dress_report_path(dressed);
  const std::optional<DressReport> report = read_dress_report(said, dressed);
  if (!report) {
    throw Error(said.string(), "is not the report of " + dressed.string(),
                "give a drape with its report beside it, as dress and toile fit write it");
  }
  // Where the report names it, or beside the garment.
  settings.body = report->body;
  if (!fs::exists(settings.body)) {
    settings.body = dressed.parent_path() / report->body.filename();
  }
  return std::make_shared<const EaseReport>(measured_report(settings));
}

}  // namespace

void run_ease_map(const EaseMapSettings& settings, const CommonSettings& common) {
  EaseReport report = measured_report(settings);
  if (settings.against) {
    report.other = other_report(*settings.against);
    report.against = settings.against->string();
  }
  warn_if_implausible(report);
  warn_if_too_small(report);
  for (const std::string& line : report.notes) common.say("note: " + line);
  if (!common.quiet) {
    for (const std::string& line : ease_summary(report)) common.say(line);
  }

  OutputFiles files;
  if (settings.csv) write_file(files.at(*settings.csv), ease_csv(report));
  write_report(files, common, ease_json(report));
  if (settings.ply) {
    write_mesh(files.at(*settings.ply), {report.garment.points, report.garment.triangles},
               ease_properties(report));
  }
  if (settings.glb) write_file(files.at(*settings.glb), ease_glb(report, settings.thickness));
  if (settings.body_obj) write_obj(files.at(*settings.body_obj), body_obj(report));
  const bool has_page = !common.output.empty();
  std::vector<int> widths;
  if (has_page || settings.pdf) widths.push_back(420);
  if (settings.png) widths.push_back(900);
  const std::vector<std::string> pictures = ease_pictures(report, widths);
  if (settings.png) write_file(files.at(*settings.png), pictures.back());
  if (has_page || settings.pdf) {
    const std::string page = ease_page(report, pictures.front());
    if (has_page) write_file(files.at(common.output), page);
    if (settings.pdf) write_file(files.at(*settings.pdf), printed_page(page));
  }
  files.commit();
  if (has_page) return common.say("wrote " + common.output.string());
  for (const auto& file :
       {common.report, settings.csv, settings.ply, settings.png, settings.pdf, settings.glb}) {
    if (file) common.say("wrote " + file->string());
  }
}

}  // namespace toile
