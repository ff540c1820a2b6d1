#include "pattern/import/whole_garment.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace toile {

namespace {

/// Share of the area of all pieces that own mirror images may have in a drawing of half a garment.
/// Bands and cuffs are some. Whole fronts and backs are more.
constexpr double most_symmetric = 0.25;

/// Metres by which the left and the right one of two pieces may differ, and share of their area.
constexpr double twin_within = 5e-3;
constexpr double twin_share = 0.05;

std::vector<Vec2> points_of(const ImportedPanel& panel) {
  std::vector<Vec2> points;
  for (const OutlineEdge& edge : panel.outline.edges) {
    for (const FittedCurve& curve : edge.curves) {
      points.insert(points.end(), curve.points.begin(), curve.points.end());
    }
  }
  return points;
}

/// Whether a piece is the mirror image of another one, across the drawing's y.
bool are_twins(const ImportedPanel& a, const ImportedPanel& b) {
  if (std::abs(a.area - b.area) > twin_share * a.area) return false;
  std::vector<Vec2> mirrored = points_of(a);
  const std::vector<Vec2> other = points_of(b);
  for (Vec2& point : mirrored) point.x() = -point.x();
  const auto low = [](const std::vector<Vec2>& points) {
    Vec2 corner = points.front();
    for (const Vec2& point : points) corner = corner.cwiseMin(point);
    return corner;
  };
  const Vec2 by = low(other) - low(mirrored);
  return std::ranges::all_of(mirrored, [&](const Vec2& point) {
    return nearest_place(other, point + by).distance <= twin_within;
  });
}

}  // namespace

ImportOptions whole_garment(const ImportedPattern& drawn, const ImportOptions& given) {
  ImportOptions whole = given;
  if (!given.unfold.empty() || !given.pairs.empty()) return whole;
  bool says_how = false;
  bool has_half = false;
  double area = 0;
  double symmetric = 0;
  std::vector<const ImportedPanel*> lopsided;
  for (const ImportedPanel& panel : drawn.panels) {
    says_how = says_how || panel.is_unfolded || panel.is_of_pair || panel.quantity > 1;
    area += panel.area;
    if (panel.is_symmetric) symmetric += panel.area;
    if (panel.is_symmetric || panel.is_of_pair || panel.quantity > 1) continue;
    const bool has_twin = std::ranges::any_of(drawn.panels, [&](const ImportedPanel& other) {
      return &other != &panel && are_twins(panel, other);
    });
    if (has_twin) continue;
    lopsided.push_back(&panel);
    has_half = has_half || panel.likely_fold;
  }
  if (says_how && lopsided.size() != 1) return whole;
  const auto stays = [&](const ImportedPanel* panel) {
    return std::ranges::count(given.singles, panel->asked) > 0;
  };
  std::erase_if(lopsided, stays);
  if (says_how) {
    for (const ImportedPanel* panel : lopsided) whole.pairs.push_back(panel->asked);
    return whole;
  }
  if (!has_half || symmetric > most_symmetric * area) return whole;
  for (const ImportedPanel* panel : lopsided) {
    if (panel->likely_fold) {
      whole.unfold.push_back(panel->asked + ":" + std::to_string(*panel->likely_fold));
    } else {
      whole.pairs.push_back(panel->asked);
    }
  }
  return whole;
}

}  // namespace toile
