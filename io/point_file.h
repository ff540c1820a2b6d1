// Reads points of a scan: PLY, OBJ, OFF and STL without regard to faces, and tables of numbers.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/scan/point_cloud.h"
#include "geometry/types.h"

namespace toile {

/// What a file of a body holds. Without polygons it is a scan.
struct BodyFile {
  PolygonSoup soup;
  std::vector<Vec3> normals;  ///< of the points, as PointCloud::normals
};

/// Reads a mesh or points by the path's extension, in small or capital letters. Those of
/// read_mesh() are known, and .xyz, .pts, .asc, .txt and .csv by parse_points(). Normals come from
/// PLY and from tables. A file without points is an Error; otherwise it throws as read_mesh() does.
BodyFile read_body_file(const std::filesystem::path& path);

/// Whether the path's extension is that of a table of points.
bool is_point_table(const std::filesystem::path& path);

/// Reads a table of points: x y z on each line, with spaces, tabs, commas or semicolons between.
/// - A line with one whole number is the count of points that follow, as in PTS. A count that is
///   wrong is an Error.
/// - Further columns are normals if columns 4 to 6, or 7 to 9, have unit length on every line.
///   Others are intensities and colours and are skipped.
/// - Commas are decimal, as in "0,25 1,5 -0,5", if the first line with commas has three such
///   numbers between spaces, tabs or semicolons.
/// - `#` and `//` begin comments. A first line of words is a heading.
/// Throws Error with "name:line" for what is no number, missing, not finite or beyond
/// max_coordinate.
PointCloud parse_points(std::string_view data, const std::string& name);

/// Reads where a file of a scan stands: four rows of four numbers that bring its points, in their
/// unit, to the frame of all. Throws Error, with file and line, for what is no rotation with a
/// translation.
Eigen::Matrix4d read_scan_pose(const std::filesystem::path& path);

}  // namespace toile
