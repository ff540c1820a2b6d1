#include "pattern/measure/points_of_measure.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "geometry/error.h"
#include "pattern/measure/measuring_rule.h"

namespace toile {

namespace {

/// Where girths below an armhole or a crotch are taken, as is the trade's custom: an inch below.
constexpr const char* inch_below = " 2.5cm below";

/// An edge whose facing() is more looks up, one whose is less than its negative looks down: it is
/// at most 60 degrees off level. Half and double were not tried.
constexpr double looks_up = 0.5;

/// An open edge whose facing() is less ends a neckline or an armhole: it is upright. Half and
/// double were not tried.
constexpr double leans_up = 0.1;

std::string sided(int side, const std::string& name) {
  if (side == 0) return name;
  return std::string(side > 0 ? "left " : "right ").append(name);
}

class PointFinder {
 public:
  explicit PointFinder(const SewnPanels& panels) : panels_(panels), pattern_(panels.pattern()) {}

  std::vector<PointOfMeasure> found() {
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
      if (!is_sewn_in(static_cast<int>(p))) continue;
      const std::vector<EdgeRef>& edges = panels_.edges_of(static_cast<int>(p));
      edges_.insert(edges_.end(), edges.begin(), edges.end());
    }
    find_bodice();
    find_sleeves();
    find_waist();
    find_legs();
    find_hem();
    return std::move(points_);
  }

 private:
  /// Whether a panel is sewn to others edge to edge, or is the only one. One that lies upon
  /// another, as a pocket, plays no part.
  bool is_sewn_in(int panel) const {
    if (pattern_.panels.size() == 1) return true;
    const bool lies_upon = std::ranges::any_of(pattern_.stitches, [&](const Stitch& stitch) {
      return stitch.layered && stitch.b.panel == panel;
    });
    const std::vector<EdgeRef>& edges = panels_.edges_of(panel);
    return !lies_upon && std::ranges::any_of(edges, [&](const EdgeRef& edge) {
      const std::optional<EdgeRef> other = panels_.partner(edge);
      return other && other->panel != panel;
    });
  }

  // What is asked of edges.

  const PanelClass& is(const EdgeRef& edge) const { return panels_.is(edge.panel); }
  PanelRole worn_as(const EdgeRef& edge) const { return is(edge).worn_as; }
  bool is_open(const EdgeRef& edge) const { return !panels_.partner(edge); }
  /// What the panel across the seam is worn as; nothing: the edge is open.
  std::optional<PanelRole> worn_across(const EdgeRef& edge) const {
    const std::optional<EdgeRef> other = panels_.partner(edge);
    return other ? std::optional(worn_as(*other)) : std::nullopt;
  }
  bool is_bodice(const EdgeRef& edge) const {
    return worn_as(edge) == PanelRole::bodice && !is(edge).is_headwear();
  }
  bool hangs_low(const EdgeRef& edge) const {
    return worn_as(edge) == PanelRole::skirt || worn_as(edge) == PanelRole::trousers;
  }
  bool looks_down(const EdgeRef& edge) const { return panels_.facing(edge) < -looks_up; }
  double height(const EdgeEnd& end) const {
    return panels_.at(point(end)).dot(panels_.up(end.edge.panel));
  }
  static EdgePoint point(const EdgeEnd& end) { return {end.edge, end.is_end ? 1.0 : 0.0}; }
  EdgeEnd higher_end(const EdgeRef& edge) const {
    return height({edge, true}) > height({edge, false}) ? EdgeEnd{edge, true}
                                                        : EdgeEnd{edge, false};
  }
  EdgeEnd lower_end(const EdgeRef& edge) const {
    const EdgeEnd high = higher_end(edge);
    return {edge, !high.is_end};
  }

