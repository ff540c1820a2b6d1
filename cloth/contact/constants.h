// Constants of contact: stiffness of pushes, distances at which they act, shares of the bounds.
// docs/constants.md shows what half and double of many of them do.
#pragma once

namespace toile {

// The body.

/// Metres from the skin at which the attraction to the body reaches its full strength.
inline constexpr double full_attraction_distance = 0.05;

/// N/m: stiffness of the body's push on one vertex. A node of 1 cm² that 100 Pa press to the skin
/// sinks in by 0.01 mm.
inline constexpr double body_push_stiffness = 1000;

/// Metres of depth from which on the body's push is firm, and how much faster it grows there.
/// Without it a cuff that is stretched by a half sinks in until its edges cross the arm. Of 18
/// tight garments with 20 mm edges, 14 are dressed with a factor of 1 and 16 with 10. While all
/// stages had it, 17 were with 4 and 16 with 30 [measured].
inline constexpr double firm_depth = 0.001;
inline constexpr double firm_push_factor = 10;

/// Share of the usual way on which a plane stands for the skin where the push is firm. Such a push
/// turns with the plane by more than the weight of a node. With 1 one of 18 tight garments does not
/// rest. With 0 all do, in 1.2 times the time [measured while all stages had the push].
inline constexpr double firm_reach_share = 0.1;

/// N/m: stiffness of the friction spring that holds a sticking vertex to its anchor on the skin.
inline constexpr double body_friction_stiffness = 200;

/// Metres off the offset surface from which a plane stands for the body.
inline constexpr double body_activation_distance = 2e-4;

/// Slope of the distance along its gradient, below which no plane stands for the body. Midway
/// between two surfaces, as arm and chest, the distance has a ridge that the grid rounds. There it
/// rises less steeply than this, and curves too much for a plane.
inline constexpr double ridge_slope = 0.97;

/// Metres around a triangle of the cloth within which its region heeds the body's facets. With
/// more, the triangle may slide farther, but fewer planes have all of the facets behind them.
inline constexpr double facet_search_distance = 0.005;

/// Metres that a triangle of the cloth should keep from the body's facets. A nearer triangle has
/// its corners lifted.
inline constexpr double facet_clearance = 0.0002;

/// Metres by which a corner is lifted at most, so that its triangles clear the body's facets.
inline constexpr double max_facet_lift = 0.015;

/// Share of a region's width. When a corner has less than this left, the region is due. So it is
/// found anew before it stops the corner.
inline constexpr double due_region_share = 0.3;

/// Updates of the body bounds between two updates of one region. Cloth that presses against the
/// body would be due at each of them.
inline constexpr int region_update_interval = 4;

// Cloth.

/// N/m: stiffness of the push between the two sides of a pair.
inline constexpr double pair_push_stiffness = 200;

/// N/m: stiffness of the friction spring between the two sides of a pair. Hundreds of pairs hold a
/// garment, whose weight moves them by micrometres.
inline constexpr double pair_friction_stiffness = 50;

/// Square of the sine of the angle below which two edges count as nearly parallel, 27 degrees. With
/// less, the push changes too fast with the angle, and needs shorter steps.
inline constexpr double parallel_squared_sine = 0.2;

/// Metres by which the two sides of a pair may approach before the active pairs are found anew.
/// Each vertex may use half of it.
inline constexpr double pair_activation_margin = 0.001;

/// Share of the distance to the nearest other cloth that a vertex may move. Both sides move, so it
/// is just under one half.
inline constexpr double proximity_bound_share = 0.45;

/// Share of its bound. A vertex that has used more of it gets a new bound at an update.
inline constexpr double stale_bound_share = 0.4;

/// Share of the moving vertices. Where more than this have stale bounds, an update searches around
/// all vertices.
inline constexpr double max_partial_update = 0.25;

/// Share of the shortest edge at rest to which neighbours in the mesh may approach each other.
inline constexpr double neighbour_gap_share = 0.25;

/// Distance, in gaps that neighbours keep, from which on they get no force. They cannot touch
/// before the next search.
inline constexpr double neighbour_force_range = 3;

// Edges that pass through faces (edge_face_intersections.h).

/// Sine of the angle between an edge and the face that it passes through, at least. A flatter edge
/// would have a way out that is too long.
inline constexpr double min_crossing_slant = 0.2;

// The grid of spheres.

/// Multiple of the mean radius. Larger spheres are not filed in cells but compared with every
/// query.
inline constexpr double large_sphere_ratio = 1.5;

/// Cells of the grid per sphere, at most. Empty cells cost time too, so small spheres far apart get
/// large cells.
inline constexpr double max_cells_per_sphere = 8;

/// Factor by which cells grow until there are few enough of them.
inline constexpr double cell_growth = 1.2;

}  // namespace toile
