// Constants of where a garment starts.
// docs/constants.md shows what half and double of many of them do.
#pragma once

#include "geometry/angles.h"

namespace toile {

// Positioning by the skeleton (positioning.h).

/// Metres: the least distance from the skin of a flat panel whose pattern does not state it. The
/// distance grid is exact within its band, and good to a centimetre or so beyond.
inline constexpr double flat_offset = 0.04;

/// Metres: the least distance from the skin of a rolled panel whose pattern does not state it.
inline constexpr double rolled_offset = 0.005;

/// Metres between the distances from the bones that are tried.
inline constexpr double positioning_step = 0.005;

/// Metres: the largest distance from the bones to a flat panel.
inline constexpr double max_panel_distance = 1.5;

/// Metres that the radius of a rolled panel may exceed its tightest one.
inline constexpr double max_radius_growth = 0.3;

/// Metres between the lengths tried by which a sleeve is drawn down its arm.
inline constexpr double draw_step = 0.01;

/// Metres: the longest length by which a sleeve is drawn down its arm.
inline constexpr double max_drawn_out = 0.20;

/// Metres by which a flat panel has to come nearer to the arm for one `draw_step` down the arm.
/// The slope of the arm alone brings less.
inline constexpr double min_draw_gain = 0.002;

/// Metres of gap and of draw that a panel rolled about bent bones has to spare.
inline constexpr double min_bend_gain = 0.02;

/// Degrees by which a band at the neck is tried to lean to the front. At the neck of `mean_male` a
/// band of 4 cm has a radius of 13.5 cm at 0 degrees, 9 at 12, 8.7 at 24.
inline constexpr double neck_leans[] = {10, 20, 30};

/// Metres between the panels of a leg and the plane between the legs.
inline constexpr double leg_plane_clearance = 0.005;

/// Cosine between a flat panel and the direction to its own side of the plane between the legs. A
/// panel with a smaller one stands beside its leg; only its distance can clear the plane.
inline constexpr double min_sideways_cosine = 0.5;

/// Halvings of a `positioning_step`, toward the smallest distance that is clear.
inline constexpr int clearance_halvings = 6;

// Panels that hang from their upper seam (hang_from_seams.h).

/// Cosine between two panels from which on they face alike, and between a panel and the plumb line
/// from which on it hangs down. Half and double were not tried.
inline constexpr double same_facing = 0.5;

/// Metres below the highest point of a skirt alone, within which the tops of its upper panels lie.
inline constexpr double top_slack = 0.05;

/// Metres between the sides of an upper seam, on average, below which a panel stands well as it is.
/// 59 skirts take 0.94 of the time that they took before. With double they take 1.06, and three
/// more are sewn twice. Half was not tried.
inline constexpr double near_seam = 0.05;

/// Radians by which a panel opens as a fan at most. With 175 degrees these skirts take 0.96 of the
/// time. Without a fan a very wide one takes 338 s in place of 43. Half was not tried.
inline constexpr double max_fan = to_radians(120);

// Legs (centre_legs.h).

/// Metres that the seams of a trouser leg keep from the bones once they are moved.
inline constexpr double leg_seam_clearance = 0.03;

// The body part of a panel (panel_parts.h).

/// Metres from the body's middle: no sleeve begins nearer, not even one cut up to the neck.
inline constexpr double innermost_sleeve = 0.03;

/// Share of a panel's width that lies on its narrower side of the body's middle. A panel with more
/// lies in front of both legs, and belongs to the torso.
inline constexpr double both_sides_share = 0.15;

// Panels laid flat, in a front and a back face (flat_layout.h).

/// Points at which a seam between two panels is compared.
inline constexpr int flat_seam_samples = 9;

/// Points of a panel, about, that tell how much of it lies upon another one.
inline constexpr int flat_overlap_samples = 24;

/// Ratio of a seam's sides from which on the longer one counts as gathered.
inline constexpr double min_gather = 1.15;

/// Metres: a seam around the side, from front to back, counts like one with this gap. It keeps the
/// faces whole.
inline constexpr double side_seam_gap = 0.06;

/// Metres: square metres that lie upon others in a face, times this, count as misfit.
inline constexpr double overlap_weight = 0.03;

/// Metres: the square of the faces' difference in area, over their sum, counts as misfit with
/// this.
inline constexpr double face_balance_weight = 0.01;

/// Pairs of panels of unknown faces that are sewn together, up to which arcs change faces.
inline constexpr std::size_t max_arc_seams = 40;

/// Share of a panel that lies upon another one of its face, from which on it stands before that.
inline constexpr double min_share_upon = 0.1;

/// Sweeps over all panels to compare two choices of faces, and for the layout that is kept.
inline constexpr int layout_trial_sweeps = 30;
inline constexpr int layout_final_sweeps = 1000;

/// Panels of unknown faces up to which all choices are tried.
inline constexpr std::size_t max_tried_faces = 11;

/// Rounds in which faces of single panels are changed.
inline constexpr int max_face_rounds = 20;

// Landmarks of a garment that lies flat (flat_landmarks.h), and its place (find_places.h).

/// Metres along the border of a hole that counts as an opening.
inline constexpr double min_flat_opening = 0.15;

/// Metres above and below a seam at which it has cloth or has none.
inline constexpr double shoulder_probe = 0.03;

/// Metres to either side of the middle where the top of a face is measured.
inline constexpr double face_top_width = 0.03;

/// Metres from the middle plane to the shoulder joint, as shares, between which shoulder seams lie.
inline constexpr double inner_shoulder = 0.35;
inline constexpr double outer_shoulder = 1.0;

/// Distances from the middle plane to the shoulder joint, beyond which a cuff lies.
inline constexpr double cuff_shoulders = 1.5;

/// Metres between the necklines of front and back that tell them apart.
inline constexpr double min_neck_difference = 0.01;

/// Share of its points by which a panel may differ from its twin, where both are legs of one piece.
/// Of drawn leggings it is 0 for the legs, and 0.84 for a leg and its waistband. So half and double
/// find the same legs.
inline constexpr double leg_likeness = 0.2;

/// Cosine between two sewn sides at a point, from which on they turn a corner there: 120 degrees.
inline constexpr double strip_corner = -0.5;

/// Share of TubeFit from which on a strip goes around. One that covers half of the way around fits
/// by 0.64, one that covers two thirds by 0.83.
inline constexpr double min_tube_fit = 0.8;

/// Metres from the middle plane to the side of a hood, as a share of that to the shoulder joint.
inline constexpr double hood_distance = 0.65;

/// Metres below the waist joint at which skirts and trousers begin.
inline constexpr double waist_border_depth = 0.02;

/// Metres below the body's crotch, at least, at which that of trousers starts.
inline constexpr double crotch_depth = 0.03;

/// Metres from the middle to that of the opening of a leg, at least.
inline constexpr double min_leg_offset = 0.03;

/// Metres above and below the crotch, where the width of a leg is measured.
inline constexpr double crotch_strip = 0.03;

/// Share of a garment's height below its highest opening in which shoulder seams lie.
inline constexpr double max_shoulder_drop = 0.35;

/// A tube of a pattern without names that is wider than the waist by this ratio, and shorter than
/// this many metres, is a top.
inline constexpr double wide_tube_ratio = 1.15;
inline constexpr double short_tube_height = 0.45;

/// Metres to either side of a point of the shoulder, within which its height is measured.
inline constexpr double shoulder_strip = 0.015;

/// Metres that shoulder seams start above the shoulders.
inline constexpr double shoulder_seam_gap = 0.015;

/// Metres from the skin, in front and at the back, to the faces.
inline constexpr double face_distance = 0.1;

/// Metres from the bones of an arm to the faces of its sleeve.
inline constexpr double sleeve_face_distance = 0.15;

/// Metres by which a panel stands before one of its face that it lies upon.
inline constexpr double face_layer_distance = 0.04;

// Places that a pattern states, against those that its seams tell (places_fit.h).

/// Share of the largest panel's area from which on the place of a panel tells.
inline constexpr double min_telling_area = 0.2;

/// Degrees that a panel may be off the upright.
inline constexpr double max_panel_lean = 12;

// The layout as a whole (locate_layout.h).

/// Metres: a layout of less depth has no front and no back, and lies in one plane.
inline constexpr double min_layout_depth = 0.02;

/// Metres from the body's axis to a plane that lies within the body.
inline constexpr double max_plane_offset = 0.08;

/// Upright planes have normals with a smaller vertical part.
inline constexpr double max_upright_normal = 0.7;

/// Metres by which the top of a garment may stand below the armpits, or of a strapless one below
/// the waist. Of 158 random garments 157 stand from 8 cm above to 10 cm below their place.
inline constexpr double layout_slack = 0.03;

/// Metres below the waist at which skirts and trousers may begin.
inline constexpr double max_low_rise = 0.18;

/// Metres by which the top of a garment may stand above its place.
inline constexpr double max_layout_height = 0.4;

/// Metres of misfit by which the body's own move has to fit better.
inline constexpr double min_better_fit = 0.15;

/// Metres by which the top of a garment with shoulder seams may stand above the neck. The
/// sample T-shirt stands 4 cm above it. With half of it, up to 10 of 160 random garments are
/// lowered on the body that they were drafted for. With double, T-shirts for 1.70 m are caught at
/// the chin of women of 1.47 and 1.54 m.
inline constexpr double max_shoulder_rise = 0.15;

/// Metres from the body's axis to the middle of a layout that stays.
inline constexpr double max_layout_offset = 0.3;

/// Metres above the middles of its panels at which a seam is a shoulder's.
inline constexpr double min_shoulder_height = 0.05;

/// Metres of misfit of a layout that is turned by a right angle.
inline constexpr double turned_misfit = 0.3;

// Sleeves (align_sleeves.h).

/// Radians that a sleeve is off its arm before it is turned. T-shirts and a shirt are 3 to 9
/// degrees off arms like those they were laid out for. They are 12 to 52 degrees off arms that hang
/// lower, swing or reach forward [measured].
inline constexpr double min_sleeve_turn = to_radians(11);

/// Cosine between a seam and the arm. A seam with at least this runs along the sleeve, not around
/// it.
inline constexpr double along_sleeve_cosine = 0.5;

// Sleeves (centre_sleeves.h).

/// Metres that the seams of a sleeve should keep from the outline of the arm.
inline constexpr double sleeve_clearance = 0.015;

/// Metres between the two sides of a seam that closes around the arm, at least.
inline constexpr double min_sleeve_depth = 0.05;

/// Degrees by which a sleeve turns about its armhole at most, in steps of one.
inline constexpr int max_sleeve_degrees = 20;

/// Metres between the shifts that are tried.
inline constexpr double sleeve_lift_step = 0.005;

/// Shifts that are tried to either side.
inline constexpr int max_sleeve_lifts = 30;

/// Share of the square of a move that counts against it, beside the squares of what seams lack.
inline constexpr double centring_reluctance = 1e-3;

// Lifting (turn_and_lift.h).

/// Metres between the lifts that are tried.
inline constexpr double lift_step = 0.01;

/// Lifts that are tried at most.
inline constexpr int max_lift_steps = 20;

/// Share of the pairs that the body obstructs unlifted, which a lift may leave. Of 76 random
/// garments and 75 small T-shirts on women, 67 and 74 are dressed. With half of it 65 of the 76
/// are, with double, where one pair fewer is enough, 67 and 70.
inline constexpr double lift_share = 0.5;

/// Metres added to the smallest lift that works: room for the cloth to come down onto the
/// shoulders.
inline constexpr double lift_margin = 0.03;

/// Metres above the chest joint. A garment with a seam higher than this hangs from the shoulders.
inline constexpr double shoulder_seam_height = 0.05;

// The paths of seams (seam_paths.h).

/// Metres that a meeting place has to keep from the skin, so that the seam finds its way out.
inline constexpr double meeting_clearance = 0.01;

/// Metres between two probes of the body along a path. The path may graze the body over less than
/// that.
inline constexpr double seam_path_step = 0.02;

/// Metres down the arm from the shoulder joint. Seams have to come over this part of the arm, so it
/// obstructs no path for good.
inline constexpr double armpit_length = 0.1;

// Panels widened while their seams close (widening.h).

/// Cosine between a seam and the bones from which on it runs along them.
inline constexpr double seam_along_cosine = 0.5;
/// Cosine between the bones of two panels from which on these go around the same part of the body.
inline constexpr double same_way = 0.9;

// Moving panels off layers (move_off_layers.h).

/// Metres between the displacements that are tried.
inline constexpr double layer_clearing_step = 0.01;

/// Displacements that are tried at most.
inline constexpr int max_layer_clearing_steps = 40;

/// Metres: the least distance from the collider at which a point of a further layer starts.
inline constexpr double layer_start_clearance = 0.01;

/// A panel faces one direction when its areas, added as vectors, keep this share of their sum.
inline constexpr double facing_flatness = 0.5;

// Resolving intersections (resolve_intersections.h).

/// Metres between the displacements that are tried.
inline constexpr double clearing_step = 0.01;

/// Displacements of a flat panel that are tried at most.
inline constexpr int max_flat_clearing_steps = 70;

/// Displacements of a panel that bends around its body part that are tried at most.
inline constexpr int max_bent_clearing_steps = 15;

/// A panel moves along its normal when its areas, added as vectors, keep this share of their sum. A
/// flat one has 1. One rolled half around has 0.64, two that stand square to each other 0.71.
inline constexpr double planar_flatness = 0.68;

/// Metres to either side of a panel at which the distance to the collider tells which side is out.
inline constexpr double outward_probe = 0.1;

/// Share of `outward_probe` by which a panel's right side has to be nearer to the collider, on
/// average, to count as the wrong one.
inline constexpr double wrong_side_share = 0.5;

/// Metres: a point with a smaller distance is surely inside the collider. The distance grid rounds
/// off corners, but not by that much.
inline constexpr double surely_inside = -0.002;

/// Metres: panels whose distances from the collider differ by less than this move in the order of
/// the pattern, whatever rounding makes of the distances.
inline constexpr double same_distance = 1e-4;

// Warnings on placement (placement_warnings.h).

/// Half widths of a panel between its middle and the body's. A panel with less stands on both
/// sides.
inline constexpr double one_side_offset = 0.5;

/// Share of a group's seams that reach across the middle. A group with more may belong on the other
/// side.
inline constexpr double max_seams_across = 0.5;

/// Share of their length that a group's seams have with the group on the other side. A group with
/// less belongs there.
inline constexpr double much_shorter = 0.65;

/// Metres per pair of seam points by which the seams have to be shorter there.
inline constexpr double min_seam_gain = 0.15;

/// Two panels are mirror images when their middles and sizes agree to this share of a size. Such
/// panels, sewn together, can only change places.
inline constexpr double image_tolerance = 0.15;

/// Below this value of facing_out(), a panel is inside out.
inline constexpr double inside_out_facing = -0.5;

/// Triangles of a panel at which facing_out() samples the skin, at most about twice this.
inline constexpr int facing_samples = 50;

}  // namespace toile
