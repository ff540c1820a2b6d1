// Programs with nodes that are held, for which the solver has no term.
#pragma once

#include <functional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/springs/spring_sheet.h"

namespace toile::test {

/// N/m: no force moves what is stiff beyond all others.
inline constexpr double held_stiffness = 1e30;

/// Holds the nodes that start at a place which is `held`, and takes their weight. Returns how many.
inline int hold_nodes(GarmentModel& model, const std::function<bool(const Vec3&)>& held) {
  int count = 0;
  for (int n = 0; n < model.nodes; ++n) {
    if (!held(model.start[n])) continue;
    model.stretch_diagonal[n] = held_stiffness;
    model.mass[n] = 0;
    ++count;
  }
  return count;
}

/// The sheet by the paper's masses and springs; what is held has no mass.
struct HeldSprings {
  HeldSprings(const SpringSheet& sheet, const GarmentModel& model)
      : springs(sheet.edges()), mass(sheet.mass()) {
    springs.insert(springs.end(), sheet.bending().begin(), sheet.bending().end());
    for (int n = 0; n < model.nodes; ++n) {
      if (model.stretch_diagonal[n] == held_stiffness) mass[n] = 0;
    }
  }

  std::vector<Spring> springs;
  std::vector<double> mass;
};

}  // namespace toile::test
