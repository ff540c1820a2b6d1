#include "tools/ease_map/page.h"

#include <algorithm>
#include <iterator>

#include "geometry/decimate.h"
#include "io/view/picture.h"
#include "io/view/viewer_page.h"
#include "pattern/layout/side_by_side.h"
#include "tools/ease_map/against.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/maps.h"
#include "tools/ease_map/numbers.h"
#include "tools/ease_map/tables.h"
#include "tools/report.h"

namespace toile {

namespace {

/// Enough to look smooth; a body's 50 thousand would be two thirds of the page.
constexpr int page_body_triangles = 16000;

std::string title_of(const EaseReport& report) {
  return report.garment_name + " on " + report.body_name;
}

std::vector<std::array<std::string, 2>> facts_of(const EaseReport& report) {
  std::vector<std::array<std::string, 2>> facts = {{"garment", valid_utf8(report.garment_name)},
                                                   {"body", valid_utf8(report.body_name)}};
  if (!report.size.empty()) facts.push_back({"size", valid_utf8(report.size)});
  if (report.dressing && !report.dressing->fabrics.empty()) {
    std::string names;
    for (const UsedFabric& used : report.dressing->fabrics) {
      names += (names.empty() ? "" : ", ") + used.fabric.name;
    }
    facts.push_back({"fabric", valid_utf8(names)});
  }
  facts.push_back({"mesh", std::to_string(report.garment.points.size()) + " nodes, edges of " +
                               fixed_number(1000 * mean_edge(report.garment), 0) + " mm"});
  if (!report.target.empty()) facts.push_back({"target", valid_utf8(report.target)});
  return facts;
}

}  // namespace

std::string ease_page(const EaseReport& report, const std::string& picture) {
  ViewerPage page;
  page.title = title_of(report);
  page.facts = facts_of(report);
  const std::vector<Finding> findings = findings_of(report);
  EaseTables tables = ease_tables(report, findings);
  if (report.dressing) {
    page.verdict.word = dressing_line(report);
    const bool is_sewn = report.dressing->verdict == "sewn" && report.dressing->fit.levels.empty();
    page.verdict.tone = !is_sewn           ? PageVerdict::Tone::bad
                        : findings.empty() ? PageVerdict::Tone::good
                                           : PageVerdict::Tone::fair;
  }
  for (const Finding& finding : findings) {
    const auto line = tables.line_of.find(finding.level);
    page.verdict.reasons.push_back(
        {finding.text, line == tables.line_of.end() ? -1 : line->second});
  }
  for (const Warning& warning : report.warnings) {
    if (std::ranges::find(findings, warning.text, &Finding::text) == findings.end()) {
      page.warnings.push_back(warning.text);
    }
  }
  page.paragraphs = report.notes;
  page.nodes = report.garment.points;
  page.node_of = nodes_of_points(report.garment);
  page.pattern = report.garment.flat;
  page.flat = side_by_side(report.garment).flat;
  page.triangles = report.garment.flat_triangles;
  page.regions = report.garment.panels;
  page.region_of_triangle = report.garment.panel_of_triangle;
  page.maps = ease_maps(report);
  if (report.other) {
    std::ranges::move(difference_maps(report, *report.other), std::back_inserter(page.maps));
  }
  // Only looked at there: a light body keeps the page small and quick to turn.
  page.settings.push_back({"body", decimate(report.body, page_body_triangles)});
  page.tables = std::move(tables.tables);
  page.lines = std::move(tables.lines);
  page.still_png = picture;
  return viewer_page(page);
}

std::vector<std::string> ease_pictures(const EaseReport& report, const std::vector<int>& widths) {
  if (widths.empty()) return {};
  const EaseScale scale = ease_scale(report);
  PictureMesh cloth;
  cloth.mesh = {report.garment.points, report.garment.triangles};
  cloth.values = scale.nodes;
  cloth.ramp = scale.bar.ramp;
  cloth.regions = report.garment.panel_of_triangle;
  cloth.shows_through = 0.03;
  PictureMesh body;
  body.mesh = report.body;
  body.colour = {0.74, 0.72, 0.71};
  body.framed = false;
  body.inside_shown = false;
  Picture picture;
  picture.title = title_of(report);
  if (report.dressing) picture.title += " (" + report.dressing->verdict + ")";
  picture.bar = scale.bar;
  picture.bar->title = report.loads ? "stretch, gap" : "gap";
  std::vector<PictureMesh> meshes;
  meshes.push_back(std::move(cloth));
  meshes.push_back(std::move(body));
  const RayScene scene(std::move(meshes));
  std::vector<std::string> pictures;
  for (const int width : widths) {
    picture.view_width = width;
    pictures.push_back(picture_png(scene, picture));
  }
  return pictures;
}

}  // namespace toile
