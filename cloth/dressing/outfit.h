// Garments that a body puts on one after another, each judged as it is worn.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cloth/dressing/coupled_layers.h"
#include "cloth/judge/certify.h"
#include "cloth/judge/verdict.h"
#include "cloth/scene/collider.h"
#include "cloth/start/find_places.h"
#include "cloth/start/locate_layout.h"
#include "io/warning.h"

namespace toile {

/// How garments are dressed.
struct OutfitMethod {
  /// Dresses one garment over the layers below; says in `placement.initial` where its panels stood.
  std::function<DressResult(const PanelMesh&, const Scene&, const FrameWatcher&)> dress;
  /// Goes on from an earlier drape of the garment. Empty: the method can't.
  std::function<ContinuedDress(const PanelMesh&, const Scene&, const DressedGarment& earlier,
                               const FrameWatcher&)>
      continue_dress = {};
  /// Relaxes all garments as one, once each is dressed. Empty: the layers stay frozen where they
  /// were dressed.
  std::function<CoupledResult(const std::vector<WornGarment>&, const Scene&, const FrameWatcher&)>
      relax_coupled;
};

/// dress(), with relax_coupled() where the layers are `coupled`. Of coupled layers the whole is
/// released, not each garment.
OutfitMethod relaxation_method(const DressOptions& options, bool coupled);

struct OutfitLayer {
  std::string name;  ///< unique in the outfit
  PanelMesh garment;
  Fabric fabric;  ///< of the panels that name none
  /// By the names of later layers: patterns of the names of this garment's panels that lie over
  /// those, `*` for any letters. Needs a method that relaxes coupled layers.
  std::map<std::string, std::vector<std::string>> panels_over = {};
  AskedPlaces places = {};  ///< of panels, in place of what the pattern says
  /// An earlier drape of the garment, to go on from; none: from flat panels. Where the method can't
  /// go on from it, the garment is dressed from flat panels.
  std::optional<DressedGarment> earlier = {};
};

struct Outfit {
  std::vector<OutfitLayer> layers;             ///< the innermost first
  std::map<std::string, Fabric> fabrics = {};  ///< of panels, by the names that they give
  Vec3 gravity = Scene().gravity;              ///< m/s²
  std::optional<double> strain_limit = {};     ///< see Scene
  std::optional<double> shear_limit = {};      ///< see Scene
  bool has_floor = true;  ///< the body stands on a floor that bears cloth (floor.h)
  const RaisedDistances* raised_distances = nullptr;  ///< see Scene
  const StandingBody* standing = nullptr;             ///< see Scene; of an outfit of one layer
  bool certify = false;  ///< check every state on the way with exact predicates
  OutfitMethod method = relaxation_method({}, false);
};

/// A layer as it is worn.
struct WornLayer {
  PanelMesh garment;                ///< its panels placed where they started
  std::optional<LayoutMove> moved;  ///< of all panels, to where the body is; none: they were there
  std::vector<FoundPlace> places;   ///< of the panels, where they were found; empty: they were not
  std::string place_reason;         ///< why they were found, in words
  /// How it went on from an earlier drape, without its result; none: there was none to go on from.
  std::optional<ContinuedDress> continued;
  Scene scene;  ///< fabrics and options; without its collider, which layers have joined since
  DressResult result;
  Judgement judgement;
  std::vector<Warning> warnings;           ///< of panels placed wrongly and fabrics too stiff
  std::optional<Certificate> certificate;  ///< for its frames: the body it checked may be gone
  TriangleMesh cloth;                      ///< as it was judged
  std::size_t distances_computed = 0;      ///< of the collider, for this layer
  double collider_seconds = 0;             ///< to join the layer below to the collider
  double dress_seconds = 0;
  double judge_seconds = 0;
};

struct WornOutfit {
  /// Those that were dressed. None is dressed over a layer that is open or intersects something.
  std::vector<WornLayer> layers;
  std::optional<CoupledResult> coupled;  ///< none: not asked for, or a layer failed
  std::optional<Certificate> coupled_certificate;

  /// Of the first layer that is not sewn; else sewn.
  Verdict verdict() const;
};

/// What the caller does while an outfit is dressed; each may be empty. `layer` is an index, and the
/// number of layers stands for all of them coupled.
struct OutfitHooks {
  std::function<void(std::size_t layer)> begin;
  /// Who watches this dressing; the watcher lives until the dressing ends.
  std::function<FrameWatcher(std::size_t layer)> watch;
  std::function<void(const Warning&)> warn;
  /// The layer has come to rest, and is neither written nor judged.
  std::function<void(std::size_t layer, const WornLayer&)> dressed;
  /// Writes the garment and reads it back, so that the judge sees what others will read. It may be
  /// called again for a layer that has moved since.
  std::function<DressedGarment(std::size_t layer, const DressedGarment&)> write;
  /// The layer is judged: over the layers below, and again once all have moved coupled.
  std::function<void(std::size_t layer, const WornLayer&)> judged;
};

/// Dresses the layers one after another. A garment whose layout is not where the body is is moved
/// there as one piece (locate_layout.h). Panels without places, or whose places do not fit the
/// body, get them from the seams (find_places.h). What encloses a layer is dressed over it as over
/// a part of the body. Panels that lie over a later layer are left out while that one is dressed,
/// then turned out over it. `collider` is that of the bare body; the layers join it. `skeleton` may
/// be null: then panels start where the pattern puts them, and wraps are not measured. Throws Error
/// for fabrics or panels that are named and missing, for places that can't be found, and as the
/// method does.
WornOutfit dress_outfit(const Outfit& outfit, Collider& collider, const Skeleton* skeleton,
                        const OutfitHooks& hooks = {});

}  // namespace toile
