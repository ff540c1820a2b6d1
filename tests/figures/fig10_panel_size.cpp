// Writes Fig. 10 of Zhong & Xu 2009: area and perimeter of a panel through a whole dressing, with
// and without strain control.
#include <algorithm>
#include <cmath>

#include "tests/figures/dressing_pictures.h"
#include "tests/figures/sheet.h"

namespace toile::figures {
namespace {

constexpr double paper_area = 1.44;       // percent
constexpr double paper_perimeter = 0.87;  // percent

/// The panel whose area changes most on the way.
std::size_t max_changed_panel(const PaperDressing& dressing) {
  std::size_t panel = 0;
  double most = 0;
  for (const DressingMoment& m : dressing.moments) {
    for (std::size_t p = 0; p < m.area.size(); ++p) {
      if (std::abs(m.area[p]) > most) {
        most = std::abs(m.area[p]);
        panel = p;
      }
    }
  }
  return panel;
}

std::string stage_times(const PaperDressing& dressing) {
  std::string text;
  double time = 0;
  for (const StageReport& stage : dressing.result.stages) {
    if (stage.simulated <= 0) continue;
    text += (text.empty() ? "" : ", ") + stage.name + " until " +
            number(time += stage.simulated, 2) + " s";
  }
  return text;
}

/// A way to dress the same garment.
struct Way {
  std::string name;
  bool held = false;
  PaperDressing dressing;
};

/// Springs as soft as those of Fig. 9, N/m: super-elastic without control.
Fabric soft_fabric() {
  Fabric soft;
  soft.name = "soft";
  soft.stretch_warp = soft.stretch_weft = 20;
  soft.shear = 4;
  return soft;
}

std::vector<Way> dress_all_ways(const SheetSettings& settings, const Wearer& wearer) {
  const PanelMesh garment = sample_garment("tshirt", settings.edge_length);
  SpringDressOptions held;
  SpringDressOptions loose;
  loose.motion.strain_scheme = StrainScheme::none;
  std::vector<Way> ways;
  const auto dress = [&](const std::string& name, const SpringDressOptions& options,
                         const Fabric& fabric) {
    ways.push_back({name, options.motion.strain_scheme != StrainScheme::none,
                    dress_by_paper("T-shirt, " + name, garment, wearer, options, fabric)});
  };
  dress("woven, velocities adjusted at 1 %", held, {});
  dress("woven, no control", loose, {});
  // Soft springs alone would be stable with longer steps, for which three passes hold nothing.
  held.motion.time_step = loose.motion.time_step = ways.front().dressing.result.time_step;
  dress("soft, velocities adjusted at 1 %", held, soft_fabric());
  dress("soft, no control", loose, soft_fabric());
  return ways;
}

Chart chart(const std::string& title, const std::string& y, double level,
            const std::vector<Way>& ways, std::vector<double> DressingMoment::*quantity,
            std::size_t panel) {
  Chart result{title, "seconds simulated", y, {}};
  double until = 0;
  for (const Way& way : ways) {
    Curve curve{way.name, {}, false};
    for (const DressingMoment& m : way.dressing.moments) {
      curve.points.emplace_back(m.seconds, (m.*quantity)[panel]);
    }
    result.curves.push_back(curve);
    until = std::max(until, way.dressing.simulated());
  }
  result.curves.push_back({"the paper's largest", {{0, level}, {until, level}}, true});
  result.curves.push_back({"", {{0, -level}, {until, -level}}, true});
  return result;
}

double most(const PaperDressing& dressing, std::vector<double> DressingMoment::*quantity,
            std::size_t panel) {
  double largest = 0;
  for (const DressingMoment& m : dressing.moments) {
    largest = std::max(largest, std::abs((m.*quantity)[panel]));
  }
  return largest;
}

void write(const SheetSettings& settings) {
  Sheet sheet(settings.folder, "fig10", "Fig. 10: area and perimeter of a panel while dressing");
  const Wearer wearer(standing_pose());
  const std::vector<Way> ways = dress_all_ways(settings, wearer);
  const PanelMesh& garment = ways.front().dressing.garment;
  const std::size_t panel = max_changed_panel(ways.back().dressing);
  sheet.say(
      "The T-shirt on the standing mannequin. Perimeter is that of all the triangles in the "
      "panel. The woven is the default fabric; the soft one has springs a fiftieth as "
      "stiff, as super-elastic as the hanging cloth of Fig. 9. Curves: panel '" +
      garment.panels[panel].name +
      "', which changes most; the tables take the largest change of any panel at any time.");
  std::string times;
  for (const Way& way : ways) {
    times += (times.empty() ? "" : " ") + way.name + ": " + stage_times(way.dressing) + ".";
  }
  sheet.say(times);
  sheet.chart(chart("Area of a panel", "change of area, %", paper_area, ways, &DressingMoment::area,
                    panel));
  sheet.chart(chart("Perimeter of all triangles of a panel", "change of perimeter, %",
                    paper_perimeter, ways, &DressingMoment::perimeter, panel));

  std::vector<std::string> columns = {"panel"};
  std::vector<std::vector<std::string>> rows;
  for (const MeshedPanel& p : garment.panels) rows.push_back({p.name});
  for (const Way& way : ways) {
    columns.push_back("area, " + way.name);
    columns.push_back("perimeter, " + way.name);
    for (std::size_t p = 0; p < rows.size(); ++p) {
      rows[p].push_back(number(most(way.dressing, &DressingMoment::area, p), 2));
      rows[p].push_back(number(most(way.dressing, &DressingMoment::perimeter, p), 2));
    }
    const double area = way.dressing.max_area();
    const double perimeter = way.dressing.max_perimeter();
    if (way.held) {
      sheet.compare("largest change of a panel's area while dressing: " + way.name,
                    number(paper_area, 2) + " %", number(area, 2) + " %", area <= paper_area);
      sheet.compare("largest change of a panel's perimeter: " + way.name,
                    number(paper_perimeter, 2) + " %", number(perimeter, 2) + " %",
                    perimeter <= paper_perimeter);
    } else {
      sheet.compare("the same: " + way.name, "“vary dramatically”",
                    "area " + number(area, 2) + " %, perimeter " + number(perimeter, 2) + " %");
    }
  }
  sheet.table("Largest change on the way, %", columns, rows);
  for (const Way& way : ways) {
    sheet.pictures(way.name, state_pictures(way.dressing, wearer));
    sheet.garment(way.dressing);
  }
  sheet.write();
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
