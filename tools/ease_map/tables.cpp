#include "tools/ease_map/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "io/text.h"
#include "tools/ease_map/against.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/load_report.h"
#include "tools/ease_map/numbers.h"

namespace toile {

namespace {

/// Makes the lines that rows light up, and numbers them.
class LineMaker {
 public:
  explicit LineMaker(const DressedGarment& garment) : garment_(garment) {}

  /// The line of girths, null ones left out, and that of the first one's plane on the body.
  int of(const std::array<const Girth*, 2>& girths) {
    PageLine line;
    for (const Girth* girth : girths) {
      if (girth == nullptr) continue;
      line.origin = girth->plane.origin;
      line.normal = girth->plane.normal;
      for (const int t : girth->triangles) add_cut(t, girth->plane, line);
    }
    const int number = add(std::move(line));
    for (const Girth* girth : girths) {
      if (girth != nullptr && !girth->name.empty()) line_of_[girth->name] = number;
    }
    return number;
  }

  /// The line of an edge or a seam.
  int of(const GarmentLevel& level) {
    const std::set<int> nodes(level.nodes.begin(), level.nodes.end());
    PageLine line;
    for (std::size_t t = 0; t < garment_.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3;
        if (nodes.count(garment_.triangles[t][k]) == 0 ||
            nodes.count(garment_.triangles[t][l]) == 0) {
          continue;
        }
        const int a = garment_.flat_triangles[t][k];
        const int b = garment_.flat_triangles[t][l];
        line.pieces.push_back({PagePlace{a, b, 0}, PagePlace{a, b, 1}});
      }
    }
    return line_of_[level.name] = add(std::move(line));
  }

  void hand_over(EaseTables& tables) {
    tables.lines = std::move(lines_);
    tables.line_of = std::move(line_of_);
  }

 private:
  void add_cut(int t, const CuttingPlane& plane, PageLine& line) const {
    std::vector<PagePlace> ends;
    const auto height = [&](int corner) {
      return (garment_.points[garment_.triangles[t][corner]] - plane.origin).dot(plane.normal);
    };
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const double from = height(k);
      const double to = height(l);
      if ((from > 0) == (to > 0)) continue;
      ends.push_back(
          {garment_.flat_triangles[t][k], garment_.flat_triangles[t][l], from / (from - to)});
    }
    if (ends.size() == 2) line.pieces.push_back({ends[0], ends[1]});
  }

  int add(PageLine line) {
    if (line.pieces.empty()) return -1;
    lines_.push_back(std::move(line));
    return static_cast<int>(lines_.size()) - 1;
  }

  const DressedGarment& garment_;
  std::vector<PageLine> lines_;
  std::map<std::string, int> line_of_;
};

std::vector<std::string> statistics_row(const std::string& name, const EaseStatistics& s) {
  return {name,
          mm(s.mean),
          mm(s.p50),
          mm(s.p5) + " \xE2\x80\x93 " + mm(s.p95),
          mm(s.min),
          mm(s.max),
          percent_text(s.contact)};
}

PageTable panel_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Gap by panel, mm";
  table.columns = {"panel", "mean", "median", "5 \xE2\x80\x93 95 %", "min", "max", "contact, %"};
  for (std::size_t i = 0; i < report.map.panels.size(); ++i) {
    if (report.map.panels[i].points == 0) continue;
    table.rows.push_back(statistics_row(report.garment.panels[i], report.map.panels[i]));
    table.regions.push_back(static_cast<int>(i));
  }
  table.rows.push_back(statistics_row("whole garment", report.map.garment));
  table.regions.push_back(-1);
  table.remark = "Weighted by area. Contact is the share of the area with a gap below " +
                 mm(report.options.contact) +
                 " mm. Point at a row to see its panel alone; click to keep it.";
  return table;
}

/// "left wrist" and "right wrist" are one row.
struct GirthRow {
  std::string name;
  const Girth* left = nullptr;   ///< or that of the trunk
  const Girth* right = nullptr;  ///< null: it has no sides, or the garment is not closed there
};

