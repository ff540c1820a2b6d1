#include "pattern/panel_kind.h"

#include <utility>

#include "pattern/panel_name.h"

namespace toile {

namespace {

/// A cuff of trousers is of trousers, and a skirt's band is of the skirt.
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

}  // namespace

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

}  // namespace toile
