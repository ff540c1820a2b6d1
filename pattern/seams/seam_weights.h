// What speaks for and against a seam, and how much.
#pragma once

#include <array>

namespace toile {

/// What is measured of a seam, or of corners that meet. A score is the sum of each measure times
/// its weight; only ratios of weights matter.
///
/// A curve is cut in two for a reason: a notch, another piece, or fullness that begins there. Where
/// none is seen, one part is a slit and stays open, the lower one.
enum class SeamMeasure {
  seam,            ///< 1 for each seam
  likely,          ///< logarithm of the odds that the pair is sewn, see sewn_logit()
  cone,            ///< 1: a corner that is no dart's tip closes on itself
  dart_tip,        ///< 1: a corner closes on itself, as the tip of a dart
  filled_slit,     ///< 1: two corners meet, one of them the tip of a slit that a godet fills
  needless_cut,    ///< 1: two seams of two panels, whose edges are two curves cut in two
  two_inside,      ///< 1: two corners meet inside the garment
  two_inside_off,  ///< by how much they miss 360 degrees, in units of 90 degrees
  three_inside,    ///< the same of three corners
  three_inside_off,
  four_inside,  ///< the same of four corners
  four_inside_off,
  more_inside,  ///< the same of more corners
  more_inside_off,
  notches_meet,   ///< notches of other edges that a notch meets
  notch_alone,    ///< 1: two corners meet, and one of them alone is a notch
  junction_off,   ///< of three or more: by how much the flattest corner or pair misses 180 degrees
  smooth_border,  ///< 1: one corner on the border within 20 degrees of 180
  lone_corner,    ///< 1: another corner between two open edges
  notch_in_border,    ///< 1: another corner between two open edges, beyond 180 degrees
  two_at_border,      ///< 1: two corners meet at the border
  two_at_border_off,  ///< by how much they miss 180 degrees, in units of 90 degrees
  slit_above,  ///< curves cut in two, of which the upper parts are open: the lesser sine of their
               ///< rise
  more_at_border,  ///< the same of three and four corners
  more_at_border_off,
  unlike,  ///< radians by which two edges turn differently that continue each other over a seam
  jump,    ///< change of the fullness along a seam that runs on straight, 1 is 20 % or more
  fold,    ///< points where panels meet that are turned over and others that are not
  same_fullness,    ///< seams that run on straight, both gathered, and by the same ratio
  narrow_open,      ///< open edges whose edge across is sewn and longer: the logarithms, at most 1
  border_hole,      ///< borders shorter than 8 cm
  border_small,     ///< borders of 8 to 16 cm
  one_border,       ///< 1: the garment has one border, or none
  two_borders,      ///< 1: it has two
  borders_missing,  ///< of those that sleeves, legs, and a neck or waist have, by their names
  many_borders,     ///< borders beyond four, at most six
  part_left_over,   ///< parts of the garment that are sewn to nothing else, less one
  handle,           ///< handles of the garment, as a twisted sleeve would make
  lopsided_seam,    ///< seams whose mirror image is not sewn
  count
};

inline constexpr int seam_measures = static_cast<int>(SeamMeasure::count);

using SeamMeasures = std::array<double, seam_measures>;

const char* name_of(SeamMeasure measure);

double score_of(const SeamMeasures& measures, const SeamMeasures& weights);

/// The weights in use.
extern const SeamMeasures seam_weights;

}  // namespace toile
