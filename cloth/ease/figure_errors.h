// How sure the figures of a drape are. Each bar holds about nine of ten repeats of the drape.
#pragma once

#include <cmath>

namespace toile {

/// Metres: the error of an ease as worn, of start and mesh together, at edges of 15 mm and finer.
/// It held in 79 of 84 comparisons of six garments, and in 22 of 22 of nine others. Half and
/// double of it were not tried.
inline double ease_error(double ease) { return 0.003 + 0.03 * std::abs(ease); }

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

/// Metres: the error of a girth as cut, which comes from where the cloth hangs. Between meshes of
/// 15 and 10 mm, 9 of 10 named levels of seven garments differ by less. Half holds 8, double 9.
inline constexpr double as_cut_error = 0.003;

/// Metres: the error of the height at which an edge was drafted to lie. Hems and top
/// edges of three samples rest 0.7 to 1.1 cm from there at 15 mm. Half and double were not tried.
inline constexpr double drafted_error = 0.01;

/// Metres: the error of an edge's height on a mesh of that edge length. Heights differed by up to
/// 0.8 cm between 15 and 10 mm, and by up to 5 cm between 25 and 15 mm. Half
/// is less than what was seen.
constexpr double height_error(double edge_length) { return edge_length < 0.016 ? 0.008 : 0.05; }

}  // namespace toile
