// Wavefront OBJ files: positions, texture coordinates, groups, faces and lines.
#pragma once

#include <array>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/limits.h"
#include "io/output_file.h"

namespace toile {

/// One corner of a face.
struct ObjCorner {
  int point = 0;     ///< index into ObjData::points
  int texture = -1;  ///< index into ObjData::texture; -1: none
};

struct ObjFace {
  std::vector<ObjCorner> corners;  ///< three or more
  int group = -1;                  ///< index into ObjData::groups; -1: none
};

/// The content of an OBJ file. Indices count from 0 here, and from 1 in the file.
struct ObjData {
  std::vector<std::string> comments;  ///< `#` lines, written at the top of the file, not read
  std::vector<Vec3> points;           ///< v
  std::vector<Vec2> texture;          ///< vt
  std::vector<Vec3> normals;          ///< vn, one a point or none; written, not read
  std::vector<std::string> groups;    ///< g (or o), in the order of first use
  /// usemtl, one a group or none; written, not read. With it a group is written as an object (o).
  std::vector<std::string> materials;
  std::vector<ObjFace> faces;             ///< f
  std::vector<std::array<int, 2>> lines;  ///< l a b; longer lines are cut into pairs
};

/// Reads an OBJ file or text. It throws Error with "file:line" for malformed or non-finite numbers,
/// indices out of range, and faces of fewer than three corners or more than max_face_corners. Text
/// without any OBJ statement is an Error, too. So is a coordinate beyond `max`, which is max_metres
/// for a file in metres. Statements that Toile does not use (vn, usemtl, s, ...) are skipped.
ObjData read_obj(const std::filesystem::path& path, double max = max_coordinate);
ObjData parse_obj(const std::string& text, const std::string& name, double max = max_coordinate);

/// The text of an OBJ file. Doubles have the fewest digits that read back to the same bits, normals
/// six decimal places.
std::string format_obj(const ObjData& data);
/// Writes it, whole or not at all. Throws Error as OutputFile does.
void write_obj(const OutputPath& path, const ObjData& data);

}  // namespace toile
