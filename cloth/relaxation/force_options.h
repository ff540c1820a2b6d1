// What acts on a garment, by all that moves it.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "cloth/contact/friction_state.h"
#include "cloth/model/stretch.h"
#include "geometry/types.h"

namespace toile {

/// Where friction holds a garment, and what holds its yarns to their limits: what one run hands to
/// the next, so that the force is not lost.
struct WarmStart {
  std::vector<std::optional<Vec3>> skin;  ///< per node; nothing: it does not
  std::vector<EdgeAnchor> edges;          ///< of nodes, sorted: their middles on the skin
  std::vector<PairAnchor> cloth;          ///< where it rubs on cloth, of nodes and then of layers
  std::vector<LimitMultiplier> multipliers;  ///< per triangle; empty: no limits

  /// Friction lets go of the nodes for which `moved` is not 0.
  void release_anchors(const std::vector<char>& moved) {
    for (std::size_t n = 0; n < std::min(moved.size(), skin.size()); ++n) {
      if (moved[n] != 0) skin[n].reset();
    }
    const auto any_moved = [&](const auto& vertices) {
      return std::any_of(vertices.begin(), vertices.end(), [&](int v) {
        return static_cast<std::size_t>(v) < moved.size() && moved[v] != 0;
      });
    };
    std::erase_if(edges, [&](const EdgeAnchor& anchor) { return any_moved(anchor.edge); });
    std::erase_if(cloth, [&](const PairAnchor& anchor) { return any_moved(anchor.vertices); });
  }
};

struct ForceOptions {
  double gravity = 1;  ///< factor on the scene's
  /// Share of the stiffness that resists compression. Real cloth buckles in folds finer than a
  /// coarse mesh has; a mesh that can't is held up by its own creases unless compression is cheap
  /// [tension-field theory: Pipkin 1986].
  double compression = 1;
  /// Pull toward the skin, as a multiple of the cloth's weight far from it, falling to nothing at
  /// the skin [Zhong & Xu 2009, wrapping]. Without it, the middle of a wide
  /// panel stays where it was while its seams close, and folds into one sharp ridge.
  double pull = 0;
  bool friction = true;  ///< off, a garment can find its way down
  /// Keeps every node within its bound of the last search, so that what is apart stays apart.
  /// To be used from a state without intersections; a tangle would be locked in.
  /// With BodyContactTerm::faces and seams closed, no triangle that is clear of the body comes to
  /// meet it; what meets it can come out.
  bool bounded = false;
  /// Keeps the cloth apart from the scene's layers too, each vertex, edge and face of either from
  /// the other's, within the bounds. To be used from a state that does not meet them.
  bool layer_contact = false;
  /// Metres along which the body passes for a plane: curved with a radius of 2 cm, it leaves one by
  /// 6e-9 m, a force of 6e-6 N on a vertex that touches it. More is faster where nothing has to
  /// come to rest.
  double linearization_radius = 1.5e-5;
  double self_radius = 0.005;  ///< metres within which cloth is looked for
  /// Metres before cloth touches cloth at which the step reckons with the stiffness of the touch: a
  /// longer step would be thrown back, for ever. release() takes 0.
  double activation_distance = 1e-4;
  /// Share of its bound beyond which a node has near cloth looked for anew. 1: when it is stopped;
  /// with less, what moves freely never is, for more searches.
  double search_share = 1;
  /// Of a run that ended where this one begins, seams closed. None: friction holds what
  /// touches where it comes to touch.
  const WarmStart* warm_start = nullptr;
  /// Begins with these multipliers, likewise. None: they are found from nothing.
  const std::vector<LimitMultiplier>* multipliers = nullptr;
};

}  // namespace toile
