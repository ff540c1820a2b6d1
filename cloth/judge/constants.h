// Constants of the verdict on a dressed garment.
// docs/constants.md shows what half and double of many of them do.
#pragma once

namespace toile {

// Seams (measures.h, tight_seams.h). A hand's pull and breadth, and how far flesh gives way, are in
// cloth/scene/constants.h.

/// Metres: two points of a seam that are nearer than this are sewn [Zhong & Xu 2009].
inline constexpr double sewn_gap = 1e-5;

/// Strain at which no seam is meant to be worn, a fraction, however soft the fabric.
inline constexpr double max_worn_strain = 0.25;

/// Lines at most along which a seam's missing cloth is measured. The largest of theirs counts.
inline constexpr int max_seam_lines = 24;

// Tight regions (tight_regions.h).

/// A triangle keeps the strain limit while its strain is at most this times the limit.
inline constexpr double kept_limit = 1.1;

/// m² of the flat panel: smaller regions are only counted.
inline constexpr double min_region_area = 1e-4;

/// Lines that are laid through a region to find where the most is missing.
inline constexpr int region_lines = 24;

// What goes around a part (wraps.h).

/// Share of the directions square to a part's bones. Cloth that is not closed and meets less does
/// not go around the part. A cardigan meets more; a shirt that lacks a quarter meets 80 % at most.
inline constexpr double around_share = 0.85;

/// Stations along the bone that a part covers.
inline constexpr int wrap_stations = 32;

/// Directions around a station.
inline constexpr int wrap_directions = 360;

/// Shares of where a part's cloth lies along the bone between which it has to cover the bone. Hems
/// that slant or swing take up the rest.
inline constexpr double limb_cover_begin = 0.25;
inline constexpr double limb_cover_end = 0.75;

/// Share of a part's nodes at either end that play no part in where the cloth lies.
inline constexpr double stray_share = 0.01;

// Slits (slits.h).

/// Radians, 310 degrees: cloth that turns so far about a point of the border ends a slit there. An
/// armpit whose side seam is open has 338 and more on the samples. A V neckline has about as much.
/// At 340 the fitted T-shirt's open side is missed; at 270 every square corner ends a slit.
inline constexpr double min_slit_turn = 5.41;

/// Radians, 30 degrees, and metres: where the border turns by more within that length, a slit's
/// edge ends in a corner. At half the length a rounded corner of 5 cm is none; at double, the curve
/// from waist to hip is one.
inline constexpr double max_slit_bend = 0.52;
inline constexpr double slit_corner = 0.05;

/// Metres: shorter slits are vents and notches.
inline constexpr double min_slit = 0.05;

// Openings (openings.h).

/// Share of the girth that has to pass an opening. What is cut smaller can't be put on: cloth is
/// worn stretched by a quarter at most. Half names no neckline or waist of which a half is sewn
/// shut (they have 0.42 to 0.74). Double names every neckline of the samples.
inline constexpr double shut_opening_share = 0.8;

/// Steps in which a stretch of the trunk is measured for its largest girth. At half and double the
/// hips of the sample mannequin differ by 0.1 mm.
inline constexpr int trunk_stations = 12;

// The drape and its mirror image (asymmetry.h).

/// Metres: the outline of a panel and that of its partner differ by less. With half and with double
/// the same seven samples of seven are symmetric [measured, 25 mm].
inline constexpr double mirrored_outline = 0.003;

/// Metres between the mirrored points of two that are sewn together. With half and with double the
/// same seven samples are symmetric [measured, 25 mm].
inline constexpr double mirrored_seam = 0.01;

/// Points of a panel that are mirrored, about. Half finds 2.2 cm, not 3.1, on a skirt; double finds
/// no more on seven samples [measured, 25 mm].
inline constexpr int mirrored_points = 300;

/// Pairs of a seam's points whose mirrored points are compared, about. With half and with double
/// the same seven samples are symmetric [measured, 25 mm].
inline constexpr int mirrored_seam_points = 8;

// Where a garment is worn (wear_check.h).

/// Metres: border of the smallest opening that a limb is meant to pass through.
inline constexpr double min_limb_opening = 0.15;

/// Metres: border of the smallest opening that a head is meant to pass through.
inline constexpr double min_neck_opening = 0.3;

/// Share of the height from waist to armpits below which no strapless top ends.
inline constexpr double strapless_share = 0.25;

/// Share of the height from waist to armpits above which no skirt begins.
inline constexpr double max_skirt_top_share = 0.67;

/// Share of the crotch's height: the middle of an open skirt about the trunk lies above it. One
/// that has slid to the knees lies below.
inline constexpr double min_sheet_share = 0.5;

/// Metres above the armpits below which the middle of an open sheet about the trunk lies, so that
/// it does not hang from the head.
inline constexpr double max_sheet_rise = 0.3;

/// Metres: panels whose middles are nearer tell no direction.
inline constexpr double min_face_distance = 0.03;

/// Cosine of the largest angle, 60 degrees, that a garment may be turned by about the vertical.
inline constexpr double min_facing_cosine = 0.5;

/// Metres beyond the shoulder joint at which a strap has slid off the shoulder.
inline constexpr double slid_off_shoulder = 0.025;

/// Metres: sleeves whose seam with the trunk is flatter have no crown to tell up from down.
inline constexpr double min_crown_height = 0.03;

/// Correlation of how far an armhole seam is from the line of the cuff with its height as worn.
/// Below this the sleeve is set in upside down.
inline constexpr double upside_down_correlation = -0.3;

/// Share of a garment's cloth, without sleeves, that may hang upside down in folds. The samples
/// have 0.2 % at most. A waistband far too wide, which falls over, has 6 %, and a band three sizes
/// small 11 %. A dress with a fold around its hips has 16 %. Half misplaces that band, double
/// passes that dress.
inline constexpr double max_folded = 0.13;

/// Sine of the slope, 30 degrees, from which on cloth hangs rather than lies. At half, the elastic
/// skirt's folds count with 1.1 % of its cloth. At double nothing hangs.
inline constexpr double min_hang = 0.5;

/// Share of directions that a garment meets which is open as its seams leave it. Boleros meet 75 %.
inline constexpr double open_front_share = 0.5;

/// Metres by which a top edge may come down from where it was drafted to lie. It is beyond the
/// height's error on meshes of 25 mm.
inline constexpr double max_slid = 0.08;
/// Metres that a garment slid or rode up, from which on it is said.
inline constexpr double worth_saying_slid = 0.02;

/// Metres from the bones beyond which cloth lies beside the body.
inline constexpr double beside_body = 0.5;

}  // namespace toile
