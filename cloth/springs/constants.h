// Constants of the paper's method: its stages, its collisions, its springs.
#pragma once

namespace toile {

// Stages.

/// Weights of the cloth with which it is attracted, 5 cm and more off the skin.
inline constexpr double wrap_attraction = 0.15;

/// Seconds between two measurements of the state.
inline constexpr double watch_interval = 0.005;

/// The wrap is over when `wrapped_share` of the seams' pairs are this near, metres.
inline constexpr double wrapped_gap = 0.02;
inline constexpr double wrapped_share = 0.95;

/// Seconds in which the seams close in step.
inline constexpr double closing_seconds = 0.4;

/// Metres that a garment of the shoulders starts above where it is to hang. Its panels come down as
/// their upper edges lean in over the shoulders. A lower start catches below the shoulders.
inline constexpr double shoulder_start_height = 0.05;

/// Seconds in which the sewing force's unit of time halves: it grows until the seams close.
inline constexpr double tightening_seconds = 0.1;

/// Seconds: the smallest units of time, for wrapping and for sewing. At the smallest, the constant
/// force below delta is as strong as a hand.
inline constexpr double min_wrap_unit_time = 0.01;
inline constexpr double min_sewing_unit_time = 1e-4;

/// Seconds at the full force without progress, after which open seams count as not sewable.
/// Progress is a pair that merges, or a widest gap that comes down to `sewing_progress` of itself.
inline constexpr double sewing_patience = 0.3;
inline constexpr double sewing_progress = 0.98;

/// Factor on the bending stiffness while seams close: smooth panels don't fold through their seams.
inline constexpr double sewing_bending_factor = 10;

/// Seconds that folds get to come out of each other once the seams are closed.
inline constexpr double max_untangling_seconds = 0.3;

/// Seconds of draping before there is friction.
inline constexpr double frictionless_seconds = 0.25;

/// Residual, in mean node weights, of a garment at rest.
inline constexpr double spring_resting_residual = 0.05;

// Sewing.

/// Metres below which the sewing force acts after all others.
inline constexpr double landing_gap = 1e-4;

/// Metres between the points of a seam below which the cloth beside them may be strained to meet.
/// Where four panels come together, none could with all of its edges held to their lengths.
inline constexpr double easing_gap = 0.012;

/// Steps between two searches for such points.
inline constexpr int easing_interval = 100;

/// Sweeps over such pairs in a step: those that share a node undo each other's work.
inline constexpr int sewing_sweeps = 4;

// Springs.

/// Largest time step, in stable_step(). That bound is a safe one, and the strain control tames a
/// little more. Beyond, the cloth is thrown about, and each step finds ever more collisions.
inline constexpr double max_step_share = 2.001;

/// Share of the stiffness on a node that one of its some six bending springs may have.
inline constexpr double bending_spring_share = 0.1;

/// Largest stiffness over mass of a node, in medians of all nodes. Stiffer nodes are softened.
inline constexpr double max_over_median = 2.5;

/// Angle of a fold at the matched radius, in heights of its two triangles over that radius.
/// Measured: it fits most meshes.
inline constexpr double fold_angle_share = 0.6;

/// Metres: the radius of a fold in a garment, at which bending springs have the fabric's energy.
inline constexpr double matched_radius = 0.05;

// Strain control until the limit holds.

/// Sweeps over the springs in a step, at most.
inline constexpr int converging_passes = 30;
/// Strain over the limit at which the sweeps end, as a share of the limit.
inline constexpr double converged_excess = 0.05;
/// Share of the limit that the sweeps aim at. Collisions come after them and strain the cloth anew,
/// by a little.
inline constexpr double aimed_limit_share = 0.92;

// Collisions with the subject.

/// Metres: of what is nearer than this, no direction is known, and the surface gives one.
inline constexpr double touching = 1e-9;

/// Metres of motion after which distances are measured again.
inline constexpr double stale_distance = 0.0004;

/// Steps in which a point that is a little nearer than its gap is let out. So many that it leaves
/// the surface without visible speed.
inline constexpr double let_out_steps = 20;

/// Sweeps over the contacts of one node, at most, and the m/s of change below which they end.
inline constexpr int node_sweeps = 20;
inline constexpr double min_node_change = 1e-12;

/// Metres within which two nearest points are one contact.
inline constexpr double same_contact_distance = 1e-7;

/// Sine of the angle below which edges count as parallel. The contacts of their ends, which are
/// nodes and vertices, then suffice.
inline constexpr double parallel_edges_sine = 1e-6;

/// Share of a distance that a step may use up.
inline constexpr double usable_distance_share = 0.9;

/// Sweeps that cut velocities so that nothing crosses.
inline constexpr int guard_sweeps = 8;

/// Metres behind the surface up to which a node is let out.
inline constexpr double max_let_out_depth = 0.005;

/// Steps that the lists of candidates shall last, and the metres that this may cost.
inline constexpr double candidate_list_steps = 60;
inline constexpr double min_candidate_margin = 0.0015;
inline constexpr double max_candidate_margin = 0.01;

/// Share of the fastest approach, and m/s, that the impulses may leave of any approach.
inline constexpr double left_approach_share = 0.005;
inline constexpr double left_approach_speed = 1e-7;

/// Sweeps over the collisions in a round, and rounds of detection in a step.
inline constexpr int impulse_sweeps = 40;
inline constexpr int collision_rounds = 4;

// Collisions of the cloth with itself.

/// Metres beyond the gap within which other cloth is searched.
inline constexpr double self_search_distance = 0.003;

/// Seconds in which cloth nearer than the gap is let out.
inline constexpr double let_out_seconds = 0.005;

/// Sweeps over the list of pairs: an impulse on one pair changes its neighbours' speeds.
inline constexpr int self_sweeps = 2;

/// Steps at least between two searches. Cloth that has used up its bound waits.
inline constexpr int self_search_interval = 10;

}  // namespace toile
