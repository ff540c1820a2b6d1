// Constants of patterns and their meshes.
#pragma once

#include "geometry/angles.h"

namespace toile {

/// Share of the shorter side. A seam whose sides differ by more is eased or gathered: the check
/// notes it, and the cloth of the longer side gives way.
inline constexpr double gather_threshold = 0.02;

/// Share of the shorter side. A seam whose sides differ by more without being declared gathered
/// gets a warning: it is gathered, or a mistake.
inline constexpr double seam_warning_threshold = 0.20;

/// Share of a panel's width across a seam that the seam's edges are apart, when it closes around
/// its part. A sleeve of any length has 0.8 to 1, a dart less than 0.2.
inline constexpr double min_around_gap = 0.5;

/// Shares of area and moments by which panels may differ that are each other's like or mirror
/// image. In the samples and two garments of GarmentCode such panels differ by 0.0002 at most.
/// Others differ by 0.0104 at least, as a T-shirt's front and back. Half and double tell the same.
inline constexpr double twin_tolerance = 0.005;

/// Letters of a name that is too short to tell a side or a face: panels may be named a to f. At 1,
/// `fr` and `bk` tell a face; at 4 `back` does not.
inline constexpr int most_letters_of_no_side = 2;

/// A declared fullness may differ from the drawn one by this share.
inline constexpr double fullness_tolerance = 0.05;

/// Metres: an edge whose ends are closer is a drawing error, not cloth.
inline constexpr double min_edge_length = 1e-4;

/// Metres: a shorter edge is merged with its neighbours. GarmentCode cuts edges where the other
/// side of a seam has a dart or a corner. What is left can be shorter than the cloth is thick.
inline constexpr double short_edge_length = 3e-3;

/// Metres: no point of an outline moves farther than this when short edges are merged and sharp
/// corners opened.
inline constexpr double max_outline_shift = 3e-3;

/// Panels of a pattern, edges of a panel and stitches of a pattern at most. Garments have some
/// hundred of each. The time to mesh a panel grows with the square of its edges.
inline constexpr int max_panels = 1'000;
inline constexpr int max_panel_edges = 2'000;
inline constexpr int max_stitches = 20'000;

/// Curves of one edge at most. A hand-drawn edge has some ten.
inline constexpr int max_chain_curves = 1'000;

/// N: the stiffness of an elastic whose pattern states none, estimated. A waistband's elastic takes
/// some 10 N when it is half as long again.
inline constexpr double usual_elastic_stiffness = 20;

/// A circle's radius that is too short for its chord by more than this share gets a note.
inline constexpr double radius_note_threshold = 1e-3;

/// The placed end points leave the direction of a seam undecided when their distances in both
/// directions nearly agree. They do when they differ by less than this share of their sum.
inline constexpr double undecided_seam_direction = 0.01;

/// The placed panels leave open which side is out when their mean outward offset is below this
/// share of their mean distance from the centre.
inline constexpr double undecided_right_side = 0.05;

/// Square metres: a seam between a left and a right half times the distance of a half's middle from
/// it. Less says nothing of the right side.
inline constexpr double undecided_halves = 1e-3;

/// Metres: panels whose origins are nearer share one place.
inline constexpr double same_origin = 1e-3;

/// Levels of subdivision that a mesh has at most.
inline constexpr int max_subdivisions = 4;

/// Metres: the edge length of the coarsest level, by which the number of subdivisions is chosen.
inline constexpr double coarsest_edge = 0.04;

/// Triangles of the coarsest level from which on another subdivision is used. Seams close on that
/// level, which takes minutes for wide skirts of 15,000 triangles.
inline constexpr double max_coarsest_triangles = 6000;

/// Triangles of the coarsest level from which on another subdivision is used where its edges stay
/// below longest_coarse_edge. Of 21 random garments at 15 mm that have so many, the median
/// then takes 0.65 of the time. Half and double were not tried.
inline constexpr double many_coarsest_triangles = 2500;
/// Metres. With 0.13, wide skirts tangle on the coarsest level, and one of 40 garments was lost.
inline constexpr double longest_coarse_edge = 0.065;

/// A step along an outline may be longer than asked for by this share before another step is added.
inline constexpr double outline_step_tolerance = 0.15;

/// Radians that a curve turns at most within one step of the coarsest level, as far as
/// `max_step_refinement` allows it.
inline constexpr double max_turn_per_step = to_radians(35);

/// A curve that turns sharply gets at most this many times the steps that its length asks for.
inline constexpr int max_step_refinement = 3;

/// A curve that turns sharply may get this many steps, however short it is.
inline constexpr int max_steps_of_short_curve = 12;

/// Radians: triangles with a smaller angle are needles, and no ground to simulate on.
inline constexpr double needle_angle = to_radians(3);

/// Times that steps along an edge are halved where triangles would be needles. With 2, a panel with
/// corners of 5 degrees is meshed with edges from 10 to 25 mm [measured].
inline constexpr int max_step_halvings = 2;

/// Radians: a corner that a curve makes as sharp as a needle is opened to this angle.
inline constexpr double opened_corner = to_radians(5);

/// Radians: edges that overlap by more beside a corner cross each other.
inline constexpr double max_corner_overlap = to_radians(10);

/// Radians: points of finer levels stay at the middles of edges unless an angle is smaller.
inline constexpr double acceptable_angle = to_radians(25);

/// Triangles of a garment at most.
inline constexpr double max_garment_triangles = 2e6;

}  // namespace toile
