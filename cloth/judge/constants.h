// Constants of the verdict on a dressed garment.
// docs/constants.md shows what half and double of many of them do.
#pragma once

namespace toile {

// Seams (measures.h, tight_seams.h).

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

// Tubes (wraps.h, verdict.h).

/// Share of the directions square to a part's bones. A tube that meets less does not go around the
/// part: cloth that lies on one side of it meets half of them at most.
inline constexpr double around_share = 0.5;

/// Stations along the bone that a part covers.
inline constexpr int wrap_stations = 32;

/// Directions around a station.
inline constexpr int wrap_directions = 360;

/// Metres: nodes no farther than this from a part's first or last node count as its top or hem.
inline constexpr double end_depth = 0.02;

/// Shares of its length, from the top down, between which a skirt, an arm or a leg has to cover the
/// bone. Ease, a hem that swings and folds take up the rest.
inline constexpr double limb_cover_begin = 0.25;
inline constexpr double limb_cover_end = 0.75;

/// Shares of its length below the armpits between which a torso has to cover the bone. Ease, a hem
/// that swings and folds take up the rest.
inline constexpr double torso_cover_begin = 0.1;
inline constexpr double torso_cover_end = 0.7;

/// Share of its length that a skirt may slide, or `hand_breadth` if that is more. One that slid
/// farther does not cover what it should.
inline constexpr double max_slid_share = 0.5;

}  // namespace toile
