// Reads drawings in DXF, the exchange format of CAD programs.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A piece of a drawn curve: a cubic Bezier curve, in the drawing's unit, y up.
struct DxfCurve {
  std::array<Vec2, 4> points;
  bool straight = false;  ///< a line: the inner points lie on it
};

/// One thing that is drawn.
struct DxfEntity {
  enum class Kind { curves, point, text, insert };
  Kind kind = Kind::curves;
  std::string type;   ///< as in the file: "LWPOLYLINE"
  std::string layer;  ///< UTF-8, without blanks around it
  /// Curves that follow each other. The last ends where the first starts where it was drawn closed.
  std::vector<DxfCurve> curves;
  Vec2 at = Vec2::Zero();  ///< a point, the start of a text, the centre of a circle
  double angle = 0;        ///< of a point or text: radians counter-clockwise from +x
  bool has_angle = false;  ///< whether the file states it
  std::string text;        ///< UTF-8, without format codes; paragraphs are lines
  int block = 0;           ///< of an insert: index into DxfDrawing::blocks
  /// Of an insert: from the block's drawing to the drawing that it stands in.
  Eigen::Affine2d placed = Eigen::Affine2d::Identity();
  int line = 0;  ///< of the file, from 1
};

/// Entities that are drawn as one wherever the block is inserted.
struct DxfBlock {
  std::string name;
  std::vector<DxfEntity> entities;
  int line = 0;  ///< of the file, from 1
};

/// Whether the header says which system of units the drawing is in ($MEASUREMENT).
enum class DxfMeasurement { not_stated, english, metric };

/// What a DXF file holds of two dimensions.
struct DxfDrawing {
  std::string version;     ///< $ACADVER: "AC1009" is R12; empty: not stated
  double unit_metres = 0;  ///< $INSUNITS; 0: not stated
  DxfMeasurement measurement = DxfMeasurement::not_stated;
  std::vector<DxfBlock> blocks;     ///< without those of model space and paper space
  std::vector<DxfEntity> entities;  ///< of model space
  /// Entities that were not read: the name of their kind, and how many there were.
  std::map<std::string, int> ignored;
};

/// Bytes of a file, entities and curves of a drawing at most. A pattern in ten sizes has some
/// thousand entities.
inline constexpr std::size_t max_dxf_bytes = 256u << 20;
inline constexpr int max_dxf_entities = 300'000;
inline constexpr int max_dxf_curves = 2'000'000;

/// Whether a text is a DXF file by its beginning, in text or in binary form.
bool looks_like_dxf(std::string_view text);

/// Reads a DXF file in text form, of R12 to 2018. `name` stands for the file in messages.
///
/// - LINE, POLYLINE and LWPOLYLINE with bulges, ARC, CIRCLE, ELLIPSE and SPLINE become curves. Arcs
///   are within 1e-7 of their radius. POINT, TEXT, MTEXT, ATTRIB, ATTDEF and INSERT are read, too.
///   An insert in rows and columns is one insert for each of them.
/// - Texts are in UTF-8 from version 2007 on, or wherever all of the file is UTF-8. Otherwise
///   $DWGCODEPAGE says the encoding.
/// - Several blocks may have one name, as some pattern programs write. Their inserts take them in
///   turn. Inserts of a block that is not there are ignored.
/// - Paper space, solids, dimensions, hatches and what is tilted out of the plane are ignored.
///
/// Throws Error with the place "name:line" for what is no DXF, for a file that ends early, for a
/// number that is none, and beyond the bounds above. Throws it for binary DXF and for DWG.
///
/// It is our own because Debian's libdime of 2011 crashes on files that are cut off, and says of a
/// damaged file no more than that it can't be read.
DxfDrawing parse_dxf(std::string_view text, const std::string& name);

/// The entity as it stands where `placed` puts its drawing.
DxfEntity transformed(const DxfEntity& entity, const Eigen::Affine2d& placed);

}  // namespace toile
