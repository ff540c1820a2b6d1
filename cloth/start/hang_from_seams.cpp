#include "cloth/start/hang_from_seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "cloth/start/constants.h"
#include "cloth/start/facing.h"
#include "geometry/border_loops.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// The run of a panel's outline by which it hangs.
struct UpperSeam {
  std::vector<Vec2> flat;  ///< metres, on the panel, which lies to the left of the run
  std::vector<Vec3> at;    ///< metres: where the other side stands
  std::vector<Vec3> own;   ///< metres: where the panel's side stands
};

/// Where a point of a panel is, seen from the upper seam.
struct Foot {
  std::size_t segment = 0;
  double share = 0;   ///< in [0, 1], along the segment
  double beyond = 0;  ///< metres beyond the seam's end, along the segment
  double away = 0;    ///< metres from the seam, to its left
  double aside = 0;   ///< radians to the left from square to the segment, at a bend of the seam
};

Foot foot_on(const std::vector<Vec2>& seam, const Vec2& p) {
  Foot best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < seam.size(); ++i) {
    const Vec2 along = seam[i + 1] - seam[i];
    const double share = (p - seam[i]).dot(along) / along.squaredNorm();
    const double within = std::clamp(share, 0.0, 1.0);
    const Vec2 way = p - seam[i] - within * along;
    if (way.norm() >= nearest) continue;
    nearest = way.norm();
    const Vec2 left = Vec2(-along.y(), along.x()).normalized();
    const double away = way.dot(left);
    const double beyond = way.dot(along.normalized());
    const bool is_at_end = (i == 0 && share < 0) || (i + 2 == seam.size() && share > 1);
    const bool is_at_bend = within != share && !is_at_end;
    best = is_at_bend ? Foot{i, within, 0, nearest, std::atan2(-beyond, away)}
                      : Foot{i, within, beyond, away, 0};
  }
  return best;
}

/// Whether a seam turns a corner, as that of a godet does.
bool has_corner(const std::vector<Vec2>& line) {
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec2 before = (line[i - 1] - line[i]).normalized();
    const Vec2 after = (line[i + 1] - line[i]).normalized();
    if (before.dot(after) > strip_corner) return true;
  }
  return false;
}

/// Radians by which each segment of a polyline has turned from the first, to the left.
std::vector<double> turns(const std::vector<Vec2>& line) {
  std::vector<double> turned = {0};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec2 before = line[i] - line[i - 1];
    const Vec2 after = line[i + 1] - line[i];
    turned.push_back(turned.back() + std::atan2(before.x() * after.y() - before.y() * after.x(),
                                                before.dot(after)));
  }
  return turned;
}

/// Unit vectors square to the seam where it stands, into a panel that faces `facing`.
std::vector<Vec3> square_ways(const Vec3& facing, const std::vector<Vec3>& seam) {
  std::vector<Vec3> ways;
  for (std::size_t i = 0; i < seam.size(); ++i) {
    const Vec3 along = seam[std::min(i + 1, seam.size() - 1)] - seam[i == 0 ? 0 : i - 1];
    ways.push_back(facing.cross(along).normalized());
  }
  return ways;
}

/// The ways evened out along the seam, so that those of a panel `depth` metres deep don't meet.
std::vector<Vec3> evened(const std::vector<Vec3>& ways, const std::vector<Vec3>& seam,
                         double depth) {
  std::vector<double> arc(seam.size(), 0);
  for (std::size_t i = 1; i < seam.size(); ++i) {
    arc[i] = arc[i - 1] + (seam[i] - seam[i - 1]).norm();
  }
  std::vector<Vec3> even(seam.size(), Vec3::Zero());
  for (std::size_t i = 0; i < seam.size(); ++i) {
    for (std::size_t j = 0; j < seam.size(); ++j) {
      const double length = arc[std::min(j + 1, seam.size() - 1)] - arc[j == 0 ? 0 : j - 1];
      const double far = (arc[i] - arc[j]) / depth;
      even[i] += length * std::exp(-0.5 * far * far) * ways[j];
    }
    even[i].normalize();
  }
  return even;
}

/// The directions in which a panel hangs: the fan of the flat panel, as far as a plane has room for
/// it. Where the seam itself bends more than that, they are square to the seam.
class WaysDown {
 public:
  WaysDown(const Vec3& facing, const UpperSeam& seam, double depth)
      : ways_(evened(square_ways(facing, seam.at), seam.at, depth)), turned_(turns(seam.flat)) {
    for (const Vec3& way : ways_) middle_ += way;
    middle_.normalize();
    left_ = facing.cross(middle_);
    const double bends = std::abs(angle(ways_.back()) - angle(ways_.front()));
    const double whole = std::abs(turned_.back());
    const double opening = std::min(whole, max_fan);
    if (opening > bends) share_ = opening / whole;
  }