  /// The edges from a corner on that hold a condition, in the order of the outline, and the far
  /// end of the last one.
  struct Chain {
    std::vector<EdgeRef> edges;
    EdgeEnd last;
  };
  template <typename Condition>
  Chain chain_from(EdgeEnd begin, const Condition& holds) const {
    Chain chain;
    while (holds(begin.edge) && chain.edges.size() < panels_.edges_of(begin.edge.panel).size()) {
      chain.edges.push_back(begin.edge);
      chain.last = {begin.edge, !begin.is_end};
      begin = panels_.beside(chain.last);
    }
    return chain;
  }
  template <typename Condition>
  std::vector<EdgeRef> edges_that(const Condition& hold) const {
    std::vector<EdgeRef> kept;
    std::ranges::copy_if(edges_, std::back_inserter(kept), hold);
    return kept;
  }

  /// Adds those of `more` that `edges` does not have.
  static void add_new(const std::vector<EdgeRef>& more, std::vector<EdgeRef>& edges) {
    for (const EdgeRef& edge : more) {
      const auto is_known = [&](const EdgeRef& known) {
        return known.panel == edge.panel && known.edge == edge.edge;
      };
      if (std::ranges::none_of(edges, is_known)) edges.push_back(edge);
    }
  }

  // What is added.

  void add(const std::string& name, const std::string& rule) {
    if (names_.insert(name).second) points_.push_back({name, rule});
  }
  void add_along(const std::string& name, const std::vector<EdgeRef>& edges, bool is_half = false) {
    if (edges.empty()) return;
    const std::string half(is_half ? "half " : "");
    add(std::string(half).append(name), std::string(half).append(rule_along(pattern_, edges)));
  }
  std::string text(const EdgeEnd& end) const { return rule_text(pattern_, point(end)); }

  // The garment, part by part.

  /// Where the two sides of a shoulder seam both look up.
  bool is_shoulder(const EdgeRef& edge) const {
    const std::optional<EdgeRef> other = panels_.partner(edge);
    return is_bodice(edge) && other && is_bodice(*other) && other->panel != edge.panel &&
           panels_.facing(edge) > looks_up && panels_.facing(*other) > looks_up;
  }

  /// The next piece of a shoulder seam on the same face, outward or to the neck.
  std::optional<EdgeRef> piece_beyond(const EdgeRef& piece, const std::vector<EdgeRef>& pieces,
                                      bool is_outward) const {
    const int corner = panels_.corner(is_outward ? lower_end(piece) : higher_end(piece));
    for (const EdgeRef& other : pieces) {
      const EdgeEnd end = is_outward ? higher_end(other) : lower_end(other);
      if (panels_.face(other.panel) == panels_.face(piece.panel) && panels_.corner(end) == corner) {
        return other;
      }
    }
    return std::nullopt;
  }

  /// Whether the level line below an armhole closes, or reaches both halves of an open garment.
  bool goes_around(const EdgeEnd& underarm) const {
    try {
      const LevelLine line = panels_.level_line(panels_.below(underarm, 0.025));
      std::set<int> sides;
      for (const int panel : line.panels) sides.insert(panels_.side(panel));
      return line.closes || (sides.contains(1) && sides.contains(-1));
    } catch (const Error&) {
      return false;
    }
  }

