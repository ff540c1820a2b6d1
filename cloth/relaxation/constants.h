// Constants of relaxation and release: steps, momentum, intervals, tolerances.
// docs/constants.md shows what half and double of many of them do.
#pragma once

#include "cloth/scene/constants.h"

namespace toile {

// Steps of a relaxation.

/// Factor by which steps exceed what the bound on the stiffness allows, for the bound is
/// pessimistic. With 1, twice the iterations are needed. With 1.5, ten garments on five meshes take
/// 0.93 times as many. But then a sheet without coarser meshes flies apart (max_momentum_step), and
/// jersey trembles on fine meshes.
inline constexpr double step_factor = 1.3;

/// Share of the bound that each coarser level of the nested mesh adds to it; 1 would always be
/// safe. With 0.2, garments of the default fabric come to rest, but those of jersey and denim go on
/// trembling. With 0.4, those of jersey on two coarser meshes do, too.
inline constexpr double level_share = 0.5;

/// Share of the bound that each level of aggregates adds to it. With 0.25 and 0.5, ten garments
/// take 1.1 and 1.2 times the iterations; with 0, about as many.
inline constexpr double aggregate_level_share = 0.1;

/// Largest step with momentum, as a multiple of the inverse of a force's stiffness. With a
/// stiffness λ, steps of s and momentum β, a deviation x follows x'' = (1 - sλ)((1 + β) x' - β x).
/// It stays bounded for sλ < (2 + 2β) / (1 + 2β): 4/3 with β near 1.
inline constexpr double max_momentum_step = 4.0 / 3;

/// Share of the isotropic bound of the stiffness that is added to the blocks of a step, at least
/// and at most. Cloth turns between two updates of the blocks. With the largest share everywhere,
/// six garments at 25 mm take 1.7 times the iterations [measured]. With a least share of 0.003,
/// T-shirts at 10 mm come to rest sooner, and shirts at 5 mm tremble for ever.
inline constexpr double min_isotropic_share = 0.01;
inline constexpr double max_isotropic_share = 0.1;

/// Move of a node in one iteration, in lengths of its shortest edge, from which on it has all of
/// max_isotropic_share. With a third of it, a T-shirt needs half as many iterations again; with
/// three times it, as many.
inline constexpr double turning_glide = 0.01;

/// Factor on the share of a node that slows down, per iteration.
inline constexpr double isotropic_share_decay = 0.95;

/// Factors on the least share of a node that turns back, and of one that goes on. Without the
/// first, single nodes of jersey and of fine shirts tremble for ever.
/// With 0.998 for the second, nine garments at 15 mm take 1.05 times the iterations.
inline constexpr double trembling_growth = 1.5;
inline constexpr double trembling_decay = 0.9995;

/// The same share on the levels of the multilevel preconditioner, whose patches are not flat, as a
/// multiple of the mean of their nodes' shares.
inline constexpr double isotropic_share_of_patches = 2.5;

/// Iterations between two updates of the blocks, at least and at most. With half of both, no
/// garment comes to rest sooner. With twice, they need 1.15 times the iterations.
inline constexpr int min_block_interval = 4;
inline constexpr int max_block_interval = 25;

/// Sine of the angle by which the yarns may turn between two updates of the blocks. Where they turn
/// faster, updates are more frequent. Garments turn by 0.001 to 0.01. With 25 iterations
/// everywhere, a tube 5 % too small, drawn over an ellipse, never finds out of its tangle.
inline constexpr double max_block_turn = 0.02;

/// Levels of aggregates, at most. With none, ten garments take 1.55 times the iterations at 15 mm
/// and 1.4 times at 10 mm. With one and with three, they take 1.06 times, and 1.1 to 1.2 times.
inline constexpr int max_aggregate_levels = 2;

/// Aggregates that a level has at least. A level of fewer is left out.
inline constexpr int min_aggregates = 4;

/// Share of the age of its momentum that a run keeps when it goes uphill. Cloth that trembles in
/// one place must not stop slow cloth elsewhere. With three quarters, ten garments on five meshes
/// take 1.1 times the iterations; with an age for each node, 2 to 5 times.
inline constexpr double kept_momentum_age = 0.9;

/// Force on a node, in median forces, beyond which more of it does not count when momentum is
/// judged. Without that bound, one node that trembles takes the momentum of a whole skirt. Thirteen
/// garments at 15 mm then need 1.12 times the iterations, and one skirt of 21,000 points needs
/// twice as many.
inline constexpr double counted_force = 10;

/// The same in root mean squares of all forces, where that is more. One node that trembles hardly
/// raises it. A patch that swings does, and has to stop the momentum that it swings by. With 0, a
/// T-shirt of jersey swings without end from one of twenty starts, and takes 1.4 times the
/// iterations from the others. With 1, 22 garments at 25 mm take 1.01 times the iterations.
inline constexpr double counted_rms = 0.3;

/// Iterations: a younger momentum is not cut.
inline constexpr int min_momentum_age = 50;

/// Iterations without progress after which seams that have had their time to close count as held
/// apart.
inline constexpr int closing_patience = 500;

/// Iterations at most that seams which have had their time to close are waited for.
inline constexpr int max_closing_wait = 1500;

/// Factor by which what is open of all seams has to shrink to count as progress.
inline constexpr double closing_progress = 0.9;

/// Iterations between two measurements of the residual, and between two calls of the watcher.
inline constexpr int residual_interval = 50;

/// Factor by which the residual has to come nearer to its goal to count as progress.
inline constexpr double stall_progress = 0.98;

/// Factor by which the residual rises when a fold snaps through. The count of iterations without
/// progress then begins at zero. One fold of a silk skirt raised the residual by 25 times
/// [measured].
inline constexpr double snap_through_ratio = 10;

/// Count of stops from which on a bound counts as holding a node. A stop adds 2, a step without one
/// takes 1 off. So a node that is stopped in more than a third of its steps is held. One that is
/// stopped now and then is not.
inline constexpr int held_stops = 16;

/// Metres beyond its offset from the skin within which a held node counts as lying on the body.
inline constexpr double pressed_distance = 0.005;

/// Share of the nodes that bounds may hold at rest, apart from those pressed to the body. Where
/// more are held, cloth is caught in cloth.
inline constexpr double max_held_share = 0.05;

/// Share of the load of a node within which its forces count as balanced. In a tight cuff nodes
/// press on the skin with 30,000 times their weight, and planes stand for the curved skin. With
/// half and twice of it, a shirt with such cuffs takes 1.7 and 0.7 times the iterations to rest
/// [measured on one].
inline constexpr double balanced_share = 1e-4;

/// The same for what a load exceeds `tight_load` by, in mean node weights. Of 18 tight garments at
/// 15 mm one does not rest without it, and all together take 1.09 times as long. No bit of the five
/// garments of dress_table depends on it [measured].
inline constexpr double tight_balanced_share = 2e-3;
inline constexpr double tight_load = 300;

// Contact.

/// Steps between two searches for near cloth, at least. A node that has used up its bound waits so
/// long.
inline constexpr int min_search_interval = 8;

/// Steps between two searches for near cloth, at most, in a run without bounds.
inline constexpr int max_search_interval = 50;

/// Steps between two updates of the attraction to the body, which is wide and smooth.
inline constexpr int attraction_interval = 16;

/// Updates between two attempts to bind triangles that met the body, for they may have come out.
inline constexpr int intersecting_update_interval = 32;

/// Node weights. The approach bound of a node is as long as the step that a force of so many
/// weights drives it onto the body. Without that bound, soft cloth (1 N/m) would be thrown back and
/// come down again for ever.
inline constexpr double approach_weights = 8;

/// Metres: the largest approach bound of a node.
inline constexpr double max_approach_bound = 0.004;

/// Metres: the radius of the tightest curve of a body that a garment spans with whole triangles. It
/// decides which edges touch the body with their middles. It does not set the offset of the nodes.
inline constexpr double edge_contact_radius = 0.02;

/// Share of the offset from the body. An edge whose sagitta over the tightest curve uses more of it
/// touches the body with its middle. It counts by its product with edge_contact_radius alone.
inline constexpr double max_sagitta_share = 0.7;

/// Metres between two places of an edge at which the body holds it off while seams close. The way
/// that a seam has to close has such places, too.
inline constexpr double barrier_spacing = 0.02;

/// Such places of an edge or way, at most.
inline constexpr int max_barrier_parts = 32;

/// Metres from the skin at which the body holds off cloth while seams close.
inline constexpr double barrier_distance = 0.001;

/// Iterations between two steps that draw crossing cloth apart.
inline constexpr int crossing_interval = 2;
/// Metres by which an edge and a face that cross are drawn apart at once.
inline constexpr double crossing_step = 0.002;
/// Metres that a node moves at once at most, of several crossings.
inline constexpr double max_crossing_step = 0.004;
/// Iterations without fewer crossing nodes after which a run that draws them apart gives up.
inline constexpr int crossing_patience = 300;
/// Length of a crossing's way below which it is drawn less far: there both sides pull alike.
inline constexpr double min_crossing_way = 0.3;

// Strain limits.

/// Share of a strain limit by which a relaxation may exceed it at rest. A drape within this
/// tolerance keeps its limits for the judge, too: that allows 10 % (kept_limit).
inline constexpr double limit_tolerance = 0.08;

/// Share of a strain limit above which the step heeds the stiffness beyond the limit.
inline constexpr double limit_stiffening_onset = 0.5;

/// Change of a multiplier at an update, in units of the fabric's stiffness times the strain beyond
/// the limit. With this value a load that only the limit can carry is held at once. Half of it
/// takes twice the iterations. One and a half times does not settle where much is held [measured on
/// five garments].
inline constexpr double multiplier_step = 1 + strain_limit_stiffening;

/// Measurements of the residual at which the multipliers of a garment are updated although its
/// median residual is at its goal, at most. Cloth that no multiplier can hold would never come to
/// rest.
inline constexpr int max_limit_waits = 30;

// Release in time.

/// Share of the longest step at which the integration in time is stable.
inline constexpr double time_step_share = 0.9;

/// Steps ahead of the nodes, along their motion, at which forces are taken.
inline constexpr double force_lookahead = 0.1;

/// Seconds between two measurements of how far the nodes have moved.
inline constexpr double motion_watch_interval = 0.01;

/// Share of its bound after which a node in flight has near cloth searched for, so that no old
/// bound stops it.
inline constexpr double release_search_share = 0.5;

/// Metres within which 99 % of the nodes of a stable garment stay.
inline constexpr double max_stable_motion = 0.002;

}  // namespace toile