std::vector<GirthRow> girth_rows(const EaseReport& report) {
  std::vector<GirthRow> rows;
  for (const Girth& girth : report.figures.girths.rows) {
    const bool is_right = girth.name.starts_with("right ");
    const bool has_side = is_right || girth.name.starts_with("left ");
    const std::string name = has_side ? girth.name.substr(girth.name.find(' ') + 1) : girth.name;
    const auto pair = std::ranges::find_if(rows, [&](const GirthRow& row) {
      return is_right && row.name == name && row.left != nullptr &&
             row.left->name == "left " + name;
    });
    if (pair != rows.end()) {
      pair->right = &girth;
    } else {
      rows.push_back({name, is_right ? nullptr : &girth, is_right ? &girth : nullptr});
    }
  }
  return rows;
}

/// Whether a line of what hurts is about that girth or edge.
bool hurts(const std::vector<Finding>& findings, const std::string& level) {
  return !level.empty() && std::ranges::find(findings, level, &Finding::level) != findings.end();
}

PageTable girth_table(const EaseReport& report, const std::vector<Finding>& findings,
                      LineMaker& lines) {
  PageTable table;
  table.caption = "Girths of body and garment, cm";
  table.sheet = 1;
  table.columns = {"girth"};
  for (const char* name :
       {"height", "body", "as cut", "ease as cut", "as worn", "ease", "\xC2\xB1"}) {
    table.columns.emplace_back(name, true);
  }
  for (const GirthRow& row : girth_rows(report)) {
    const auto cell = [&](const std::function<std::string(const Girth&)>& text) {
      if (row.left == nullptr) return "\xE2\x80\x93 | " + text(*row.right);
      return text(*row.left) + (row.right == nullptr ? "" : " | " + text(*row.right));
    };
    const auto where_girth = [&](const std::function<std::string(const Girth&)>& text) {
      return cell([&](const Girth& girth) {
        return girth.is_girth() ? text(girth) : std::string("\xE2\x80\x93");
      });
    };
    const bool no_girth = std::ranges::none_of(
        std::array{row.left, row.right},
        [](const Girth* girth) { return girth != nullptr && girth->is_girth(); });
    table.rows.push_back(
        {row.name, cell([](const Girth& girth) { return cm(girth.height); }),
         cell([](const Girth& girth) { return cm(girth.body); }),
         where_girth([](const Girth& girth) { return cm(girth.as_cut); }),
         where_girth([](const Girth& girth) { return cm(girth.ease_as_cut()); }),
         no_girth ? "a fold" : where_girth([](const Girth& girth) { return cm(girth.garment); }),
         where_girth([](const Girth& girth) { return cm(girth.ease()); }),
         where_girth([](const Girth& girth) { return cm(girth.error); })});
    table.lines.push_back(lines.of(std::array{row.left, row.right}));
    table.between.push_back(row.name.empty());
    table.hurts.push_back(std::ranges::any_of(
        std::array{row.left, row.right},
        [&](const Girth* girth) { return girth != nullptr && hurts(findings, girth->name); }));
  }
  table.remark =
      "Where there are two numbers they are of left and right. The body is measured as a tape "
      "does, "
      "across hollows; the garment along the cloth with its folds. Ease is that of the cloth's "
      "inner face. As cut: the widths of the flat panels where the level crosses them. Heights are "
      "above the floor. A skirt's thigh and knee go around both legs as they stand.";
  for (const GirthLeftOut& level : report.figures.girths.left_out) {
    table.remark += "\nThe " + level.name + " is left out: " + level.why + ".";
  }
  return table;
}

PageTable garment_level_table(const EaseReport& report, const std::vector<Finding>& findings,
                              LineMaker& lines) {
  PageTable table;
  table.caption = "Edges and waist seam of the garment, cm";
  table.sheet = 2;
  table.columns = {"edge"};
  for (const char* name : {"drafted at", "rests at", "\xC2\xB1", "moved by", "body there",
                           "garment", "as cut", "ease as cut"}) {
    table.columns.emplace_back(name, true);
  }
  for (const GarmentLevel& level : report.figures.levels) {
    const std::optional<GarmentLevel::Compared> compared = level.compared();
    table.rows.push_back({level.name, level.drafted ? cm(*level.drafted) : "", cm(level.height),
                          cm(level.height_error), level.drafted ? cm(*level.risen()) : "",
                          compared ? cm(compared->body) : "", cm(level.garment), cm(level.as_cut),
                          compared ? cm(level.as_cut - compared->body) : ""});
    table.lines.push_back(lines.of(level));
    table.hurts.push_back(hurts(findings, level.name));
  }
  table.remark =
      "Along the edge or seam, which need not lie level. Its height is the mean. Moved by is how "
      "much higher it hangs than drafted. The body is measured where the edge was drafted to lie, "
      "or where it rests if that is not known; of a top edge where it lacks the least.";
  return table;
}