  void find_bodice() {
    // What begins at the shoulder is of neckline or armhole. Open edges after it are while they
    // lean.
    const auto goes_on = [this](const EdgeRef& edge, const EdgeRef& first) {
      return is_open(edge) && (edge.edge == first.edge || panels_.facing(edge) > leans_up);
    };
    std::vector<EdgeRef> neckline;
    std::map<int, std::vector<EdgeRef>> armholes;  // by side
    std::map<int, std::vector<EdgeRef>> shoulders;
    std::optional<EdgeEnd> underarm;
    const std::vector<EdgeRef> pieces =
        edges_that([this](const EdgeRef& e) { return is_shoulder(e); });
    for (const EdgeRef& shoulder : pieces) {
      if (piece_beyond(shoulder, pieces, false)) continue;  // it goes on to the neck
      std::vector<EdgeRef> whole = {shoulder};
      while (const auto next = piece_beyond(whole.back(), pieces, true)) whole.push_back(*next);
      const int panel = shoulder.panel;
      const EdgeEnd neck = panels_.beside(higher_end(shoulder));
      const EdgeEnd tip = panels_.beside(lower_end(whole.back()));
      const Chain neck_edges = chain_from(neck, [&](const EdgeRef& edge) {
        const std::optional<EdgeRef> other = panels_.partner(edge);
        return is_bodice(edge) && (other ? is(*other).is_headwear() : goes_on(edge, neck.edge));
      });
      const Chain armhole = chain_from(tip, [&](const EdgeRef& edge) {
        return is_bodice(edge) &&
               (worn_across(edge) == PanelRole::sleeve || goes_on(edge, tip.edge));
      });
      const int side = side_of(tip, tip.edge.panel);
      const bool is_front = panels_.face(panel) > 0;
      if (is_front || !shoulders.contains(side)) shoulders.insert_or_assign(side, whole);
      if (!armhole.edges.empty()) {
        std::ranges::copy(armhole.edges, std::back_inserter(armholes[side]));
        if (!underarm || (is_front && panels_.face(underarm->edge.panel) <= 0)) {
          underarm = armhole.last;
        }
      }
      if (neck_edges.edges.empty()) continue;
      add_new(neck_edges.edges, neckline);
      find_from_neck(panels_.beside(neck), tip, neck_edges);
    }
    if (underarm && goes_around(*underarm)) {
      add("half chest", "half around " + text(*underarm) + inch_below);
    }
    for (const auto& [side, edges] : shoulders) add_along(sided(side, "shoulder"), edges);
    // Those of side panels are sewn to no shoulder.
    for (auto& armhole : armholes) {
      const int side = armhole.first;
      std::vector<EdgeRef>& edges = armhole.second;
      add_new(edges_that([&](const EdgeRef& e) {
                return is_bodice(e) && worn_across(e) == PanelRole::sleeve &&
                       panels_.side(panels_.partner(e)->panel) == side;
              }),
              edges);
      add_along(sided(side, "armhole"), edges);
    }
    add_along("neckline", neckline);
    if (shoulders.empty()) {
      add_along("top edge", edges_that([this](const EdgeRef& edge) {
                  return is_bodice(edge) && is_open(edge) && panels_.facing(edge) > looks_up;
                }),
                true);
    }
    add_along("waist seam", edges_that([this](const EdgeRef& edge) {
                const std::optional<EdgeRef> other = panels_.partner(edge);
                return is_bodice(edge) && other &&
                       (hangs_low(*other) || worn_as(*other) == PanelRole::waistband);
              }),
              true);
  }

  /// The side of a shoulder's outer end: its panel's, or on a panel of both sides that on which it
  /// is drawn. Patterns are seen from outside, so a back's left lies on the left.
  int side_of(const EdgeEnd& tip, int panel) const {
    if (panels_.side(panel) != 0) return panels_.side(panel);
    const Vec2 upward = panels_.up(panel);
    double middle = 0;
    const std::vector<EdgeRef>& edges = panels_.edges_of(panel);
    const auto across = [&](const EdgePoint& p) {
      return panels_.at(p).dot(Vec2(upward.y(), -upward.x()));
    };
    for (const EdgeRef& edge : edges) {
      middle += 0.5 * (across({edge, 0}) + across({edge, 1})) / static_cast<double>(edges.size());
    }
    const PatternPanel& drawn = pattern_.panels[panel];
    const bool shows_inside =
        has_places(pattern_) && (drawn.rotation.col(2).z() < 0) != (panels_.face(panel) < 0);
    const bool is_right_drawn = across(point(tip)) > middle;
    return is_right_drawn == ((panels_.face(panel) >= 0) != shows_inside) ? 1 : -1;
  }

