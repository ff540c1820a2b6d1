// Meshes the panels of a pattern.
#pragma once

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

struct MeshChoices {
  double edge_length = 0.01;  ///< metres, of triangles, positive
  int subdivisions = -1;      ///< 0 to 4 levels of nested meshes; -1: chosen by size
};

/// Checks and meshes a pattern, the sides of its seams point to point. Throws Error, naming panel
/// and edge, for what can't be meshed. The same as mesh-pattern. The cost grows with the triangles.
TOILE_API Garment mesh(const SewingPattern& pattern, const MeshChoices& choices = {});

}  // namespace library
}  // namespace toile
