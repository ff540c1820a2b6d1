// A sewing pattern: flat panels bounded by curves, their placement, and the seams between them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/body/body_part.h"
#include "geometry/types.h"
#include "pattern/attachment.h"
#include "pattern/edge_curve.h"
#include "pattern/panel_placement.h"

namespace toile {

/// A remark on an input that can be used nevertheless.
struct Remark {
  bool warning = false;  ///< false: a note
  std::string text;      ///< names the file, the panel and the edge
};

/// An elastic along an edge.
struct Elastic {
  double ratio = 1;      ///< its length at rest over the edge's length, at most 1
  double stiffness = 0;  ///< N: its tension is this times the strain
};

/// One edge of a panel's outline. The curve is in metres, in the panel's drawing.
struct PatternEdge {
  EdgeCurve curve;
  std::string label;
  std::optional<Elastic> elastic{};
};

/// An edge of a panel that an attachment holds, or one end of the edge.
struct PanelAttachment {
  enum class Share { whole, start, end };
  std::string name;  ///< the number of the edge, or "v" and the number of the vertex
  int edge = 0;      ///< index into PatternPanel::edges
  Share share = Share::whole;
  Attachment how;
};

/// One edge of an outline. `forward` when the outline runs from the edge's start to its end.
struct OutlineStep {
  int edge = 0;  ///< index into PatternPanel::edges
  bool forward = true;
};

/// A mark on the outline, at a vertex of it, to sew by.
struct PanelNotch {
  int vertex = 0;               ///< as the file counts the panel's vertices
  Vec2 at = Vec2::Zero();       ///< metres: that vertex
  std::optional<double> angle;  ///< radians from +x, counter-clockwise, if stated
};

/// A flat piece as drawn, in metres.
struct PatternPanel {
  std::string name;
  BodyPart part = BodyPart::none;  ///< that it is for, as its placement states it
  std::string fabric;              ///< empty: the garment's
  std::string label;  ///< "body", "arm" or "leg", as GarmentCode has it; empty: not stated
  /// Radians, counter-clockwise: angle of the warp against the drawing's +y axis.
  double grain = 0;
  std::vector<PatternEdge> edges;  ///< in the file's order
  /// One closed loop through all edges but those that are merged with others.
  std::vector<OutlineStep> outline;
  std::vector<PanelAttachment> attachments;
  // What a pattern maker draws besides. Cut-outs, lines and holes are meshed; notches are not.
  std::vector<PanelNotch> notches;
  std::vector<std::vector<Vec2>> internal_lines;  ///< chords
  std::vector<std::vector<Vec2>> cut_outs;        ///< closed, the first point not repeated
  std::vector<Vec2> drill_holes;
  std::string material;  ///< as the drawing has it; empty: not stated
  int quantity = 1;      ///< how often it is cut
  /// Why the garment is sewn without it, such as "pocket"; empty: it is sewn.
  std::string left_out;
  /// It is one of a pair of which one was drawn: left and right in its name may be exchanged.
  bool side_unknown = false;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< from the drawing (x, y, 0) to space
  Vec3 translation = Vec3::Zero();                         ///< metres
  Vec3 origin = Vec3::Zero();  ///< metres: the translation as the file states it; zero: it does not
  PanelPlacement placement{};  ///< how the skeleton positions it; by default it does not

  /// A point of the drawing in space, by rotation and translation. Metres.
  Vec3 place(const Vec2& drawn) const {
    return rotation * Vec3(drawn.x(), drawn.y(), 0) + translation;
  }
};

/// An edge of a panel, by index.
struct EdgeRef {
  int panel = 0;
  int edge = 0;
};

/// How the two edges of a stitch meet.
enum class StitchDirection {
  by_position,     ///< neither stated nor GarmentCode's: the placed end points decide, see orient()
  end_to_start,    ///< one edge's end meets the other's start
  start_to_start,  ///< they run side by side
};

/// Two edges that are sewn together.
struct Stitch {
  std::string name;  ///< empty: not named
  EdgeRef a;
  EdgeRef b;
  StitchDirection direction = StitchDirection::by_position;
  bool gathered = false;  ///< the longer side is meant to be gathered
  /// The second panel lies upon the first one, facing the same way, as a facing or a pocket does.
  /// Its edge may be sewn to an edge that is in another stitch already.
  bool layered = false;
  double fullness = 0;  ///< declared length of the longer side over the shorter's; 0: as drawn
};

/// A whole pattern.
struct Pattern {
  std::string source;  ///< the file it came from, for messages
  std::vector<PatternPanel> panels;
  std::vector<Stitch> stitches;
};

/// Whether the pattern says where its panels stand: by a `placement`, or by origins that differ.
bool has_places(const Pattern& pattern);

/// "panel 'skirt_front', edge 3", for messages. Edges count from 0, as in the file.
std::string edge_name(const Pattern& pattern, const EdgeRef& ref);

}  // namespace toile
