#include "pattern/measure/sewn_panels.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "pattern/mesh/mesh_panels.h"
#include "pattern/mesh/seam_orientation.h"

namespace toile {

namespace {

/// Metres: chords that stand for a curve. At a radius of 3 cm they lie 0.02 mm off it; of double
/// the length 0.07 mm.
constexpr double chord = 0.002;

/// Metres: panels are meshed to tell what they are, not to be measured.
constexpr double coarse_edge = 0.03;

/// Metres: a line that starts on an outline has left it.
constexpr double left_outline = 1e-6;

/// Cosine, of 45 degrees: a line that meets an edge at less to the square goes over it, one at more
/// runs along it. Half and double were not tried.
constexpr double nearer_across = 0.707;

/// Sine: an edge that a level line meets at less is level itself. Half and
/// double were not tried.
constexpr double too_level = 0.3;

/// Cosine, of 30 degrees: yarns that are farther off are those of a panel on the bias. Half and
/// double were not tried.
constexpr double off_bias = 0.866;

/// Share of up in the direction out of an edge, below which the edge is a side. Half and double
/// were not tried.
constexpr double is_upright = 0.5;

/// Metres from the body's middle: a panel whose middle is nearer belongs to no side. Half and
/// double were not tried.
constexpr double beside_middle = 0.02;

double cross_product(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

std::tuple<int, int, bool> key(const EdgeEnd& end) {
  return {end.edge.panel, end.edge.edge, end.is_end};
}

}  // namespace

std::vector<PanelClass> panel_classes(const Pattern& pattern) {
  std::vector<Remark> remarks;  // mesh-pattern says them
  std::vector<PanelClass> classes;
  for (const MeshedPanel& panel : mesh_panels(pattern, {coarse_edge, 0}, remarks).panels) {
    classes.push_back(panel.is);
  }
  return classes;
}

SewnPanels::SewnPanels(const Pattern& pattern, std::vector<PanelClass> is)
    : pattern_(pattern), is_(std::move(is)) {
  std::vector<Remark> remarks;  // mesh-pattern says them
  for (PanelClass& panel : is_) {
    if (panel.worn_as == PanelRole::unknown) panel.worn_as.is = PanelRole::bodice;
  }
  const int count = static_cast<int>(pattern.panels.size());
  chords_.resize(count);
  edges_.resize(count);
  for (int p = 0; p < count; ++p) add_outline(p);
  const Orientation orientation = orient(pattern, remarks);
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    if (stitch.layered) continue;
    const bool reversed = orientation.reversed[s];
    partners_.try_emplace({stitch.a.panel, stitch.a.edge}, Partner{stitch.b, reversed});
    partners_.try_emplace({stitch.b.panel, stitch.b.edge}, Partner{stitch.a, reversed});
  }
  join_corners();
  const bool placed = has_places(pattern);
  for (int p = 0; p < count; ++p) {
    const PatternPanel& panel = pattern.panels[p];
    Vec2 middle = Vec2::Zero();  // of the outline
    double around = 0;
    for (const Chord& c : chords_[p]) {
      middle += (c.b - c.a).norm() * 0.5 * (c.a + c.b);
      around += (c.b - c.a).norm();
    }
    middle /= around;
    const Vec3 place = placed ? panel.place(middle) : Vec3::Zero();
    const auto sign = [](double along) {
      return std::abs(along) < beside_middle ? 0 : along < 0 ? -1 : 1;
    };
    side_.push_back(is_[p].side != PanelSide::none ? side_sign(is_[p]) : sign(place.x()));
    face_.push_back(is_[p].face != PanelFace::none ? face_sign(is_[p]) : sign(place.z()));
    // A sleeve hangs from its cap, however its arm is held.
    Vec2 cap = Vec2::Zero();
    double cap_length = 0;
    for (const EdgeRef& edge : edges_[p]) {
      const std::optional<EdgeRef> other = partner(edge);
      if (is_[p].worn_as != PanelRole::sleeve || !other ||
          is_[other->panel].worn_as == PanelRole::sleeve) {
        continue;
      }
      cap += length(edge) * (at({edge, 0.5}) - middle);
      cap_length += length(edge);
    }
    const Vec2 upright = cap_length > 0 ? cap : Vec2(panel.rotation(1, 0), panel.rotation(1, 1));
    const Vec2 yarn = yarn_towards(p, upright);
    const bool is_on_bias = yarn.dot(upright) < off_bias * upright.norm();
    up_.push_back(is_on_bias && cap_length == 0 ? Vec2(upright.normalized()) : yarn);
  }
}

void SewnPanels::add_outline(int p) {
  const PatternPanel& panel = pattern_.panels[p];
  std::vector<Vec2> polygon;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[step.edge].curve;
    const int count =
        curve.straight() ? 1 : std::max(16, static_cast<int>(std::ceil(curve.length() / chord)));
    std::vector<Vec2> points = curve.sample(count);
    if (!step.forward) std::ranges::reverse(points);
    for (int i = 0; i < count; ++i) {
      const double from = static_cast<double>(i) / count;
      const double to = static_cast<double>(i + 1) / count;
      chords_[p].push_back({{p, step.edge},
                            step.forward ? from : 1 - from,
                            step.forward ? to : 1 - to,
                            points[i],
                            points[i + 1]});
      polygon.push_back(points[i]);
    }
    edges_[p].push_back({p, step.edge});
  }
  turn_.push_back(signed_area(polygon) < 0 ? -1 : 1);
  for (std::size_t i = 0; i < panel.outline.size(); ++i) {
    const OutlineStep& here = panel.outline[i];
    const OutlineStep& next = panel.outline[(i + 1) % panel.outline.size()];
    const EdgeEnd last{{p, here.edge}, here.forward};
    const EdgeEnd first{{p, next.edge}, !next.forward};
    beside_[key(last)] = first;
    beside_[key(first)] = last;
  }
}

