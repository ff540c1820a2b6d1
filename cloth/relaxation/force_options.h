// Options of the forces on a garment, common to relaxation and release.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "cloth/contact/friction_state.h"
#include "cloth/model/stretch.h"
#include "geometry/types.h"

namespace toile {

/// Anchors of friction and multipliers of the limits at the end of a run. A run that begins with
/// them begins with the forces that they hold.
struct WarmStart {
  std::vector<std::optional<Vec3>> skin_anchors;  ///< metres, per node; none: it slides
  std::vector<EdgeAnchor> edge_anchors;           ///< middles on the skin, of nodes, sorted
  /// On cloth, of nodes and then of layers' points, sorted.
  std::vector<PairAnchor> pair_anchors;
  std::vector<LimitMultiplier> multipliers;  ///< per triangle; empty: they begin at 0

  /// Forgets what friction held; the multipliers stay.
  void drop_anchors() {
    skin_anchors.clear();
    edge_anchors.clear();
    pair_anchors.clear();
  }

  /// Drops the anchors of nodes for which `moved` is not 0. `moved`: one a node.
  void release_anchors(const std::vector<char>& moved) {
    for (std::size_t n = 0; n < std::min(moved.size(), skin_anchors.size()); ++n) {
      if (moved[n] != 0) skin_anchors[n].reset();
    }
    const auto any_moved = [&](const auto& vertices) {
      return std::any_of(vertices.begin(), vertices.end(), [&](int v) {
        return static_cast<std::size_t>(v) < moved.size() && moved[v] != 0;
      });
    };
    std::erase_if(edge_anchors, [&](const EdgeAnchor& anchor) { return any_moved(anchor.edge); });
    std::erase_if(pair_anchors,
                  [&](const PairAnchor& anchor) { return any_moved(anchor.vertices); });
  }
};

struct ForceOptions {
  double gravity = 1;  ///< factor on the scene's gravity
  /// Share of the stiffness that resists compression. Real cloth buckles in folds finer than a
  /// coarse mesh can form. Unless compression is cheap, such a mesh is held up by its own creases
  /// [tension-field theory: Pipkin 1986].
  double compression = 1;
  /// Attraction to the skin, as a multiple of the cloth's weight; it falls to 0 at the skin [Zhong
  /// & Xu 2009, wrapping]. Without it, the middle of a wide panel stays where it was while its
  /// seams close, and folds into one sharp ridge.
  double body_attraction = 0;
  bool friction = true;  ///< without it, a garment can slide down into place
  /// Keeps every node within its bound of the last search, so that surfaces that are apart stay
  /// apart. The run must begin without intersections: a tangle would be locked in.
  ///
  /// With BodyContactTerm::faces and closed seams, no triangle that is clear of the body comes to
  /// meet it. A triangle that meets it can come out.
  bool bounded = false;
  /// Keeps triangles off the body as `bounded` does, where cloth may pass through cloth, and where
  /// seams stand open.
  bool bounded_by_body = false;
  /// Moves cloth out of the body at once wherever it comes into it (BodyBarrier), for seams that
  /// close pull it through any push.
  bool barrier = false;
  /// Draws cloth that has come through cloth back out of it (edge_face_intersections.h).
  bool untangles = false;
  /// Keeps vertices, edges and faces of the cloth apart from those of the scene's layers, too, and
  /// within bounds of them. The run must begin without intersections with the layers.
  bool layer_contact = false;
  /// Metres within which a plane stands for the body. A body with a radius of curvature of 2 cm is
  /// 6e-9 m off that plane. On a vertex in contact that is a force of 6e-6 N. More is faster where
  /// nothing has to come to rest.
  double linearization_radius = 1.5e-5;
  /// Whether the body's push is firm where cloth is pressed deep. While arms come down into a long
  /// sleeve, a firm push drives it through the fingers.
  bool firm_push = true;
  double self_radius = 0.005;  ///< metres within which near cloth is searched for
  /// Metres before two sides of cloth push each other, from which on the step heeds the stiffness
  /// of the push. A longer step would be thrown back again and again. release() takes 0.
  double activation_distance = 1e-4;
  /// Share of its bound after which a node has near cloth searched for. With 1, it has when it is
  /// stopped. With less, nodes that move freely are never stopped, at the cost of more searches.
  double search_share = 1;
  /// The end of an earlier run. Its anchors are of the same positions, with closed seams; without
  /// them, and where seams are open, friction holds the cloth where it first touches. Null: all
  /// begins anew.
  const WarmStart* warm_start = nullptr;
};

}  // namespace toile