  /// Widths, drop and lengths of a front or back, from the neck's side and in the centre.
  void find_from_neck(const EdgeEnd& side, const EdgeEnd& tip, const Chain& neckline) {
    const int panel = side.edge.panel;
    if (panels_.face(panel) == 0) return;
    const std::string face = panels_.face(panel) > 0 ? "front" : "back";
    add(face + " length from the neck's side", "down " + text(side));
    const std::optional<EdgeRef> centre_seam = panels_.partner(panels_.beside(neckline.last).edge);
    const bool is_whole = is_shoulder(panels_.beside(neckline.last).edge);
    EdgePoint middle = point(neckline.last);
    if (is_whole) {
      double half = 0;
      for (const EdgeRef& edge : neckline.edges) half += 0.5 * panels_.length(edge);
      EdgeEnd begin = panels_.beside(side);
      for (const EdgeRef& edge : neckline.edges) {
        const double length = panels_.length(edge);
        const double share = half > length * (1 - 1e-9) ? 1 : half / length;
        middle = {edge, begin.is_end ? 1 - share : share};
        if (half <= length * (1 + 1e-9)) break;
        half -= length;
        begin = panels_.beside({edge, !begin.is_end});
      }
    }
    const std::string to_middle = " " + rule_text(pattern_, middle);
    add(face + " neck drop", "drop " + text(side) + to_middle);
    if (panels_.face(panel) < 0) {
      add("neck width", "twice level " + text(side) + to_middle);
      if (tip.edge.panel == panel) {
        add("across shoulder", "twice level " + text(tip) + to_middle);
      }
    }
    if (is_whole) {
      add("centre " + face + " length", "down " + rule_text(pattern_, middle));
      return;
    }
    // Along the seam or the edge in the centre, down to what looks down.
    const Chain centre = chain_from(panels_.beside(neckline.last), [&](const EdgeRef& edge) {
      return !looks_down(edge) && is_open(edge) == !centre_seam.has_value();
    });
    if (centre.edges.empty()) return;
    const bool ends_open = is_open(panels_.beside(centre.last).edge);
    add_along("centre " + face + " length" + (ends_open ? "" : " to the waist"), centre.edges);
  }

  void find_sleeves() {
    std::set<int> corners;  // of shoulders
    for (const EdgeRef& edge : edges_that([this](const EdgeRef& e) { return is_shoulder(e); })) {
      corners.insert(panels_.corner(lower_end(edge)));
    }
    const auto is_sleeve = [this](const EdgeRef& edge) {
      return worn_as(edge) == PanelRole::sleeve;
    };
    const auto is_cap = [&](const EdgeRef& edge) {
      return is_sleeve(edge) && worn_across(edge) && worn_across(edge) != PanelRole::sleeve;
    };
    for (const int side : {1, -1, 0}) {
      std::optional<EdgeEnd> highest;
      std::optional<EdgeEnd> lowest;
      bool is_at_shoulder = false;
      for (const EdgeRef& edge : edges_that(is_cap)) {
        if (panels_.side(edge.panel) != side) continue;
        for (const EdgeEnd& end : {EdgeEnd{edge, false}, EdgeEnd{edge, true}}) {
          const bool meets = corners.contains(panels_.corner(end));
          if (!highest || (meets && !is_at_shoulder) ||
              (meets == is_at_shoulder && height(end) > height(*highest))) {
            highest = end;
            is_at_shoulder = meets;
          }
          const EdgeEnd under = panels_.beside(end);
          if (worn_across(under.edge) == PanelRole::sleeve &&
              (!lowest || height(under) < height(*lowest))) {
            lowest = under;
          }
        }
      }
      if (!highest || !lowest) continue;
      add(sided(side, "sleeve length"), "down " + text(*highest));
      add(sided(side, "half biceps"), "half around " + text(*lowest) + inch_below);
      add_along(sided(side, "sleeve inseam"), chain_from(*lowest, [&](const EdgeRef& edge) {
                                                return worn_across(edge) == PanelRole::sleeve &&
                                                       !looks_down(edge);
                                              }).edges);
      const std::vector<EdgeRef> opening = edges_that([&](const EdgeRef& edge) {
        return is_sleeve(edge) && panels_.side(edge.panel) == side && is_open(edge) &&
               looks_down(edge);
      });
      if (!opening.empty()) {
        add(sided(side, "half sleeve opening"), "half " + rule_along(pattern_, opening));
      }
    }
  }