void SewnPanels::join_corners() {
  for (const auto& [end, other] : beside_) {
    corners_.emplace(end, static_cast<int>(corners_.size()));
  }
  std::vector<int> rank(corners_.size());
  std::vector<int> parent(corners_.size());
  std::iota(parent.begin(), parent.end(), 0);
  boost::disjoint_sets sets(rank.data(), parent.data());
  for (const auto& [end, other] : beside_) sets.union_set(corners_[end], corners_[key(other)]);
  for (const auto& [edge, sewn] : partners_) {
    for (const bool is_end : {false, true}) {
      const auto mine = corners_.find({edge.first, edge.second, is_end});
      const auto other = corners_.find(key({sewn.edge, is_end != sewn.reversed}));
      if (mine != corners_.end() && other != corners_.end()) {
        sets.union_set(mine->second, other->second);
      }
    }
  }
  for (auto& [end, corner] : corners_) corner = sets.find_set(corner);
}

Vec2 SewnPanels::yarn_towards(int panel, const Vec2& direction) const {
  const double grain = pattern_.panels[panel].grain;
  const Vec2 weft(std::cos(grain), std::sin(grain));
  const Vec2 warp(-weft.y(), weft.x());
  Vec2 nearest = warp;
  for (const Vec2& yarn : {Vec2(-warp), weft, Vec2(-weft)}) {
    if (yarn.dot(direction) > nearest.dot(direction)) nearest = yarn;
  }
  return nearest;
}

Vec2 SewnPanels::at(const EdgePoint& point) const {
  return pattern_.panels[point.edge.panel].edges[point.edge.edge].curve.at(point.fraction);
}

double SewnPanels::length(const EdgeRef& edge) const {
  return pattern_.panels[edge.panel].edges[edge.edge].curve.length();
}

std::optional<EdgeRef> SewnPanels::partner(const EdgeRef& edge) const {
  const auto found = partners_.find({edge.panel, edge.edge});
  return found == partners_.end() ? std::nullopt : std::optional(found->second.edge);
}

double SewnPanels::facing(const EdgeRef& edge) const {
  const auto& outline = pattern_.panels[edge.panel].outline;
  const auto step = std::ranges::find(outline, edge.edge, &OutlineStep::edge);
  Vec2 along = at({edge, 1}) - at({edge, 0});
  if (!step->forward) along = -along;
  const double chord_length = along.norm();
  if (!(chord_length > 0)) return 0;
  return -turn_[edge.panel] * Vec2(-along.y(), along.x()).dot(up(edge.panel)) / chord_length;
}

EdgeEnd SewnPanels::beside(const EdgeEnd& end) const { return beside_.at(key(end)); }

int SewnPanels::corner(const EdgeEnd& end) const { return corners_.at(key(end)); }

const std::vector<EdgeRef>& SewnPanels::edges_of(int panel) const { return edges_[panel]; }

EdgePoint SewnPanels::below(const EdgeEnd& end, double drop) const {
  const EdgePoint from{end.edge, end.is_end ? 1.0 : 0.0};
  if (drop == 0) return from;
  const Vec2& upward = up(end.edge.panel);
  const double level = at(from).dot(upward) - drop;
  for (EdgeEnd begin : {end, beside(end)}) {
    for (std::size_t i = 0; i < edges_[end.edge.panel].size(); ++i) {
      // The edge is left at its other end. It may rise no more than a hundredth of the way.
      const auto height = [&](double fraction) {
        return at({begin.edge, begin.is_end ? 1 - fraction : fraction}).dot(upward) - level;
      };
      if (height(0) < height(0.01)) break;
      if (height(1) <= 0) {
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; ++halving) {
          const double half = 0.5 * (low + high);
          (height(half) > 0 ? low : high) = half;
        }
        return {begin.edge, begin.is_end ? 1 - high : high};
      }
      begin = beside({begin.edge, !begin.is_end});
    }
  }
  throw Error(edge_name(pattern_, end.edge), "no edge leads so far down from its end",
              "ask for a shorter way down");
}

