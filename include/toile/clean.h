// Makes a mesh or scan of a person a body that can be dressed, or makes a mannequin.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

/// What is known of a mesh or scan.
struct CleanChoices {
  std::optional<double> metres_per_unit = {};  ///< none: found by the body's height
  std::optional<double> height = {};           ///< metres; none: by the unit
  std::string up = {};     ///< "x", "-x", "y", "-y", "z" or "-z" of the file; empty: found
  std::string front = {};  ///< likewise, to where it faces; empty: found
  bool as_points = false;  ///< take the points as a scan, and ignore triangles
  std::optional<double> edge_length = {};  ///< metres, 0.003 to 0.02, of a scan's surface
};

/// Cleans a mesh or scan: closed, in metres, upright on the floor, facing +z, with joints. Throws
/// Error for what can't be closed. The same as clean-body; seconds for a scan.
TOILE_API Body clean(const Mesh& mesh, const CleanChoices& choices = {});
/// The same of files, which may have polygons and normals. Several are one scan.
TOILE_API Body clean(const std::vector<std::filesystem::path>& files,
                     const CleanChoices& choices = {});

/// The sample mannequin, or one that has the `measures`: height, bust, hip and more, in
/// centimetres. `make-mannequin --help` lists their names. `figure`: woman, man or child; empty:
/// told by the measures. Throws Error for measures that contradict, and for too few. Seconds with
/// measures.
TOILE_API Body mannequin(const std::map<std::string, double>& measures = {},
                         const std::string& figure = {});

}  // namespace library
}  // namespace toile