std::string beyond_text(const EndsBeyond& end) {
  if (end.place == "floor") return cm(end.by) + " above the floor";
  return cm(std::abs(end.by)) + (end.by < 0 ? " short of the " : " beyond the ") + end.place;
}

PageTable length_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Lengths of the garment, cm";
  table.sheet = 2;
  table.columns = {"length"};
  for (const char* name : {"as cut", "as worn", "\xC2\xB1", "body", "ends"}) {
    table.columns.emplace_back(name, true);
  }
  for (const GarmentLength& length : report.figures.lengths) {
    table.rows.push_back({length.name, length.as_cut ? cm(*length.as_cut) : "", cm(length.worn),
                          cm(length.error), length.body ? cm(*length.body) : "",
                          ends_text(length)});
  }
  table.remark =
      "As cut: straight across each flat panel along the line; of crotch length and rises along "
      "their seam. As worn: along the cloth; across shoulder straight to the centre back and on; "
      "of a neck drop the height. Where a sleeve or a shoulder ends is told along the arm, beyond "
      "a knee is below it.";
  return table;
}

PageTable target_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Ease against the target, cm";
  table.sheet = 1;
  table.columns = {"level", {"ease as cut", true}, {"\xC2\xB1", true}, {"meant", true},
                   "is",    {"off by", true}};
  for (const TargetFinding& finding : report.targets) {
    table.rows.push_back({finding.level, cm(finding.ease), cm(finding.error),
                          cm(finding.target.least) + " \xE2\x80\x93 " + cm(finding.target.most),
                          finding.word(), cm(finding.off())});
  }
  table.remark = "The target is '" + report.target +
                 "'. Of an edge the ease is told where it was drafted to lie.";
  return table;
}

PageTable point_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Points of measure, cm";
  table.sheet = 2;
  table.columns = {"point of measure"};
  for (const char* name : {"spec", "pattern", "difference", "tolerance"}) {
    table.columns.emplace_back(name, true);
  }
  table.columns.emplace_back("result");
  for (const MeasuredPoint& point : report.points) {
    const auto shown = [](const std::optional<double>& metres) {
      return metres ? cm(*metres) : std::string();
    };
    table.rows.push_back({valid_utf8(point.name), shown(point.spec), shown(point.actual),
                          shown(point.difference()),
                          point.spec ? cm(point.tolerance) : std::string(), point.result()});
  }
  return table;
}

}  // namespace

std::string ends_text(const GarmentLength& length) {
  std::string text;
  for (const EndsBeyond& end : length.ends) text += (text.empty() ? "" : ", ") + beyond_text(end);
  return text;
}

EaseTables ease_tables(const EaseReport& report, const std::vector<Finding>& findings) {
  LineMaker lines(report.garment);
  EaseTables all;
  std::vector<PageTable>& tables = all.tables;
  if (!report.targets.empty()) tables.push_back(target_table(report));
  if (!report.figures.girths.rows.empty()) tables.push_back(girth_table(report, findings, lines));
  if (report.other) {
    tables.push_back(difference_table(differences(report, *report.other), report.against));
  }
  if (!report.figures.levels.empty())
    tables.push_back(garment_level_table(report, findings, lines));
  if (!report.figures.lengths.empty()) tables.push_back(length_table(report));
  if (!report.points.empty()) tables.push_back(point_table(report));
  if (report.loads) tables.push_back(load_table(report));
  tables.push_back(panel_table(report));
  lines.hand_over(all);
  return all;
}

}  // namespace toile