SewnPanels::OnChord SewnPanels::on_chord(const EdgePoint& point) const {
  const int panel = point.edge.panel;
  const auto found = std::ranges::find_if(chords_[panel], [&](const Chord& c) {
    return c.edge.edge == point.edge.edge && std::min(c.from, c.to) <= point.fraction &&
           point.fraction <= std::max(c.from, c.to);
  });
  const Vec2 along = found->b - found->a;
  return {found->a + (point.fraction - found->from) / (found->to - found->from) * along,
          turn_[panel] * Vec2(-along.y(), along.x()).normalized()};
}

std::optional<SewnPanels::Crossing> SewnPanels::cross(int panel, const Vec2& from,
                                                      const Vec2& direction) const {
  std::optional<Crossing> nearest;
  for (const Chord& c : chords_[panel]) {
    const Vec2 along = c.b - c.a;
    const double turned = cross_product(direction, along);
    if (std::abs(turned) < 1e-9 * along.norm()) continue;  // parallel
    const double way = cross_product(c.a - from, along) / turned;
    const double share = cross_product(c.a - from, direction) / turned;
    if (way < left_outline || share < -1e-9 || share > 1 + 1e-9) continue;
    if (!nearest || way < nearest->length) {
      nearest = {{c.edge, std::lerp(c.from, c.to, std::clamp(share, 0.0, 1.0))}, way};
    }
  }
  return nearest;
}

std::optional<EdgePoint> SewnPanels::sewn_to(const EdgePoint& point) const {
  const auto found = partners_.find({point.edge.panel, point.edge.edge});
  if (found == partners_.end()) return std::nullopt;
  return EdgePoint{found->second.edge,
                   found->second.reversed ? 1 - point.fraction : point.fraction};
}

LevelLine SewnPanels::level_line(const EdgePoint& from) const {
  LevelLine line;
  // Once into the panel and, where that does not close, once out of it over its own seam.
  std::optional<EdgePoint> first_left;
  for (const bool is_out : {false, true}) {
    EdgePoint here = from;
    if (is_out) {
      if (!sewn_to(from)) break;
      here = *sewn_to(from);
    }
    for (std::size_t crossed = 0;; ++crossed) {
      const int panel = here.edge.panel;
      const Vec2& upward = up(panel);
      Vec2 level(-upward.y(), upward.x());
      const OnChord start = on_chord(here);
      if (level.dot(start.inward) < 0) level = -level;
      const std::optional<Crossing> left = cross(panel, start.at, level);
      if (!left || level.dot(start.inward) < too_level ||
          crossed > chords_.size() + partners_.size()) {
        throw Error(edge_name(pattern_, from.edge), "no level line leads around from there",
                    "measure from another point, or along edges");
      }
      line.length += left->length;
      line.panels.insert(panel);
      if (!first_left) first_left = left->at;
      if (!sewn_to(left->at)) break;
      here = *sewn_to(left->at);
      // Back where it began: nearer to there than to where it first left that panel.
      if (!is_out && here.edge.panel == from.edge.panel &&
          (at(here) - at(from)).norm() < (at(here) - at(*first_left)).norm()) {
        line.closes = true;
        return line;
      }
    }
  }
  return line;
}

double SewnPanels::length_down(const EdgePoint& from) const {
  double length = 0;
  EdgePoint here = from;
  Vec2 down = -up(from.edge.panel);
  for (std::size_t crossed = 0; crossed <= partners_.size(); ++crossed) {
    const std::optional<Crossing> left = cross(here.edge.panel, on_chord(here).at, down);
    if (!left) break;
    length += left->length;
    EdgePoint end = left->at;
    if (down.dot(-on_chord(end).inward) < nearer_across) {
      if (!sewn_to(end)) break;
      // Along the seam to its lower end.
      const bool is_end = (at({end.edge, 1}) - at({end.edge, 0})).dot(down) > 0;
      length += std::abs((is_end ? 1 : 0) - end.fraction) * this->length(end.edge);
      EdgeEnd below = beside({end.edge, is_end});
      for (std::size_t i = 0; i < edges_[below.edge.panel].size(); ++i) {
        const EdgeEnd far = {below.edge, !below.is_end};
        const bool goes_down =
            (at({far.edge, far.is_end ? 1.0 : 0.0}) - at({below.edge, below.is_end ? 1.0 : 0.0}))
                .dot(down) > 0;
        if (!goes_down || std::abs(facing(below.edge)) > is_upright) break;
        length += this->length(below.edge);
        below = beside(far);
      }
      end = {below.edge, below.is_end ? 1.0 : 0.0};
    }
    const std::optional<EdgePoint> next = sewn_to(end);
    if (!next) return length;
    here = *next;
    down = yarn_towards(here.edge.panel, on_chord(here).inward);
  }
  throw Error(edge_name(pattern_, from.edge), "no line leads straight down from there",
              "measure from another point, or along edges");
}

}  // namespace toile
