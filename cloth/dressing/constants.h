// Constants of the stages: how seams close, how cloth settles, when a stage gives up.
// docs/constants.md shows what half and double of many of them do.
#pragma once

#include <array>
#include <cstddef>

namespace toile {

// Closing seams.

/// Weights of the cloth with which it is pulled toward the skin while seams close. 0 leaves one
/// ridge down the middle of a wide front.
inline constexpr double closing_pull = 2;

/// How the cloth is held while its seams close.
struct Closing {
  double bending;  ///< factor on the bending stiffness
  double pull;     ///< weights of the cloth, toward the skin
  /// Seams that the body holds apart close through it: one may start on the wrong side of an
  /// armpit.
  bool through_body = true;
};

/// The attempts to close seams, each from where the panels were placed. The next one follows when
/// the cloth came out tangled.
///
/// Of eleven garments that tangle in the first one, the second brings six clear, and the third two
/// others. In place of the second, the third alone brings three clear, and 3,000 with a pull of 0.5
/// brings three. Of eleven others that tangle with a bending factor of 300, eight do not with
/// 3,000. With 30,000 most tangle again, for gathers can't fold; but two of three that tangle three
/// times do not [measured].
inline constexpr std::array<Closing, 4> closing_attempts = {
    {{3000, closing_pull}, {10000, 0.5}, {10000, closing_pull}, {30000, closing_pull}}};

/// Factor on the width of panels, after each attempt in which the body held their seams apart or
/// they crossed it. What is cut far too small for an arm or a hip does not close around it.
inline constexpr double widening = 1.5;
/// Attempts with widened panels.
inline constexpr int wide_attempts = 3;

/// Factor on the width of widened cloth at each step of its shrinking.
inline constexpr double shrinking_ratio = 0.9;
/// Iterations of each step.
inline constexpr int shrinking_iterations = 200;

/// Largest momentum while seams close.
inline constexpr double closing_momentum = 0.99;

/// Iterations in which seams close on a mesh of `closing_points` points. A finer mesh, which has no
/// coarser one, has farther to carry the pull of its seams.
inline constexpr int closing_iterations = 3000;
inline constexpr double closing_points = 700;

/// Iterations in which seams close through the cloth that holds them apart.
inline constexpr int passing_iterations = 1000;

/// Metres within which the body passes for a plane while nothing has to come to rest.
inline constexpr double closing_linearization_radius = 2e-4;

/// N/m: cloth is at least so stiff along its yarns while its seams close.
inline constexpr double closing_stretch = 1000;
/// N/m: cloth is at least so stiff in shear while its seams close.
inline constexpr double closing_shear = 200;

/// Metres: edges of a mesh on which seams are sure to close, within bounds of the body. A coarser
/// one is tried once, where the next finer one is small enough to sew on.
inline constexpr double sewing_edge = 0.05;

/// Nodes of the coarsest mesh from which on panels are sewn only once: again takes minutes.
inline constexpr int max_resewn_nodes = 3000;

/// Metres between the bones of an arm and a panel's point, in the view from the front. An arm that
/// all points are farther from is in nobody's way, and stays as it is while seams close.
inline constexpr double arm_clearance = 0.15;

/// Radians by which raised arms stand above a panel that reaches above the shoulder beside them.
inline constexpr double wing_room = 0.21;
/// Metres outside the shoulder from which on a panel may be such a wing, and no front or yoke.
inline constexpr double min_wing = 0.15;
/// Lengths from shoulder to wrist up to which an arm reaches, with its hand.
inline constexpr double arm_reach = 1.4;

// Untangling.

/// Factor on the bending stiffness while crossing cloth is drawn apart. With 300, flat hems stay
/// crossed that come apart with this.
inline constexpr double untangling_stiffness = 30;
/// Iterations of that at most.
inline constexpr int untangling_iterations = 900;
/// Iterations in which the bending stiffness comes down to the fabric's.
inline constexpr int softening_iterations = 500;

// Settling.

/// Share of the stiffness that resists compression while the cloth finds its folds, from the finest
/// mesh to the coarsest. With all of it, cloth stands on creases that its mesh is too coarse to
/// break, and is strained more at rest.
inline constexpr std::array<double, 3> soft_compression = {0.02, 0.05, 0.01};

/// Iterations at most in which cloth settles on the finest mesh; each coarser one has twice as
/// many.
inline constexpr int settling_iterations = 2000;

/// Steps in which the floor rises under cloth that hangs below it, and iterations of each. Of a
/// narrow skirt 8.5 cm too long, a corner is left 5 mm below the floor. With 17 steps 24 mm are,
/// and with one 47 mm [measured, 15 mm edges].
inline constexpr int lifting_steps = 8;
inline constexpr int lifting_iterations = 100;

/// Metres of fall without friction, on average, from which on cloth falls again with friction. A
/// soft waist slides off the hips that would hold it. Of ten garments in three fabrics, those that
/// stay fall 0.04 m at most. Those that slide fall 0.1 and 0.2 m, and with friction 0.01 m
/// [measured, 25 mm edges].
inline constexpr double slid_off_fall = 0.06;

/// Metres of fall after which cloth lies at the feet or farther: it would go on sliding. Panels are
/// lifted by a third of that at most.
inline constexpr double fallen_off_drop = 0.6;

/// Pairs of triangles that may still intersect on the coarsest mesh for the garment to be brought
/// to rest. They count in the cloth, and with a body that held seams apart. What crosses more
/// ends `intersecting` at once. Of 61 garments that took five attempts and more, three were dressed
/// in the end.
inline constexpr std::size_t max_hopeful_intersections = 20;

/// Metres: the tightest curves of a body. They set how far nodes keep off, so that the faces
/// between them clear the skin. edge_contact_radius, which is smaller, decides which edges are
/// tested.
inline constexpr double body_curve_radius = 0.03;
/// Metres: the tightest folds of cloth, for the same purpose over layers.
inline constexpr double fold_curve_radius = 0.01;
/// Metres that nodes keep from the skin at most. Beyond, the drape would be another one.
inline constexpr double max_body_offset = 0.006;
/// Metres that nodes keep from a layer at most, while the cloth settles. It comes to rest nearer.
inline constexpr double max_fold_offset = 0.015;
/// Metres that faces stay clear of a curve when their nodes keep their offset.
inline constexpr double face_clearance = 0.001;
/// Growth of the offset from the skin with each coarser mesh, as a share of the finest one's.
inline constexpr double offset_growth = 0.5;

/// Metres: a point that is less deep by the smooth distance may be outside by the exact one.
inline constexpr double max_smooth_depth = -0.005;

/// Residual, in mean node weights, of cloth that may go on to the next mesh.
inline constexpr double settled_residual = 0.05;

/// Radius within which a mesh searches for cloth, in its edge lengths.
inline constexpr double search_radius_share = 0.4;
/// Metres that this radius exceeds the gap at which cloth touches, at least. It counts below some
/// 6 mm edges. With double, an iteration at 5 mm takes up to 1.1 times as long. With four times as
/// much it takes 1.2 to 1.3 times as long, with as many searches [measured on three garments].
inline constexpr double min_search_margin = 0.0004;
/// Metres: the largest such radius.
inline constexpr double max_search_radius = 0.02;

// Following a body into its pose. Halves and doubles were measured while the moves of cloth were
// still evened out over its neighbours, which was no better and left.

/// Metres that skin near the cloth moves in a step at most, on average over its way. With half and
/// double, shorts and a skirt that sit end alike, in 1.1 and 0.8 of the time. Shorts that catch at
/// the groin cross the body at 55 and 185 pairs for 122, and take 0.8 and 0.5 of the time.
inline constexpr double near_step = 0.015;
/// Metres that any other skin moves in a step at most, as of a hand that comes to a skirt.
inline constexpr double far_step = 0.04;
/// Share of a step to which it is cut where moved cloth would cross itself, at least. With 0.05 and
/// 0.6 two garments that sit end alike; with 0.6 those shorts cross at 201 pairs.
inline constexpr double least_step_share = 0.2;
/// Iterations in which cloth gives way to the body after a step. With half and double, two garments
/// end alike, in 1.1 and 1.0 of the time; those shorts cross at 168 and at no pairs.
inline constexpr int following_iterations = 150;

// Rest.

/// Iterations in which the finest mesh gets all of its stiffness and is pushed back to its own
/// offset. At once, that would throw it about, and creases stay. With 1000, twelve garments at 15
/// mm take 1.09 times the iterations of settling and rest.
inline constexpr int stiffening_iterations = 300;

/// Iterations without coming nearer to rest after which a run gives up.
inline constexpr int rest_patience = 8000;

/// Residual of whole patches, in their weights, of a garment that is to be released. One that is
/// not at rest as a whole would swing. At this residual 99 % of a garment move less than 2 mm in a
/// second [measured].
inline constexpr double releasable_residual = 0.0007;

/// Times at most that a garment that moves off when released is brought to rest again.
inline constexpr int max_returns = 3;

// Going on from an earlier drape.

/// Metres beyond the earlier panel that a garment may reach: its drape tells nothing of what lies
/// farther out.
inline constexpr double max_carried_outside = 0.05;

/// Metres: seams that are nearer to where they were have not moved. The points of a curve on two
/// meshes are a tenth of that apart.
inline constexpr double min_carried_shift = 0.001;

/// Metres: where the two sides of a seam stand farther apart, the earlier garment had not that
/// seam.
inline constexpr double max_carried_gap = 0.15;

// Layers.

/// Gaps within which two garments touch. Nodes press at one gap. Beside them nodes stand off by the
/// curve of the cloth under their triangles.
inline constexpr double touching_gaps = 1.05;

/// Metres: a flipped node is as far from the layer as before to within this.
inline constexpr double flip_tolerance = 1e-5;
/// Steps along the gradient in which a node is flipped over, at most.
inline constexpr int max_flip_steps = 30;
/// Metres that a node moves when it is flipped over, at most. Two layers are never so thick.
inline constexpr double max_flip_distance = 0.05;

}  // namespace toile
