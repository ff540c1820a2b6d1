// The values that Toile's functions take and give: bodies, patterns, garments, drapes.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace toile {
// What callers include. The rooms of Toile have names of their own.
inline namespace library {

using Point = std::array<double, 3>;      ///< metres; y is up
using FlatPoint = std::array<double, 2>;  ///< metres
/// Indices of points, in [0, number of points), counter-clockwise as seen from outside.
using Corners = std::array<int, 3>;

/// A mesh as a file has it, or the points of a scan: in the file's unit and axes.
struct Mesh {
  std::vector<Point> points;
  std::vector<Corners> triangles;  ///< empty: points of a scan
};

/// A body that can be dressed: closed, upright on the floor y = 0, facing +z.
struct Body {
  std::vector<Point> points;
  std::vector<Corners> triangles;
  std::string joints;  ///< JSON, as a file body.body.json has it; empty: they are not known
  std::string report;  ///< JSON, of what made it; empty: it was read
};

/// A flat sewing pattern.
struct SewingPattern {
  std::string json;    ///< as docs/pattern.schema.json states it
  std::string name;    ///< the file, for messages
  std::string report;  ///< JSON, of what made it; empty: it was read
};

/// A pattern as meshed: panels of material points, nothing sewn.
struct Garment {
  std::vector<FlatPoint> flat;     ///< per material point, in its flat panel
  std::vector<Point> placed;       ///< per material point, where its panel stands in space
  std::vector<Corners> triangles;  ///< of material points, counter-clockwise in the flat panels
  std::string json;                ///< panels and seams, as a file garment.garment.json has them
  std::string report;              ///< JSON, of what made it; empty: it was read
};

/// A garment as worn.
struct Drape {
  std::vector<Point> points;       ///< nodes: sewn material points share one
  std::vector<Corners> triangles;  ///< of nodes, one for each of the garment's, in its order
  Garment garment;                 ///< that it is of
  /// Per material point, where the panels started; empty: it is not known.
  std::vector<Point> started;
  std::string report;  ///< JSON, as docs/report.md states it; empty: there is none
};

}  // namespace library
}  // namespace toile
