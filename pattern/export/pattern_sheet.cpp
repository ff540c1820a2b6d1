#include "pattern/export/pattern_sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/outset_polygon.h"
#include "geometry/polygon.h"
#include "pattern/export/label_places.h"
#include "pattern/file/seam_text.h"
#include "pattern/layout/row_layout.h"

namespace toile {

namespace {

/// Metres between panels, and around all.
constexpr double panel_gap = 0.02;
/// Metres: the width of most cloth.
constexpr double row_width = 1.5;
/// Metres: pages of PDF end at 5.08 m.
constexpr double max_sheet_height = 5;
/// Metres: the height of the strip with the scale bar.
constexpr double scale_bar_room = 0.02;
/// Metres.
constexpr double chord_error = 1e-5;
constexpr double longest_arrow = 0.4;
constexpr double seam_number_text = 5e-3;
constexpr double smallest_text = 3e-3;
/// Metres: of the fonts of a panel's name, from the one that is tried first.
constexpr std::array<double, 4> name_texts = {14e-3, 9e-3, 6e-3, 4e-3};
/// Width of a letter over the height of its font, as a bound.
constexpr double letter_width = 0.62;

/// FreeSewing's classes of material_classes. All others are `fabric`.
constexpr std::array<const char*, 4> material_classes = {"fabric", "lining", "interfacing",
                                                         "canvas"};

/// Index into Sheet::styles: these, then a seam line and a cut line for each material.
enum Style : int { dxf_boundary, internal_line, cut_out, grain, first_material };

std::vector<SheetStyle> all_styles() {
  std::vector<SheetStyle> styles = {{"", 1, 0, false, false},
                                    {"mark", 8, 0.3e-3, false, false},
                                    {"cut-out", 11, 0.5e-3, false, false},
                                    {"note", 7, 0.3e-3, false, true}};
  for (const std::string material : material_classes) {
    styles.push_back({material, 14, 0.5e-3, false, false});
    styles.push_back({material + " sa", 1, 0.3e-3, true, false});
  }
  return styles;
}

int seam_line(const std::string& material) {
  const auto found = std::find(material_classes.begin(), material_classes.end(), material);
  const auto index = found == material_classes.end() ? 0 : found - material_classes.begin();
  return first_material + 2 * static_cast<int>(index);
}
int cut_line(const std::string& material) { return seam_line(material) + 1; }

Vec2 text_size(const std::string& text, double height) {
  const auto letters =
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80; });
  return {letter_width * height * static_cast<double>(letters), 1.3 * height};
}

DrawnPath polyline(const std::vector<Vec2>& points, bool closed) {
  DrawnPath path;
  path.closed = closed;
  path.start = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.segments.push_back(DrawnSegment::line(points[i]));
  }
  if (closed) path.segments.push_back(DrawnSegment::line(path.start));
  return path;
}

DrawnPath outline_path(const PatternPanel& panel) {
  DrawnPath path;
  path.closed = true;
  bool first = true;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& drawn = panel.edges[static_cast<std::size_t>(step.edge)].curve;
    const EdgeCurve curve = step.forward ? drawn : drawn.reversed();
    if (first) path.start = curve.start();
    first = false;
    if (curve.straight()) {
      path.segments.push_back(DrawnSegment::line(curve.end()));
      continue;
    }
    for (const auto& piece : curve.cubics()) {
      path.segments.push_back(DrawnSegment::cubic(piece[1], piece[2], piece[3]));
    }
  }
  path.segments.back().end = path.start;
  return path;
}

/// One panel, in the place where its drawing has it.
class PanelPart {
 public:
  PanelPart(const Pattern& pattern, std::size_t index, double allowance)
      : pattern_(pattern), index_(static_cast<int>(index)), panel_(pattern.panels[index]) {
    part_.name = panel_.name;
    const DrawnPath path = outline_path(panel_);
    polygon_ = path_vertices(path, chord_error);
    polygon_.pop_back();
    counter_clockwise_ = signed_area(polygon_) > 0;
    border_ = polygon_;
    if (allowance > 0) {
      border_ = outset_polygon(distinct_points(), allowance);
      if (border_.empty()) {
        throw Error(pattern.source + ": panel '" + panel_.name + "'",
                    "no seam allowance can be drawn around it", "give a smaller --seam-allowance");
      }
      add(cut_line(panel_.material), polyline(border_, true));
    } else {
      add(dxf_boundary, path);
    }
    add(seam_line(panel_.material), path);
    lines();
    marks();
    arrow();
    seams();
    texts();
    facts();
  }

  Eigen::AlignedBox2d box() const {
    Eigen::AlignedBox2d box;
    for (const Vec2& point : border_) box.extend(point);
    return box;
  }