  const Vec3& middle() const { return middle_; }
  Vec3 at(const Foot& foot) const {
    if (share_ == 0) {
      return ((1 - foot.share) * ways_[foot.segment] + foot.share * ways_[foot.segment + 1])
          .normalized();
    }
    const double turn = share_ * (turned_[foot.segment] + foot.aside - 0.5 * turned_.back());
    return std::cos(turn) * middle_ + std::sin(turn) * left_;
  }

 private:
  double angle(const Vec3& way) const { return std::atan2(way.dot(left_), way.dot(middle_)); }

  std::vector<Vec3> ways_;  // at each point of the seam
  std::vector<double> turned_;
  Vec3 middle_ = Vec3::Zero();
  Vec3 left_ = Vec3::Zero();
  double share_ = 0;  // of the flat panel's fan; 0: the ways are those of the seam
};

/// Per panel, whether it hangs. Skirts do. Of a skirt alone, its uppermost panels hold the others.
std::vector<bool> hanging_panels(const PanelMesh& garment) {
  std::vector<double> tops;
  std::vector<bool> hangs;
  for (const MeshedPanel& panel : garment.panels) {
    double top = -std::numeric_limits<double>::infinity();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      top = std::max(top, garment.placed[p].y());
    }
    tops.push_back(top);
    hangs.push_back(panel.is.worn_as == PanelRole::skirt && !panel.placement.by_part());
  }
  if (std::ranges::count(hangs, false) > 0) return hangs;
  const double top = *std::ranges::max_element(tops);
  for (std::size_t p = 0; p < hangs.size(); ++p) hangs[p] = tops[p] < top - top_slack;
  return hangs;
}

