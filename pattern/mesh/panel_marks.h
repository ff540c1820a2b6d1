// Puts points of a panel's mesh on what is drawn within the outline: internal lines and drill
// holes.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_polygon.h"
#include "geometry/types.h"

namespace toile {

/// What is drawn within a panel. Flat coordinates, metres.
struct DrawnMarks {
  std::vector<std::vector<Vec2>> lines;
  std::vector<Vec2> holes;    ///< drill holes
  std::vector<Vec2> outline;  ///< a polygon; what of a line lies outside is left out
};

/// A mark as mesh points: one for a drill hole. Those of a line run from its start to its end, each
/// joined to the next by an edge. A line that leaves the outline has several marks.
struct PointedMark {
  bool is_line = false;
  int index = 0;  ///< into DrawnMarks::lines or holes
  std::vector<int> points;
};

struct PointedMarks {
  std::vector<PointedMark> marks;  ///< holes first, then lines, each in order
  std::vector<int> lost_lines;     ///< of which some part is in no edges of the mesh; in order
  std::vector<int> lost_holes;
};

/// Moves inner points of `mesh` onto the marks; points that are `border`, one flag a point, stay.
/// The triangles keep their corners. Corners of lines and places where lines cross become points.
/// A line that reaches the border ends at the border's nearest point. Edges are about `edge_length`
/// metres long.
///
/// A mark is lost where it is nearer to the border or to another than triangles allow. Then points
/// stay as if it were not there. O(n log n), and the number of segments of lines times that of the
/// outline.
PointedMarks put_marks_on_mesh(PlanarMesh& mesh, const std::vector<bool>& border,
                               const DrawnMarks& drawn, double edge_length);

}  // namespace toile
