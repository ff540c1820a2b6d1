// How sure the figures of a drape are. Each bar holds about nine of ten repeats of the drape.
#pragma once

#include <cmath>

namespace toile {

// Girths, edges and lengths: what a drape says against the mean of three drapes of the same garment
// at 7 mm, from other starts. Fitted to eleven random garments, five starts and meshes of 25, 15
// and 10 mm each, and tried on eleven others [docs/report.md]. What as cut does not confirm is less
// sure: cloth that blouses, or that lies in folds.

/// Metres: a mesh with longer edges is coarse.
inline constexpr double coarse_edge_length = 0.016;

/// Metres: cloth with less ease than this lies on the skin all around. Half and double were not
/// tried.
inline constexpr double touching_ease = 0.015;

/// Metres: the error of an ease as worn.
inline double ease_error(double ease, double ease_as_cut, double edge_length) {
  const double fine = std::abs(ease) < touching_ease ? 0.006 : 0.01 + std::abs(ease - ease_as_cut);
  return edge_length < coarse_edge_length ? fine : 2 * fine;
}

/// Metres: the error of a girth as cut, which comes from where the cloth hangs.
inline double as_cut_error(double as_cut, double on_the_line) {
  return 0.005 + std::abs(as_cut - on_the_line);
}

/// Metres: the error of a length as worn. `as_cut`: the same where nothing is known.
inline double length_error(double worn, double as_cut) { return 0.008 + std::abs(worn - as_cut); }

/// Metres: the error of where a length ends.
constexpr double end_error(double edge_length) {
  return edge_length < coarse_edge_length ? 0.03 : 0.05;
}

// Loads: the bars hold nine of ten values of levels and panels at 15 mm against 10 mm and finer.
// They were fitted to four garments and tried on ten others [docs/report.md]. Half of them holds
// three of four, double all but one in seventy.

/// A fraction: the error of a strain, of its mean or largest.
inline double strain_error(double strain) { return 0.005 + 0.4 * std::abs(strain); }

/// N/m: the error of a tension, of its mean or largest.
inline double tension_error(double tension) { return 5 + 0.4 * std::abs(tension); }

/// Pa: the error of a mean pressure.
inline double mean_pressure_error(double pressure) { return 100 + 0.4 * pressure; }

/// Pa: the error of the largest pressure.
inline double largest_pressure_error(double pressure) { return 300 + 0.5 * pressure; }

/// Metres: the error of an edge's length on the flat beside the body's girth where it rests. The
/// length is exact; the place is not. Half and double were not tried.
inline constexpr double edge_as_cut_error = 0.003;

/// Metres: the error of the height at which an edge was drafted to lie. Hems and top
/// edges of three samples rest 0.7 to 1.1 cm from there at 15 mm. Half and double were not tried.
inline constexpr double drafted_error = 0.01;

/// Metres: the error of an edge's height on a mesh of that edge length. Half of the finer one holds
/// four of five.
constexpr double height_error(double edge_length) {
  return edge_length < coarse_edge_length ? 0.02 : 0.05;
}

}  // namespace toile
