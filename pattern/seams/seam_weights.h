// What speaks for and against a seam, and how much.
#pragma once

#include <array>

namespace toile {

/// What is measured of a seam, or of corners that meet. A score is the sum of each measure times
/// its weight; only ratios of weights matter. The measures of lengths are 0 where the two edges
/// coincide: such edges are equally long without being meant for each other.
///
/// A curve is cut in two for a reason: a notch, another piece, or fullness that begins there. Where
/// none is seen, one part is a slit and stays open, the lower one.
enum class SeamMeasure {
  seam,             ///< 1 for each seam
  equal_length,     ///< 1: lengths agree to 0.1 mm
  rare_length,      ///< 1: they do, and no edge of a third shape is that long
  close_length,     ///< 1, falling by e for each 0.5 % of difference
  near_length,      ///< 1, falling by e for each 3 % of difference
  log_ratio,        ///< logarithm of the longer over the shorter
  curve,            ///< 1: curved alike or into each other; -1: the contrary; 0: straight
  coincide,         ///< 1: the edges coincide
  coincide_curved,  ///< radians that edges turn which coincide, both added up, at most pi
  halves,  ///< the edges are mirror partners on two panels: their length over the longest edge
  halves_concave,  ///< the same: radians that both turn inwards, as at the crotch, at most 1
  folded_over,     ///< 1: one of the two panels is turned over, see SeamEvidence::turned_over
  across_grain,  ///< the edges coincide, and are no upper and lower one: the sine of their angle to
                 ///< the warp
  curve_gathered,  ///< the same as `curve`, where lengths differ by more than 30 %
  grains_differ,   ///< difference of the sines of the chords' angles to the warp
  up_and_down,  ///< outlines go up, by the warp as drawn, beyond one edge and down beyond the other
  both_up,      ///< they go up beyond both, as at a shoulder
  both_down,    ///< they go down beyond both
  rise_together,  ///< both go up, or both down, from where they begin to meet: the product of sines
  rise_apart,     ///< the same where one goes up and the other down
  same_panel,     ///< 1: both edges are of one panel, not the legs of a dart
  dart,           ///< 1: the legs of a dart
  dart_upwards,   ///< the same: cosine between the warp as drawn and the way to its tip, if above 0
  slit,  ///< the same of a skirt or of trousers, where none point up; 1: it is 25 cm long, or
         ///< cuts the hem
  ends_differ,   ///< the wider end of a four-sided piece meets the narrower end of another
  ends_alike,    ///< wider meets wider or narrower narrower: geometric mean of both logarithms
  concave,       ///< radians by which the edge turns inwards that does so less; 0 if one does not
  far_in_file,   ///< of different pieces: logarithm of the places between them in the file, at most
                 ///< 8. The two halves of one piece, by their names, have 0
  roles_agree,   ///< 1: pieces of two such kinds are sewn together, by their names
  sides_differ,  ///< 1: left and right, and not mirror partners
  hangs_turned,  ///< what hangs from a band or a sleeve does so by another edge than its upper one:
                 ///< 1 less the cosine upwards. The lower edge of a waistband is judged likewise
  faces_agree,   ///< 1: front and front, or back and back, of different pieces
  faces_differ,  ///< 1: front and back of different pieces
  end_to_end,    ///< the top of a front meets the hem of its back, or a hem of a skirt the other:
                 ///< the product of cosines
  centres_apart,  ///< middle edges of front and back of a bodice: the lesser way inwards, see below
  outsides_meet,  ///< side edges of the left and the right half of a bodice or of trousers
  centre_seam,    ///< middle edges of the left and the right half of these
  numbered_sides,  ///< sides of two numbered pieces of one name, both front or both back
  collar_halves,   ///< halves of a collar: the seam's length over the collar's longest edge
  hood_face,       ///< halves of a hood, at a long edge that is straight or turns inwards
  numbers_follow,  ///< 1: pieces of one name, not of one shape, numbered one after the other
  numbers_apart,   ///< 1: the same with numbers between them
  words_alike,     ///< of different pieces: words of the shorter name that the other has, 0 to 1
  named_halves,    ///< 1: the left and the right half of one piece, mirror partners
  front_and_back,  ///< 1: front and back of one piece, with one number or none
  numbers_differ,  ///< 1: front and back of one piece, with other numbers
  first_number,    ///< 1: of one name without a number, and the lowest number
  later_number,    ///< 1: of one name without a number, and another number
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

/// The weights in use. bench_fit_seam_weights fitted them to the samples and to three fifths of 160
/// random GarmentCode garments.
extern const SeamMeasures seam_weights;

}  // namespace toile
