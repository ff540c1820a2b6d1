#include "pattern/import/dxf_layers.h"

#include <algorithm>
#include <limits>

namespace toile {

int layer_number(const DxfEntity& entity) {
  const std::string& name = entity.layer;
  if (name.empty() || name.size() > 3) return any_layer;
  int number = 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return any_layer;
    number = number * 10 + (c - '0');
  }
  return number;
}

bool is_notch_layer(int layer) { return layer == 4 || (layer >= 80 && layer <= 83); }

std::string unused_layer(int layer) {
  switch (layer) {
    case 3:
      return "curve points (layer 3)";
    case 5:
      return "grade reference lines (layer 5)";
    case 9:
      return "stripe lines (layer 9)";
    case 10:
      return "plaid lines (layer 10)";
    case 15:
      return "annotations (layer 15)";
    default:
      return layer >= 84 && layer <= 87 ? "curves to check by (layer " + std::to_string(layer) + ")"
                                        : "";
  }
}

bool has_layers(const DxfDrawing& drawing) {
  const auto layered = [](const std::vector<DxfEntity>& list) {
    return std::any_of(list.begin(), list.end(),
                       [](const DxfEntity& entity) { return is_outline(entity, true); });
  };
  return layered(drawing.entities) ||
         std::any_of(drawing.blocks.begin(), drawing.blocks.end(),
                     [&](const DxfBlock& block) { return layered(block.entities); });
}

bool is_outline(const DxfEntity& entity, bool layered) {
  if (entity.kind != DxfEntity::Kind::curves) return false;
  const int layer = layer_number(entity);
  return !layered || layer == boundary_layer || layer == sew_layer;
}

PiecePath dxf_path(const DxfEntity& entity, double unit) {
  PiecePath path;
  for (const DxfCurve& curve : entity.curves) {
    const auto& p = curve.points;
    path.push_back(curve.straight
                       ? EdgeCurve::line(p[0] * unit, p[3] * unit)
                       : EdgeCurve::cubic(p[0] * unit, p[1] * unit, p[2] * unit, p[3] * unit));
  }
  return path;
}

double outline_size(const std::vector<DxfEntity>& entities, bool layered) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = Vec2::Constant(std::numeric_limits<double>::lowest());
  for (const DxfEntity& entity : entities) {
    if (!is_outline(entity, layered)) continue;
    for (const DxfCurve& curve : entity.curves) {
      for (const Vec2& point : {curve.points[0], curve.points[3]}) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    }
  }
  return low.x() > high.x() ? 0 : (high - low).maxCoeff();
}

}  // namespace toile
