#include "tools/try/lay_aside.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/polygon.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/outline_polygon.h"
#include "pattern/seams/shell_panels.h"

namespace toile {

namespace {

/// The part that each panel belongs to: the number of one of its panels.
std::vector<std::size_t> parts_of(const Pattern& pattern) {
  std::vector<std::size_t> part(pattern.panels.size());
  std::iota(part.begin(), part.end(), 0U);
  for (const Stitch& stitch : pattern.stitches) {
    const std::size_t from = part[static_cast<std::size_t>(stitch.a.panel)];
    const std::size_t to = part[static_cast<std::size_t>(stitch.b.panel)];
    std::ranges::replace(part, from, to);
  }
  return part;
}

}  // namespace

LaidAside lay_aside(const std::filesystem::path& file, const std::set<std::string>& placed) {
  const std::string text = read_file(file);
  std::vector<Remark> told_before;
  const Pattern pattern = parse_pattern(text, file.string(), told_before);
  const std::vector<std::size_t> part = parts_of(pattern);
  std::map<std::size_t, double> areas;
  std::set<std::size_t> stays;
  std::map<std::string, std::string> kinds;
  for (std::size_t p = 0; p < part.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    if (!panel.left_out.empty()) {
      kinds[panel.name] = panel.left_out;
    } else {
      areas[part[p]] += std::abs(signed_area(outline_polygon(panel).points));
      if (placed.contains(panel.name)) stays.insert(part[p]);
    }
  }
  const auto largest = std::ranges::max_element(areas, {}, [](const auto& a) { return a.second; });
  if (largest != areas.end()) stays.insert(largest->first);
  LaidAside aside;
  double area = 0;
  for (const std::size_t p : stays) area += areas[p];
  for (std::size_t p = 0; p < part.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    if (!panel.left_out.empty() || stays.contains(part[p])) continue;
    aside.panels.push_back({panel.name, "sewn to nothing of the rest"});
    aside.largest = std::max(aside.largest, areas[part[p]] / area);
    kinds[panel.name] = aside.panels.back().kind;
  }
  if (aside.panels.empty()) return aside;
  OutputFiles files;
  write_file(files.at(file), with_left_out(text, file.string(), kinds));
  files.commit();
  return aside;
}

}  // namespace toile
