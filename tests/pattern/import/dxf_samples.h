// DXF files for tests, written group by group.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile::samples {

inline std::string group(int code, const std::string& value) {
  return std::to_string(code) + "\n" + value + "\n";
}
inline std::string group(int code, double value) { return group(code, std::to_string(value)); }

inline std::string dxf_polyline(const std::string& layer, const std::vector<Vec2>& points,
                                bool closed = true) {
  std::string text = group(0, "LWPOLYLINE") + group(8, layer) + group(70, closed ? "1" : "0");
  for (const Vec2& point : points) text += group(10, point.x()) + group(20, point.y());
  return text;
}

inline std::string dxf_segment(const std::string& layer, const Vec2& from, const Vec2& to) {
  return group(0, "LINE") + group(8, layer) + group(10, from.x()) + group(20, from.y()) +
         group(11, to.x()) + group(21, to.y());
}

inline std::string dxf_point(const std::string& layer, const Vec2& at,
                             const std::string& more = "") {
  return group(0, "POINT") + group(8, layer) + group(10, at.x()) + group(20, at.y()) + more;
}

inline std::string dxf_label(const std::string& text, const Vec2& at = Vec2::Zero()) {
  return group(0, "TEXT") + group(8, "1") + group(10, at.x()) + group(20, at.y()) + group(1, text);
}

inline std::string dxf_insert(const std::string& block, const Vec2& at,
                              const std::string& more = "") {
  return group(0, "INSERT") + group(8, "1") + group(2, block) + group(10, at.x()) +
         group(20, at.y()) + more;
}

inline std::string dxf_block(const std::string& name, const std::string& entities) {
  return group(0, "BLOCK") + group(8, "0") + group(2, name) + group(10, 0) + group(20, 0) +
         entities + group(0, "ENDBLK");
}

/// A file in millimetres, unless `header` says otherwise.
inline std::string dxf_file(const std::string& blocks, const std::string& entities,
                            const std::string& header = "9\n$INSUNITS\n70\n4\n") {
  return group(0, "SECTION") + group(2, "HEADER") + header + group(0, "ENDSEC") +
         group(0, "SECTION") + group(2, "BLOCKS") + blocks + group(0, "ENDSEC") +
         group(0, "SECTION") + group(2, "ENTITIES") + entities + group(0, "ENDSEC") +
         group(0, "EOF");
}

inline std::vector<Vec2> rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

}  // namespace toile::samples
