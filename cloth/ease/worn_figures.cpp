#include "cloth/ease/worn_figures.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "cloth/ease/figure_errors.h"

namespace toile {

namespace {

/// Half width of the 90 % prediction interval of one more value; none: there are too few.
std::optional<double> spread_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  if (values.size() < 3) return std::nullopt;
  double mean = 0;
  for (const double value : values) mean += value / count;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / (count - 1);
  const boost::math::students_t law(count - 1);
  return boost::math::quantile(law, 0.95) * std::sqrt(variance * (1 + 1 / count));
}

/// Sets the error of each figure of a kind from the same one of other drapes.
template <typename Figure, typename Same>
void take_spreads(std::vector<Figure>& figures,
                  const std::vector<const std::vector<Figure>*>& others, double Figure::*error,
                  const std::function<std::optional<double>(const Figure&)>& value, Same is_same) {
  for (Figure& figure : figures) {
    const std::optional<double> own = value(figure);
    if (!own) continue;
    std::vector<double> values = {*own};
    for (const std::vector<Figure>* drape : others) {
      const auto same =
          std::ranges::find_if(*drape, [&](const Figure& other) { return is_same(figure, other); });
      if (same == drape->end()) continue;
      if (const std::optional<double> theirs = value(*same)) values.push_back(*theirs);
    }
    if (const std::optional<double> spread = spread_of(values)) figure.*error = *spread;
  }
}

}  // namespace

double mean_edge(const DressedGarment& garment) {
  double sum = 0;
  for (const Triangle& corners : garment.flat_triangles) {
    for (int i = 0; i < 3; ++i) {
      sum += (garment.flat[corners[i]] - garment.flat[corners[(i + 1) % 3]]).norm();
    }
  }
  return garment.flat_triangles.empty()
             ? 0
             : sum / (3 * static_cast<double>(garment.flat_triangles.size()));
}

WornFigures measure_worn(const DressedGarment& garment, const TriangleMesh& body,
                         const Skeleton& skeleton, const std::vector<PanelRole>& worn_as,
                         const BodyMeasures& measures, const GirthOptions& options) {
  WornFigures figures;
  figures.girths = measure_girths(garment, body, skeleton, measures, options);
  figures.levels = measure_garment_levels(garment, body, skeleton, worn_as, measures);
  figures.lengths = measure_lengths(garment, skeleton, measures, worn_as, figures.levels);
  const double edge = mean_edge(garment);
  for (Girth& girth : figures.girths.rows) {
    girth.error = ease_error(girth.ease(), girth.ease_as_cut(), edge);
  }
  for (GarmentLevel& level : figures.levels) level.height_error = height_error(edge);
  for (GarmentLength& length : figures.lengths) {
    length.error = length_error(length.worn, length.as_cut.value_or(length.worn));
    for (EndsBeyond& end : length.ends) end.error = end_error(edge);
  }
  return figures;
}

void take_errors_from(const std::vector<WornFigures>& others, WornFigures& figures) {
  std::vector<const std::vector<Girth>*> girths;
  std::vector<const std::vector<GarmentLevel>*> levels;
  std::vector<const std::vector<GarmentLength>*> lengths;
  for (const WornFigures& drape : others) {
    girths.push_back(&drape.girths.rows);
    levels.push_back(&drape.levels);
    lengths.push_back(&drape.lengths);
  }
  // Levels between those with names lie at the same heights.
  take_spreads<Girth>(
      figures.girths.rows, girths, &Girth::error,
      [](const Girth& girth) {
        return girth.is_girth() ? std::optional(girth.ease()) : std::nullopt;
      },
      [](const Girth& a, const Girth& b) {
        return a.name == b.name && (!a.name.empty() || a.height == b.height);
      });
  const auto has_name = [](const auto& a, const auto& b) { return a.name == b.name; };
  take_spreads<GarmentLevel>(
      figures.levels, levels, &GarmentLevel::height_error,
      [](const GarmentLevel& level) { return std::optional(level.height); }, has_name);
  take_spreads<GarmentLength>(
      figures.lengths, lengths, &GarmentLength::error,
      [](const GarmentLength& length) { return std::optional(length.worn); }, has_name);
  for (GarmentLength& length : figures.lengths) {
    std::vector<const std::vector<EndsBeyond>*> ends;
    for (const std::vector<GarmentLength>* drape : lengths) {
      const auto same = std::ranges::find(*drape, length.name, &GarmentLength::name);
      if (same != drape->end()) ends.push_back(&same->ends);
    }
    take_spreads<EndsBeyond>(
        length.ends, ends, &EndsBeyond::error,
        [](const EndsBeyond& end) { return std::optional(end.by); },
        [](const EndsBeyond& a, const EndsBeyond& b) { return a.place == b.place; });
  }
}

}  // namespace toile