  void find_waist() {
    const auto is_top_of = [this](const EdgeRef& edge, bool of_band) {
      const bool is_it = of_band ? worn_as(edge) == PanelRole::waistband : hangs_low(edge);
      return is_it && is_open(edge) && panels_.facing(edge) > looks_up;
    };
    for (const bool of_band : {true, false}) {
      add_along("waist", edges_that([&](const EdgeRef& edge) { return is_top_of(edge, of_band); }),
                true);
    }
    for (const EdgeRef& edge : edges_) {
      if (worn_as(edge) != PanelRole::skirt || panels_.face(edge.panel) <= 0) continue;
      const bool is_top =
          panels_.facing(edge) > looks_up && worn_across(edge) != std::optional(PanelRole::skirt);
      if (!is_top) continue;
      // A front of two panels has its middle at the end of an edge.
      const bool is_whole = panels_.side(edge.panel) == 0;
      if (is_whole) add("skirt length", "down " + rule_text(pattern_, EdgePoint{edge, 0.5}));
    }
  }

  void find_legs() {
    const auto is_leg = [this](const EdgeRef& edge) {
      return worn_as(edge) == PanelRole::trousers && panels_.side(edge.panel) != 0;
    };
    const auto crosses = [&](const EdgeRef& edge) {
      const std::optional<EdgeRef> other = panels_.partner(edge);
      return is_leg(edge) && other && is_leg(*other) &&
             panels_.side(other->panel) != panels_.side(edge.panel);
    };
    for (const int side : {1, -1}) {
      std::optional<EdgeEnd> crotch;
      std::vector<EdgeRef> inseam;
      const auto holds_leg = [&](const EdgeRef& edge) {
        return is_leg(edge) && panels_.side(edge.panel) == side;
      };
      for (const bool wants_front : {true, false}) {
        const std::vector<EdgeRef> rise = edges_that([&](const EdgeRef& edge) {
          return holds_leg(edge) && crosses(edge) && (panels_.face(edge.panel) > 0) == wants_front;
        });
        if (rise.empty()) continue;
        add_along(sided(side, wants_front ? "front rise" : "back rise"), rise);
        if (crotch) continue;
        const auto low = std::ranges::min_element(
            rise, {}, [&](const EdgeRef& edge) { return height(lower_end(edge)); });
        crotch = panels_.beside(lower_end(*low));
        inseam = chain_from(*crotch, [&](const EdgeRef& edge) {
                   return !is_open(edge) && !crosses(edge) && !looks_down(edge);
                 }).edges;
      }
      if (!crotch || inseam.empty()) continue;
      add_along(sided(side, "inseam"), inseam);
      add(sided(side, "half thigh"), "half around " + text(*crotch) + inch_below);
      add_along(sided(side, "outseam"), edges_that([&](const EdgeRef& edge) {
                  const std::optional<EdgeRef> other = panels_.partner(edge);
                  return edge.panel == crotch->edge.panel && other && holds_leg(*other) &&
                         other->panel != edge.panel && !looks_down(edge) &&
                         std::ranges::none_of(
                             inseam, [&](const EdgeRef& known) { return known.edge == edge.edge; });
                }));
      const std::vector<EdgeRef> opening = edges_that([&](const EdgeRef& edge) {
        return holds_leg(edge) && is_open(edge) && looks_down(edge);
      });
      if (!opening.empty()) {
        add(sided(side, "half leg opening"), "half " + rule_along(pattern_, opening));
      }
    }
  }

  void find_hem() {
    for (const PanelRole role : {PanelRole::skirt, PanelRole::bodice}) {
      const std::vector<EdgeRef> hem = edges_that([&](const EdgeRef& edge) {
        return worn_as(edge) == role && !is(edge).is_headwear() && is_open(edge) &&
               looks_down(edge);
      });
      add_along("hem", hem, true);
    }
  }

  const SewnPanels& panels_;
  const Pattern& pattern_;
  std::vector<EdgeRef> edges_;
  std::vector<PointOfMeasure> points_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<PointOfMeasure> points_of_measure(const SewnPanels& panels) {
  return PointFinder(panels).found();
}

}  // namespace toile