  SheetPart moved(const Vec2& by) const {
    SheetPart part = part_;
    for (SheetPath& path : part.paths) {
      path.path.start += by;
      for (DrawnSegment& segment : path.path.segments) {
        segment.control1 += by;
        segment.control2 += by;
        segment.end += by;
      }
    }
    for (SheetMark& mark : part.marks) mark.at += by;
    for (SheetText& text : part.texts) text.at += by;
    for (SheetText& text : part.data) text.at += by;
    return part;
  }

 private:
  void add(int style, DrawnPath path) { part_.paths.push_back({style, std::move(path)}); }

  /// The polygon without points that lie on each other.
  std::vector<Vec2> distinct_points() const {
    std::vector<Vec2> points;
    for (const Vec2& point : polygon_) {
      if (points.empty() || (point - points.back()).norm() > 1e-6) points.push_back(point);
    }
    return points;
  }

  void lines() {
    for (const auto& line : panel_.internal_lines) {
      if (line.size() < 2) continue;
      add(internal_line, polyline(line, false));
      for (std::size_t i = 0; i + 1 < line.size(); ++i) taken_.push_back({line[i], line[i + 1]});
    }
    for (const auto& hole : panel_.cut_outs) {
      if (hole.size() < 3) continue;
      add(cut_out, polyline(hole, true));
      for (std::size_t i = 0; i < hole.size(); ++i) {
        taken_.push_back({hole[i], hole[(i + 1) % hole.size()]});
      }
    }
  }

  void marks() {
    for (const OutlineStep& step : panel_.outline) {
      const EdgeCurve& curve = panel_.edges[static_cast<std::size_t>(step.edge)].curve;
      part_.marks.push_back(
          {SheetMark::Sign::none, 2, step.forward ? curve.start() : curve.end(), {}});
    }
    for (const PanelNotch& notch : panel_.notches) {
      const double angle = notch.angle.value_or(inward_at(notch.at));
      part_.marks.push_back({SheetMark::Sign::notch, 4, notch.at, angle});
    }
    for (const Vec2& hole : panel_.drill_holes) {
      part_.marks.push_back({SheetMark::Sign::hole, 13, hole, {}});
      taken_.push_back({hole - Vec2(2e-3, 2e-3), hole + Vec2(2e-3, 2e-3)});
    }
  }

