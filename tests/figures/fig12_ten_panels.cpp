// Writes Fig. 12 of Zhong & Xu 2009: a woman's dress of ten panels. It shows the meshed pattern
// over the body's measures, the dressing, and the ease map of the bodice.
#include <algorithm>
#include <cmath>
#include <map>

#include "cloth/ease/standing_measures.h"
#include "io/output_file.h"
#include "tests/figures/dressing_pictures.h"
#include "tests/figures/sheet.h"
#include "tools/ease_map/page.h"
#include "tools/ease_map/report.h"

namespace toile::figures {
namespace {

/// The girths that the paper's Fig. 12 (b) prints and that are no errors of its software, cm. (Calf
/// 3.92 and ankle 1.81 are; 0.00 was not measured.)
const std::vector<std::pair<std::string, double>> paper_girths = {
    {"bust", 93.64},        {"waist", 70.66},     {"abdomen", 85.97}, {"hip", 98.00},
    {"upper thigh", 55.77}, {"mid-thigh", 47.91}, {"knee", 35.31}};

/// What is above the waist: all panels but the skirt's.
DressedGarment bodice_of(const DressedGarment& whole) {
  DressedGarment part;
  std::map<int, int> node;
  std::map<int, int> flat;
  std::map<int, int> panel;
  const auto renumber = [](std::map<int, int>& known, int old, const auto& from, auto& to) {
    const auto [at, is_new] = known.try_emplace(old, static_cast<int>(to.size()));
    if (is_new) to.push_back(from[old]);
    return at->second;
  };
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const int p = whole.panel_of_triangle[t];
    if (whole.panels[p].find("skirt") != std::string::npos) continue;
    Triangle nodes{};
    Triangle points{};
    for (int k = 0; k < 3; ++k) {
      nodes[k] = renumber(node, whole.triangles[t][k], whole.points, part.points);
      points[k] = renumber(flat, whole.flat_triangles[t][k], whole.flat, part.flat);
    }
    part.triangles.push_back(nodes);
    part.flat_triangles.push_back(points);
    part.panel_of_triangle.push_back(renumber(panel, p, whole.panels, part.panels));
  }
  return part;
}

void measures(const Wearer& wearer, Sheet& sheet) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, paper] : paper_girths) {
    for (const MannequinGirth& girth : wearer.mannequin.girths) {
      if (girth.name != name) continue;
      const double ours = 100 * girth.measured;
      rows.push_back({name, number(paper, 2), number(ours, 2), number(ours - paper, 2)});
      sheet.compare("girth of the body, " + name, number(paper, 2) + " cm", number(ours, 2) + " cm",
                    std::abs(ours - paper) <= 0.05);
    }
  }
  sheet.table("(b) Girths of the body, cm", {"girth", "paper", "ours", "difference"}, rows);
}

void ease(const PaperDressing& dress, const Wearer& wearer, Sheet& sheet) {
  EaseReport report;
  report.garment = bodice_of(dress.dressed);
  report.body = wearer.mannequin.surface;
  report.garment_name = "bodice of the dress of ten panels";
  report.body_name = "mannequin";
  report.map = measure_ease(report.garment, SurfaceDistance(report.body));
  report.figures.girths = measure_girths(report.garment, report.body, wearer.mannequin.skeleton,
                                         standing_measures(report.body, wearer.mannequin.skeleton));
  report.top = suggested_top(report.map);
  const std::vector<std::string> pictures = ease_pictures(report, {420, 800});
  sheet.file("_ease.html", ease_page(report, pictures[0]));
  sheet.file("_ease.json", ease_json(report));
  sheet.pictures("(d) Ease map of the bodice", {{pictures[1], "gap between bodice and body, mm"}});
  std::vector<std::vector<std::string>> rows;
  for (const Girth& girth : report.figures.girths.rows) {
    rows.push_back({girth.name, number(100 * girth.height, 1), number(100 * girth.body, 2),
                    number(100 * girth.garment, 2), number(100 * girth.ease(), 2)});
  }
  sheet.table("Girth ease of the bodice, cm",
              {"level", "height", "body", "bodice as draped", "ease"}, rows);
  std::vector<std::vector<std::string>> panels;
  for (std::size_t p = 0; p < report.garment.panels.size(); ++p) {
    const EaseStatistics& s = report.map.panels[p];
    panels.push_back({report.garment.panels[p], number(1000 * s.mean, 1), number(1000 * s.p50, 1),
                      number(1000 * s.min, 1), number(1000 * s.max, 1)});
  }
  const EaseStatistics& all = report.map.garment;
  panels.push_back({"all", number(1000 * all.mean, 1), number(1000 * all.p50, 1),
                    number(1000 * all.min, 1), number(1000 * all.max, 1)});
  sheet.table("Gap between bodice and body, mm", {"panel", "mean", "median", "least", "largest"},
              panels);
}

void write(const SheetSettings& settings) {
  Sheet sheet(settings.folder, "fig12", "Fig. 12: a dress of ten panels, from pattern to ease map");
  const Wearer wearer(standing_pose());
  const PanelMesh garment = sample_garment("bodice_dress", settings.edge_length);
  const auto count = static_cast<int>(garment.panels.size());
  sheet.compare("panels of the dress", "10", std::to_string(count), count == 10);
  sheet.pictures("(a) Meshing the input patterns",
                 {{mesh_picture(garment),
                   std::to_string(count) + " panels, " + std::to_string(garment.flat.size()) +
                       " points, " + std::to_string(garment.triangles.size()) + " triangles"}});
  measures(wearer, sheet);
  const PaperDressing dress = dress_by_paper("dress of ten panels", garment, wearer);
  sheet.pictures("(c) Virtual dressing: position, wrap, drape", state_pictures(dress, wearer));
  sheet.pictures("(c) The same, from behind", state_pictures(dress, wearer, {.view = View::back}));
  sheet.garment(dress);
  if (dress.judgement.garment.seams.open == 0) {
    ease(dress, wearer, sheet);
    sheet.pictures("Strain of the dress", {{strain_picture(dress, wearer), "front and back"}});
  } else {
    sheet.say("The dress does not sew: it has no ease.");
  }
  sheet.write();
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
