// The flat panels of a pattern, with lines that are followed over their seams.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "pattern/classify/panel_class.h"
#include "pattern/pattern.h"

namespace toile {

/// A point of a panel's outline.
struct EdgePoint {
  EdgeRef edge;
  double fraction = 0;  ///< of the edge's length from its start, 0 to 1
};

/// One end of an edge.
struct EdgeEnd {
  EdgeRef edge;
  bool is_end = false;  ///< false: where the edge starts
};

/// A level line over the panels.
struct LevelLine {
  double length = 0;  ///< metres
  bool closes = false;
  std::set<int> panels = {};  ///< that it crosses
};

/// What each panel of a checked pattern is (classify.h). Costs a coarse mesh. Throws as
/// mesh_panels() does.
std::vector<PanelClass> panel_classes(const Pattern& pattern);

/// The panels of a pattern and what each edge is sewn to. Lengths in metres, of the pattern's own
/// curves: a line's within 0.1 mm. Panels are looked at as they are drawn. Layered seams do not
/// count.
class SewnPanels {
 public:
  /// Of a pattern as drawn, which outlives this: what is mended for a mesh is up to 2 mm off. `is`:
  /// what each panel is, see panel_classes(). Where nobody tells what one is worn as, it counts as
  /// of the bodice.
  SewnPanels(const Pattern& pattern, std::vector<PanelClass> is);

  const Pattern& pattern() const { return pattern_; }
  const PanelClass& is(int panel) const { return is_[panel]; }
  /// The wearer's side and the face, by class, else by place; 0: in the middle, or not known.
  int side(int panel) const { return side_[panel]; }
  int face(int panel) const { return face_[panel]; }
  /// Unit length, in the drawing: the yarn that points up on a wearer, in a sleeve to its cap. On
  /// the bias, where yarns are more than 30 degrees off that, it is up itself.
  const Vec2& up(int panel) const { return up_[panel]; }

  Vec2 at(const EdgePoint& point) const;
  double length(const EdgeRef& edge) const;
  /// The edge that it is sewn to; nothing: it is open.
  std::optional<EdgeRef> partner(const EdgeRef& edge) const;
  /// Up's share in the direction out of the panel, square to the edge's chord. 1: an upper edge,
  /// -1: a lower one, 0: a side.
  double facing(const EdgeRef& edge) const;
  /// The end of the other edge at the same corner of the panel.
  EdgeEnd beside(const EdgeEnd& end) const;
  /// The number of a corner. Corners that are sewn together have the same one.
  int corner(const EdgeEnd& end) const;
  /// All edges of a panel's outline, in its order.
  const std::vector<EdgeRef>& edges_of(int panel) const;

  /// The point that lies `drop` metres lower than `end`, along the edges that lead down from it.
  /// Throws Error where none does so far.
  EdgePoint below(const EdgeEnd& end, double drop) const;

  /// Length of the line that runs level through a point of the outline. In each panel it is square
  /// to up. It ends where it closes, or where both its ends reach an end of the cloth. Throws Error
  /// for a line that does neither, and for a point on an edge that is level itself.
  LevelLine level_line(const EdgePoint& from) const;
  /// Length from a point straight down to the end of the cloth. Over a seam it goes on along the
  /// yarn that leads away from the seam. Where it would run along a seam it follows the seam.
  /// Throws Error where no lower edge lies below the point.
  double length_down(const EdgePoint& from) const;

 private:
  struct Chord {
    EdgeRef edge;
    double from = 0;  // fractions of the edge's length, as the outline runs
    double to = 0;
    Vec2 a, b;
  };
  struct Partner {
    EdgeRef edge;
    bool reversed = false;
  };
  struct Crossing {
    EdgePoint at;
    double length = 0;
  };

  void add_outline(int panel);
  void join_corners();
  Vec2 yarn_towards(int panel, const Vec2& direction) const;
  /// The place of a point on the outline's chords, and the unit vector into the panel there.
  struct OnChord {
    Vec2 at;
    Vec2 inward;
  };
  OnChord on_chord(const EdgePoint& point) const;
  std::optional<Crossing> cross(int panel, const Vec2& from, const Vec2& direction) const;
  std::optional<EdgePoint> sewn_to(const EdgePoint& point) const;

  const Pattern& pattern_;
  std::vector<PanelClass> is_;
  std::vector<int> side_;
  std::vector<int> face_;
  std::vector<Vec2> up_;
  std::vector<double> turn_;                // per panel: 1 where the outline is counter-clockwise
  std::vector<std::vector<Chord>> chords_;  // per panel, in the outline's order
  std::vector<std::vector<EdgeRef>> edges_;
  std::map<std::pair<int, int>, Partner> partners_;
  std::map<std::tuple<int, int, bool>, EdgeEnd> beside_;
  std::map<std::tuple<int, int, bool>, int> corners_;
};

}  // namespace toile