  /// The direction into the panel, square to the outline where it passes `point`.
  double inward_at(const Vec2& point) const {
    double least = 1e300;
    Vec2 run = Vec2::UnitX();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vec2& from = polygon_[i];
      const Vec2& to = polygon_[(i + 1) % polygon_.size()];
      const double distance = distance_to_segment(point, from, to);
      if (distance >= least || from == to) continue;
      least = distance;
      run = to - from;
    }
    const Vec2 left(-run.y(), run.x());
    const Vec2 in = counter_clockwise_ ? left : Vec2(-left);
    return std::atan2(in.y(), in.x());
  }

  void arrow() {
    const Vec2 along(-std::sin(panel_.grain), std::cos(panel_.grain));
    const PieceLine line = longest_line_inside(polygon_, along, 0.6, longest_arrow);
    if (line.from == line.to) return;
    add(grain, polyline({line.from, line.to}, false));
    const Vec2 aside = 4e-3 * Vec2(-along.y(), along.x());
    taken_.push_back({line.from + aside, line.to + aside});
    taken_.push_back({line.from - aside, line.to - aside});
  }

  void seams() {
    for (std::size_t s = 0; s < pattern_.stitches.size(); ++s) {
      const Stitch& stitch = pattern_.stitches[s];
      if (stitch.a.panel == index_) {
        seam(stitch.a.edge, s + 1, stitch.b.panel);
        seam_data(stitch, s + 1, false);
      }
      if (stitch.b.panel == index_) {
        seam(stitch.b.edge, s + 1, stitch.a.panel);
        seam_data(stitch, s + 1, true);
      }
    }
  }

  /// What a program reads: on the middle of the edge, along the way in which the seam is sewn.
  void seam_data(const Stitch& stitch, std::size_t number, bool second) {
    const EdgeCurve& curve =
        panel_.edges[static_cast<std::size_t>((second ? stitch.b : stitch.a).edge)].curve;
    Vec2 run = curve.at(0.501) - curve.at(0.499);
    // The end of one edge meets the start of the other, where nothing else is stated.
    if (second && stitch.direction != StitchDirection::start_to_start) run = -run;
    const SeamText text{static_cast<int>(number), second,         stitch.direction,
                        stitch.gathered,          stitch.layered, stitch.fullness};
    part_.data.push_back({seam_text(text), curve.at(0.5), 1e-3, std::atan2(run.y(), run.x())});
  }

  void seam(int edge, std::size_t number, int other) {
    const auto step = std::find_if(panel_.outline.begin(), panel_.outline.end(),
                                   [&](const OutlineStep& one) { return one.edge == edge; });
    if (step == panel_.outline.end()) return;  // merged with its neighbour
    const EdgeCurve& curve = panel_.edges[static_cast<std::size_t>(edge)].curve;
    SheetText text;
    text.height = std::clamp(curve.length() / 2, smallest_text, seam_number_text);
    text.text = std::to_string(number);
    if (other != index_) {
      const std::string full =
          text.text + " " + pattern_.panels[static_cast<std::size_t>(other)].name;
      if (text_size(full, text.height).x() < 0.8 * curve.length()) text.text = full;
    }
    const double half = std::min(0.25, text_size(text.text, text.height).x() / 2 / curve.length());
    Vec2 run = curve.at(0.5 + half) - curve.at(0.5 - half);
    if (run.norm() == 0) run = Vec2::UnitX();
    if (!step->forward) run = -run;
    run.normalize();
    const Vec2 in = counter_clockwise_ ? Vec2(-run.y(), run.x()) : Vec2(run.y(), -run.x());
    // A curve that bulges inwards is passed by.
    double bulge = 0;
    for (const double at : {0.5 - half, 0.5, 0.5 + half}) {
      bulge = std::max(bulge, in.dot(curve.at(at) - curve.at(0.5)));
    }
    text.at = curve.at(0.5) + (bulge + 1e-3 + 0.65 * text.height) * in;
    text.angle = std::atan2(run.y(), run.x());
    if (text.angle > std::numbers::pi / 2 + 1e-6) text.angle -= std::numbers::pi;
    if (text.angle <= -std::numbers::pi / 2 + 1e-6) text.angle += std::numbers::pi;
    const Vec2 reach = text_size(text.text, text.height).x() / 2 * run;
    const Vec2 depth = 0.6 * text.height * in;
    taken_.push_back({text.at - reach + depth, text.at + reach + depth});
    part_.texts.push_back(std::move(text));
  }

  std::string cutting() const {
    std::string text = "Cut " + std::to_string(panel_.quantity);
    if (!panel_.material.empty()) text += " from " + panel_.material;
    return panel_.left_out.empty() ? text : text + ", left out: " + panel_.left_out;
  }

  void texts() {
    const std::string second = cutting();
    for (const double height : name_texts) {
      const double small = std::max(smallest_text, 0.5 * height);
      const Vec2 name = text_size(panel_.name, height);
      const Vec2 below = text_size(second, small);
      const Vec2 size(std::max(name.x(), below.x()), name.y() + below.y());
      auto at = room_for(size, polygon_, taken_);
      if (!at && height > name_texts.back()) continue;
      // Where nothing fits, the name stands in the middle all the same.
      if (!at) at = box().center();
      part_.texts.push_back({panel_.name, *at + Vec2(0, below.y() / 2), height, 0});
      part_.texts.push_back({second, *at - Vec2(0, name.y() / 2), small, 0});
      return;
    }
  }

  void facts() {
    part_.facts = {"Piece Name: " + panel_.name, "Quantity: " + std::to_string(panel_.quantity),
                   drawn_panel_fact};
    if (panel_.side_unknown) part_.facts.emplace_back("Side: unknown");
    if (!panel_.left_out.empty()) part_.facts.push_back("Left out: " + panel_.left_out);
    if (!panel_.material.empty()) part_.facts.push_back("Material: " + panel_.material);
  }

  const Pattern& pattern_;
  int index_;
  const PatternPanel& panel_;
  SheetPart part_;
  std::vector<Vec2> polygon_;
  std::vector<Vec2> border_;      ///< the outermost line that is drawn
  std::vector<PieceLine> taken_;  ///< where texts do not go
  bool counter_clockwise_ = true;
};

}  // namespace

Sheet pattern_sheet(const Pattern& pattern, const PatternSheetOptions& options) {
  Sheet sheet;
  sheet.styles = all_styles();
  sheet.title = std::filesystem::path(pattern.source).stem().string();
  // What AAMA calls metric is in millimetres.
  sheet.facts = {"Style Name: " + sheet.title, "Units: METRIC"};
  std::vector<PanelPart> parts;
  std::vector<Vec2> sizes;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    parts.emplace_back(pattern, p, options.seam_allowance);
    sizes.push_back(parts.back().box().sizes());
  }
  const RowLayout rows = lay_out_rows(sizes, panel_gap, row_width, max_sheet_height);
  // The scale bar stands below all rows.
  const Vec2 raised(0, scale_bar_room);
  sheet.size = rows.size.cwiseMax(Vec2(scale_bar_length + 2 * panel_gap, 0)) + raised;
  sheet.scale_bar = Vec2(panel_gap, scale_bar_room / 2);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    sheet.parts.push_back(parts[p].moved(rows.corners[p] + raised - parts[p].box().min()));
  }
  return sheet;
}

}  // namespace toile
