// What each panel is, decided once: by what its pattern says, its seams and its shape.
#pragma once

#include <string>
#include <vector>

#include "pattern/classify/panel_class.h"
#include "pattern/panel_mesh.h"

namespace toile {

struct PatternPanel;

/// What a pattern says of a panel.
struct PanelWitnesses {
  std::string name;
  BodyPart part = BodyPart::none;  ///< as its placement states it
  std::string label = {};          ///< GarmentCode's: "body", "arm", "leg" or another; may be empty
};

PanelWitnesses witnesses_of(const PatternPanel& panel);

/// What the witnesses say of a panel. Where they agree, the first of stated part, label and name
/// that tells is the source. Where they contradict each other, and nothing else is known, it is
/// believed; of two sides the name's is. A name of one or two letters says no side or face: panels
/// may be named a to f.
PanelClass classify(const PanelWitnesses& told);

/// Sets what the panels of `garment` are; `told` has one entry for each. Contradictions are decided
/// in this order:
///
/// - by shape: a panel is what others are that are its like or its mirror image;
/// - by seams: two panels that two seams join into a tube are worn as the same, and a sleeve is not
///   sewn to trousers (may_meet());
/// - a limb's side by what the panel is sewn to: panels of a side, or one half of a front or back;
/// - else as without seams.
///
/// A panel that has the place of a part that it is not for loses its placement, and
/// `garment.has_places` is false then. The seams alone tell what goes around. Cost: linear in the
/// triangles, times the panels that contradict themselves.
void classify(PanelMesh& garment, const std::vector<PanelWitnesses>& told);

/// Whether two pieces are sewn to each other in some garment.
bool may_meet(PanelRole a, PanelRole b);

/// Whether a seam, or several together, join two edges of the panel that lie across from each
/// other. A dart's do not. `panel` is an index into garment.panels. Linear.
bool closes_around(const PanelMesh& garment, int panel);

}  // namespace toile
