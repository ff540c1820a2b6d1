// Writes Fig. 13 of Zhong & Xu 2009. Two panels that are too small for the body cannot be sewn;
// enlarged by the body's measures they can.
#include <algorithm>
#include <set>

#include "tests/figures/dressing_pictures.h"
#include "tests/figures/sheet.h"

namespace toile::figures {
namespace {

/// Lengths of the borders that no seam takes, of all panels together, metres.
struct BandGirths {
  double upper = 0;
  double lower = 0;
};

BandGirths girths_of(const PanelMesh& garment) {
  std::vector<char> on_seam(garment.flat.size(), 0);
  for (const MeshedSeam& seam : garment.seams) {
    for (const int p : seam.a) on_seam[p] = 1;
    for (const int p : seam.b) on_seam[p] = 1;
  }
  BandGirths girths;
  for (const MeshedPanel& panel : garment.panels) {
    double middle = 0;
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      middle += garment.flat[i].y() / panel.points;
    }
    std::multiset<std::pair<int, int>> edges;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      for (int k = 0; k < 3; ++k) {
        edges.insert(std::minmax(garment.triangles[t][k], garment.triangles[t][(k + 1) % 3]));
      }
    }
    for (const auto& [a, b] : edges) {
      if (edges.count({a, b}) != 1 || (on_seam[a] && on_seam[b])) continue;
      const double length = (garment.flat[a] - garment.flat[b]).norm();
      const bool is_upper = (garment.flat[a] + garment.flat[b]).y() / 2 > middle;
      (is_upper ? girths.upper : girths.lower) += length;
    }
  }
  return girths;
}

double girth_of_body(const Wearer& wearer, const std::string& name) {
  for (const MannequinGirth& girth : wearer.mannequin.girths) {
    if (girth.name == name) return girth.measured;
  }
  return 0;
}

std::vector<std::string> girth_row(const std::string& what, double panels, double body) {
  return {what, number(100 * panels, 1), number(100 * body, 1), number(100 * (panels - body), 1)};
}

void write(const SheetSettings& settings) {
  Sheet sheet(settings.folder, "fig13", "Fig. 13: sewability of a pattern");
  const Wearer wearer(standing_pose());
  const double waist = girth_of_body(wearer, "waist");
  const double hip = girth_of_body(wearer, "hip");
  const PanelMesh small_panels = sample_garment("band_small", settings.edge_length);
  const PanelMesh large_panels = sample_garment("band", settings.edge_length);
  const PaperDressing small = dress_by_paper("two panels, too small", small_panels, wearer);
  const PaperDressing large = dress_by_paper("two panels, enlarged", large_panels, wearer);

  sheet.pictures("(a) Too small",
                 state_pictures(small, wearer, {.view = View::left, .close_up = true}));
  std::vector<std::vector<std::string>> seams;
  double missing = 0;
  for (const OpenSeam& seam : small.judgement.garment.seams.open_seams) {
    seams.push_back({seam.name, number(100 * seam.gap, 2)});
    missing += 100 * seam.gap;
  }
  sheet.table("Seams that can't be closed", {"seam", "missing, cm"}, seams);
  sheet.pictures("(b) Enlarged from the body's measures",
                 state_pictures(large, wearer, {.view = View::left, .close_up = true}));
  const BandGirths small_girths = girths_of(small_panels);
  const BandGirths large_girths = girths_of(large_panels);
  sheet.table("Girth of the panel pair and of the body, cm", {"edge", "panels", "body", "ease"},
              {girth_row("too small, upper edge at the waist", small_girths.upper, waist),
               girth_row("too small, lower edge at the hip", small_girths.lower, hip),
               girth_row("enlarged, upper edge at the waist", large_girths.upper, waist),
               girth_row("enlarged, lower edge at the hip", large_girths.lower, hip)});
  sheet.compare("(a) panels too small for the body", "unsewable",
                to_string(small.judgement.verdict) + ", " + number(missing, 1) + " cm missing in " +
                    std::to_string(seams.size()) + " seams",
                small.judgement.verdict == Verdict::unsewable);
  sheet.compare("(b) the panels enlarged from the body's measures", "sewn",
                to_string(large.judgement.verdict), large.judgement.verdict == Verdict::sewn);
  sheet.garment(small, "unsewable");
  sheet.garment(large);
  sheet.write();
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
