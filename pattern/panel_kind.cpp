#include "pattern/panel_kind.h"

#include <string_view>
#include <utility>

#include "pattern/panel_name.h"

namespace toile {

PanelKind kind_by_name(const std::string& name) {
  const PanelName read = read_panel_name(name);
  constexpr std::pair<PanelRole, PanelKind> kinds[] = {
      {PanelRole::trousers, PanelKind::trousers}, {PanelRole::sleeve, PanelKind::sleeve},
      {PanelRole::cuff, PanelKind::sleeve},       {PanelRole::skirt, PanelKind::skirt},
      {PanelRole::waistband, PanelKind::band},    {PanelRole::bodice, PanelKind::top},
      {PanelRole::yoke, PanelKind::top},          {PanelRole::collar, PanelKind::top},
      {PanelRole::hood, PanelKind::top},
  };
  for (const auto& [role, kind] : kinds) {
    if (read.says(role)) return kind;
  }
  return PanelKind::unknown;
}

PanelKind kind_of(const MeshedPanel& panel) {
  const PanelKind by_name = kind_by_name(panel.name);
  if (panel.part.ends_with("_arm") || panel.label == "arm") return PanelKind::sleeve;
  if (panel.part.ends_with("_leg")) return PanelKind::trousers;
  if (panel.part == "head" && by_name == PanelKind::unknown) return PanelKind::top;
  if (panel.label == "leg") {
    return by_name == PanelKind::trousers ? PanelKind::trousers : PanelKind::skirt;
  }
  if (panel.label == "body") return by_name == PanelKind::band ? by_name : PanelKind::top;
  return by_name;
}

bool names_hood(const std::string& name) { return read_panel_name(name).says(PanelRole::hood); }

bool names_headwear(const std::string& name) {
  const PanelName read = read_panel_name(name);
  return read.says(PanelRole::hood) || read.says(PanelRole::collar);
}

int side_by_name(const std::string& name) { return read_panel_name(name).side; }

int face_by_name(const std::string& name) { return read_panel_name(name).face; }

namespace {

/// Whether a piece may be of a part, the side left out. Trousers have panels at the trunk, too.
/// Collars and hoods have them at head and trunk.
bool may_be_of(PanelKind kind, std::string_view part) {
  const bool is_arm = part.ends_with("_arm");
  const bool is_leg = part.ends_with("_leg");
  switch (kind) {
    case PanelKind::sleeve:
      return is_arm;
    case PanelKind::trousers:
      return is_leg || part == "torso";
    case PanelKind::skirt:
    case PanelKind::band:
      return part == "torso";
    case PanelKind::top:
      return !is_leg && !is_arm;
    case PanelKind::unknown:
      break;
  }
  return true;
}

std::string_view word_of(PanelKind kind) {
  switch (kind) {
    case PanelKind::sleeve:
      return "a sleeve";
    case PanelKind::trousers:
      return "trousers";
    case PanelKind::skirt:
      return "a skirt";
    case PanelKind::band:
      return "a waistband";
    case PanelKind::top:
      return "a top";
    case PanelKind::unknown:
      break;
  }
  return "";
}

}  // namespace

std::string against_part(const MeshedPanel& panel) {
  if (panel.part.empty() || panel.part_source != PartSource::stated) return "";
  const std::string& part = panel.part;
  const bool is_limb = part.ends_with("_arm") || part.ends_with("_leg");
  if (!panel.label.empty()) {
    const bool agrees = panel.label == "arm"   ? part.ends_with("_arm")
                        : panel.label == "leg" ? part.ends_with("_leg") || part == "torso"
                                               : !is_limb;
    if (!agrees) return "its label is '" + panel.label + "'";
  }
  const PanelKind kind = kind_by_name(panel.name);
  if (!may_be_of(kind, part)) return "its name says " + std::string(word_of(kind));
  const int side = side_by_name(panel.name);
  const bool is_other_side = side > 0 ? part.starts_with("right") : part.starts_with("left");
  if (side != 0 && is_limb && is_other_side) {
    return std::string("its name says ") + (side > 0 ? "left" : "right");
  }
  return "";
}

}  // namespace toile
