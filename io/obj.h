// Wavefront OBJ as Toile reads and writes it: positions, texture coordinates, groups, faces, lines.
#pragma once

#include <array>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// One corner of a face: indices into ObjData::points and ObjData::texture (-1: none).
struct ObjCorner {
  int point = 0;
  int texture = -1;
};

struct ObjFace {
  std::vector<ObjCorner> corners;  ///< three or more
  int group = -1;                  ///< index into ObjData::groups, -1: none
};

/// All indices count from 0 here, whatever the file counts from.
struct ObjData {
  std::vector<std::string> comments;      ///< `#` lines put at the top when written; not read
  std::vector<Vec3> points;               ///< v
  std::vector<Vec2> texture;              ///< vt
  std::vector<std::string> groups;        ///< g (or o), in the order of first use
  std::vector<ObjFace> faces;             ///< f
  std::vector<std::array<int, 2>> lines;  ///< l a b, longer lines cut into pairs
};

/// Throws Error with "file:line" for malformed or non-finite numbers, indices out of range, faces
/// of fewer than three corners, and files that hold no OBJ statement at all. Statements that Toile
/// has no use for (vn, usemtl, s, ...) are passed over.
ObjData read_obj(const std::filesystem::path& path);
ObjData parse_obj(const std::string& text, const std::string& name);

/// Doubles are written with the fewest digits that read back to the same bits.
void write_obj(const std::filesystem::path& path, const ObjData& data);

}  // namespace toile
