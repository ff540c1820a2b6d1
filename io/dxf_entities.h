// One entity of DXF as curves.
#pragma once

#include <vector>

#include "io/dxf.h"
#include "io/dxf_curves.h"
#include "io/dxf_groups.h"

namespace toile {

/// A corner of a polyline. `bulge` is of the side that begins here, see append_dxf_bulge().
struct DxfVertex {
  Vec2 at = Vec2::Zero();
  double bulge = 0;
  int flags = 0;
};

// `file` reads the numbers of `record`. What is no such entity throws Error with its line.

/// Of a VERTEX.
DxfVertex dxf_vertex(const DxfGroups& file, const DxfRecord& record);

/// Appends the sides of a polyline, the closing one too where it is `closed`.
void append_dxf_sides(std::vector<DxfCurve>& curves, const std::vector<DxfVertex>& vertices,
                      bool closed);

/// Of an LWPOLYLINE.
std::vector<DxfCurve> dxf_lightweight_polyline(const DxfGroups& file, const DxfRecord& record);

/// Of a LINE.
DxfCurve dxf_line(const DxfGroups& file, const DxfRecord& record);

/// Sets place and curves of an ARC or a CIRCLE.
void read_dxf_arc(const DxfGroups& file, const DxfRecord& record, DxfEntity& entity);

/// Sets place and curves of an ELLIPSE, which may be seen from `behind`.
void read_dxf_ellipse(const DxfGroups& file, const DxfRecord& record, bool behind,
                      DxfEntity& entity);

/// Of a SPLINE: one without a problem.
DxfSpline dxf_spline(const DxfGroups& file, const DxfRecord& record);

}  // namespace toile
