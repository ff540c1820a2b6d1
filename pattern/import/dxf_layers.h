// The layers of AAMA and ASTM D6673, and what DXF entities on them are.
#pragma once

#include <string>
#include <vector>

#include "io/dxf.h"
#include "pattern/import/piece.h"

namespace toile {

inline constexpr int boundary_layer = 1;
inline constexpr int turn_layer = 2;
inline constexpr int mirror_layer = 6;
inline constexpr int grain_layer = 7;
inline constexpr int internal_layer = 8;
inline constexpr int cut_out_layer = 11;
inline constexpr int drill_layer = 13;
inline constexpr int sew_layer = 14;
inline constexpr int any_layer = -1;

/// The number that names the entity's layer; any_layer: it has another name.
int layer_number(const DxfEntity& entity);

/// Whether notches are on the layer: 4, and 80 to 83 for their kinds.
bool is_notch_layer(int layer);

/// The name of a layer of ASTM D6673 that no piece is made of; empty: it is not one of those.
std::string unused_layer(int layer);

/// Whether anything is drawn on the layers of boundaries or sew lines. Without them, an outline may
/// be on any layer.
bool has_layers(const DxfDrawing& drawing);

/// Whether the entity bounds a piece, in a drawing with or without layers.
bool is_outline(const DxfEntity& entity, bool layered);

/// The entity's curves in metres. `unit` is metres.
PiecePath dxf_path(const DxfEntity& entity, double unit);

/// The longer side of the box around the outlines among the entities. In the drawing's unit; 0:
/// there is none.
double outline_size(const std::vector<DxfEntity>& entities, bool layered);

}  // namespace toile
