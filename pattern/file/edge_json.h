// The entries of a panel's `edges`, as docs/pattern.schema.json states them.
#pragma once

#include <string>
#include <vector>

#include "io/json_value.h"
#include "pattern/pattern.h"

namespace toile {

/// How a file states the points of a panel's drawing.
struct DrawingFrame {
  double unit = 0.01;          ///< metres
  Vec2 origin = Vec2::Zero();  ///< metres: what is taken off every point
  /// Whether control points are in the drawing. Otherwise they are in the frame of their edge. That
  /// frame has the start at 0, the end at (1, 0) and y to its left.
  bool absolute_controls = false;
};

/// A pair of numbers. Throws Error for anything else.
Vec2 read_pair(const JsonValue& value);

/// A point of the file in metres, before an origin is taken off. `unit` is metres. Throws Error for
/// one more than a kilometre away.
Vec2 read_point(const JsonValue& value, double unit);

/// Adds a note to `remarks` for each key that is not in `known`.
void note_unread(const JsonValue& value, const std::vector<std::string>& known,
                 std::vector<Remark>& remarks);

/// Throws Error if `list` has more than `max` entries, which are `what`.
void refuse_more(const JsonValue& list, std::size_t count, int max, const std::string& what);

/// The edges of a panel, and the loop that they make.
struct PanelEdges {
  std::vector<PatternEdge> edges;
  std::vector<OutlineStep> outline;
};

/// Reads the edges between `vertices` (metres). `place` names the panel in messages. What is not
/// read, and what was assumed, is added to `remarks`. Throws Error for vertices that are not there,
/// for curves and elastics out of range, and for edges that are not one closed loop.
PanelEdges read_edges(const JsonValue& list, const std::vector<Vec2>& vertices,
                      const DrawingFrame& frame, const std::string& place,
                      std::vector<Remark>& remarks);

/// The edge that side `which` of a stitch names, of a panel with `edges` edges, edges > 0. Throws
/// Error for one that is not there.
int read_sewn_edge(const JsonValue& stitch, std::size_t which, const std::string& panel,
                   std::size_t edges);

}  // namespace toile