class HangingPanels {
 public:
  HangingPanels(const TriangleMesh& body, PanelMesh& garment)
      : body_(body),
        garment_(garment),
        panel_of_(panel_of_points(garment)),
        hangs_(hanging_panels(garment)),
        facing_(garment.panels.size()),
        border_(garment.panels.size()),
        place_on_border_(garment.flat.size(), -1) {
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      facing_[p] = facing_of(triangles(p), garment.placed).vectors.normalized();
      for (std::vector<int>& loop : border_loops(triangles(p), garment.flat.size())) {
        if (loop.size() > border_[p].size()) border_[p] = std::move(loop);
      }
      for (std::size_t i = 0; i < border_[p].size(); ++i) {
        place_on_border_[border_[p][i]] = static_cast<int>(i);
      }
    }
  }

  void run() {
    for (std::vector<std::size_t> wave = next_wave(); !wave.empty(); wave = next_wave()) {
      const std::vector<bool> is_gore = gores();
      for (const std::size_t p : wave) {
        if (is_gore[p]) continue;
        if (const std::optional<UpperSeam> seam = upper_seam(p)) hang(p, *seam);
      }
      for (const std::size_t p : wave) hangs_[p] = false;
    }
  }

 private:
  std::vector<Triangle> triangles(std::size_t p) const {
    const MeshedPanel& panel = garment_.panels[p];
    const auto first = garment_.triangles.begin() + panel.first_triangle;
    return {first, first + panel.triangles};
  }

  /// Whether panel p may hang from panel q. One that the skeleton will position is not there yet.
  bool may_hold(std::size_t q, std::size_t p) const {
    return !hangs_[q] && !garment_.panels[q].placement.by_part() &&
           facing_[q].dot(facing_[p]) > same_facing;
  }

  /// The panels that hang from those that no longer move.
  std::vector<std::size_t> next_wave() const {
    std::vector<bool> held(hangs_.size(), false);
    for_sewn_panels([&](std::size_t p, std::size_t q) {
      if (hangs_[p] && may_hold(q, p)) held[p] = true;
    });
    std::vector<std::size_t> wave;
    for (std::size_t p = 0; p < held.size(); ++p) {
      if (held[p]) wave.push_back(p);
    }
    return wave;
  }

  /// Calls `with` for both orders of each pair of panels that a seam joins.
  template <typename With>
  void for_sewn_panels(const With& with) const {
    for (const MeshedSeam& seam : garment_.seams) {
      const auto a = static_cast<std::size_t>(panel_of_[seam.a[1]]);
      const auto b = static_cast<std::size_t>(panel_of_[seam.b[1]]);
      with(a, b);
      with(b, a);
    }
  }

  /// Per panel that hangs, whether it is a gore: it lies beside others that hang at its level, and
  /// does not face away from them. Together they are the fan.
  std::vector<bool> gores() const {
    std::vector<bool> at_level(hangs_.size(), false);
    for_sewn_panels([&](std::size_t p, std::size_t q) {
      if (hangs_[p] && !hangs_[q]) at_level[p] = true;
    });
    std::vector<bool> gores(hangs_.size(), false);
    for_sewn_panels([&](std::size_t p, std::size_t q) {
      if (p != q && at_level[p] && at_level[q] && facing_[p].dot(facing_[q]) > -same_facing) {
        gores[p] = true;
      }
    });
    return gores;
  }

  /// The points of panel p that are sewn to panels that hold it, each with its partners.
  std::map<int, std::vector<int>> held_points(std::size_t p) const {
    std::map<int, std::vector<int>> partners;
    const auto take = [&](int own, int other) {
      const auto q = static_cast<std::size_t>(panel_of_[other]);
      if (panel_of_[own] == static_cast<int>(p) && may_hold(q, p)) partners[own].push_back(other);
    };
    for (const MeshedSeam& seam : garment_.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        take(seam.a[i], seam.b[i]);
        take(seam.b[i], seam.a[i]);
      }
    }
    return partners;
  }

  /// How often the other side of a seam goes on against the outline of its panel, less how often
  /// it goes on along it. Two panels that lie side by side go along their seam in opposite ways.
  int steps_against(const std::vector<int>& others) const {
    int steps = 0;
    for (std::size_t i = 0; i + 1 < others.size(); ++i) {
      const int from = others[i];
      const int to = others[i + 1];
      if (panel_of_[from] != panel_of_[to]) continue;
      if (place_on_border_[from] < 0 || place_on_border_[to] < 0) continue;
      const auto n = static_cast<int>(border_[panel_of_[from]].size());
      if (place_on_border_[from] == (place_on_border_[to] + 1) % n) ++steps;
      if (place_on_border_[to] == (place_on_border_[from] + 1) % n) --steps;
    }
    return steps;
  }

  std::optional<UpperSeam> upper_seam(std::size_t p) const {
    const std::map<int, std::vector<int>> partners = held_points(p);
    const std::vector<int>& border = border_[p];
    const std::size_t n = border.size();
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < n; ++i) {
      if (partners.contains(border[i]) && !partners.contains(border[(i + n - 1) % n])) {
        begins.push_back(i);
      }
    }
    if (n == 0 || begins.size() != 1) return std::nullopt;
    UpperSeam seam;
    std::vector<int> others;
    double open = 0;
    for (std::size_t i = begins.front(); partners.contains(border[i % n]); ++i) {
      const std::vector<int>& sewn = partners.at(border[i % n]);
      Vec3 sum = Vec3::Zero();
      for (const int other : sewn) sum += garment_.placed[other];
      seam.flat.push_back(garment_.flat[border[i % n]]);
      seam.at.push_back(sum / static_cast<double>(sewn.size()));
      others.push_back(sewn.front());
      seam.own.push_back(garment_.placed[border[i % n]]);
      open += (seam.own.back() - seam.at.back()).norm();
    }
    if (seam.at.size() < 3 || steps_against(others) <= 0) return std::nullopt;
    const bool stands_well = open < near_seam * static_cast<double>(seam.at.size());
    if (stands_well || has_corner(seam.flat)) return std::nullopt;
    return seam;
  }

  void hang(std::size_t p, const UpperSeam& seam) {
    const MeshedPanel& panel = garment_.panels[p];
    std::vector<Foot> feet;
    double depth = 0;
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      feet.push_back(foot_on(seam.flat, garment_.flat[i]));
      depth = std::max(depth, feet.back().away);
    }
    const WaysDown down(facing_[p], seam, depth);
    if (!hangs_as_placed(panel, seam, down.middle())) return;
    const auto first = garment_.placed.begin() + panel.first_point;
    const std::vector<Vec3> before(first, first + panel.points);
    for (int i = 0; i < panel.points; ++i) {
      const Foot& foot = feet[i];
      const Vec3& from = seam.at[foot.segment];
      const Vec3& to = seam.at[foot.segment + 1];
      const Vec3 way = down.at(foot);
      garment_.placed[panel.first_point + i] =
          from + foot.share * (to - from) + foot.away * way + foot.beyond * way.cross(facing_[p]);
    }
    if (!intersections({garment_.placed, triangles(p)}, body_).empty()) {
      std::ranges::copy(before, first);
    }
  }

  /// Whether a panel would hang down, and the same way up as the pattern places it. One that is
  /// sewn by its hem stays, for others to find.
  bool hangs_as_placed(const MeshedPanel& panel, const UpperSeam& seam, const Vec3& down) const {
    Vec3 middle = Vec3::Zero();
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      middle += garment_.placed[i] / panel.points;
    }
    Vec3 top = Vec3::Zero();
    for (const Vec3& p : seam.own) top += p / static_cast<double>(seam.own.size());
    return -down.y() > same_facing && down.dot(middle - top) > 0;
  }

  const TriangleMesh& body_;
  PanelMesh& garment_;
  std::vector<int> panel_of_;
  std::vector<bool> hangs_;  // per panel, whether it has still to hang
  std::vector<Vec3> facing_;
  std::vector<std::vector<int>> border_;  // per panel, the points of its outline
  std::vector<int> place_on_border_;      // per material point; -1: it is not on it
};

}  // namespace

void hang_from_seams(const TriangleMesh& body, PanelMesh& garment) {
  if (!garment.panels.empty()) HangingPanels(body, garment).run();
}

}  // namespace toile
