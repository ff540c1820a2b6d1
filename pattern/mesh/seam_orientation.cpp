#include "pattern/mesh/seam_orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon.h"
#include "pattern/classify/classify.h"
#include "pattern/constants.h"

namespace toile {

namespace {

/// A panel as orientation needs it.
struct DrawnFace {
  double area = 0;                   ///< m², as drawn; positive when counter-clockwise
  Vec2 drawn_centre = Vec2::Zero();  ///< metres, of its outline as drawn
  Vec3 centre = Vec3::Zero();        ///< metres, of its outline as placed
  Vec3 normal = Vec3::UnitZ();       ///< of the drawing's front as placed
  std::vector<bool> forward;         ///< per edge: whether the outline runs along it
};

DrawnFace face_of(const PatternPanel& panel) {
  DrawnFace face;
  face.forward.resize(panel.edges.size());
  std::vector<Vec2> outline;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[step.edge].curve;
    face.forward[step.edge] = step.forward;
    constexpr int segments = 8;
    for (int i = 0; i < segments; ++i) {
      const double fraction = static_cast<double>(i) / segments;
      outline.push_back(curve.at(step.forward ? fraction : 1 - fraction));
      face.drawn_centre += outline.back();
      face.centre += panel.place(outline.back());
    }
  }
  face.drawn_centre /= static_cast<double>(outline.size());
  face.centre /= static_cast<double>(outline.size());
  face.area = signed_area(outline);
  face.normal = panel.rotation.col(2);
  return face;
}

/// A stitch as orientation needs it.
struct SeamRun {
  bool reversed = false;
  bool stated = false;
  /// Metres: the sum of the placed end points' distances, the other way round less this way.
  double nearer = 0;
  bool layered = false;  ///< one panel lies upon the other, facing the same way
  bool along = false;    ///< the edges run alike around their panels, both seen from the right side
};

SeamRun run_of(const Pattern& pattern, const Stitch& stitch, const std::vector<DrawnFace>& faces) {
  const PatternPanel& a = pattern.panels[stitch.a.panel];
  const PatternPanel& b = pattern.panels[stitch.b.panel];
  const EdgeCurve& edge_a = a.edges[stitch.a.edge].curve;
  const EdgeCurve& edge_b = b.edges[stitch.b.edge].curve;
  const Vec3 a_start = a.place(edge_a.start());
  const Vec3 a_end = a.place(edge_a.end());
  const Vec3 b_start = b.place(edge_b.start());
  const Vec3 b_end = b.place(edge_b.end());
  const double same = (a_start - b_start).norm() + (a_end - b_end).norm();
  const double opposite = (a_start - b_end).norm() + (a_end - b_start).norm();
  SeamRun run;
  run.stated = stitch.direction != StitchDirection::by_position;
  run.reversed = run.stated ? stitch.direction == StitchDirection::end_to_start
                            : opposite <= same + undecided_seam_direction * (same + opposite);
  run.nearer = run.reversed ? same - opposite : opposite - same;
  const auto counter_clockwise = [&](const EdgeRef& ref) {
    const DrawnFace& face = faces[ref.panel];
    return face.forward[ref.edge] == (face.area > 0);
  };
  run.layered = stitch.layered;
  run.along = counter_clockwise(stitch.a) == counter_clockwise(stitch.b);
  return run;
}

/// Panels in groups, and within a group whether a panel shows the same face as the group's lowest.
class FaceGroups {
 public:
  explicit FaceGroups(std::size_t panels) : parent_(panels), turned_(panels, false) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int group(int panel) const {
    while (parent_[panel] != panel) panel = parent_[panel];
    return panel;
  }

  bool turned(int panel) const {
    bool turned = false;
    for (; parent_[panel] != panel; panel = parent_[panel]) turned ^= turned_[panel];
    return turned;
  }

  /// Joins the groups of two panels that show the same face or not. False: they are in one group,
  /// and it says otherwise.
  bool join(int a, int b, bool same) {
    const int root_a = group(a);
    const int root_b = group(b);
    const bool turned_b = turned(a) ^ turned(b) ^ !same;
    if (root_a == root_b) return !turned_b;
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    turned_[std::max(root_a, root_b)] = turned_b;
    return true;
  }

 private:
  std::vector<int> parent_;
  std::vector<bool> turned_;  ///< per panel: against its parent
};

/// Whether the panels of a seam show the same face. A seam joins right to right when its edges run
/// against each other around their panels, both seen from the right side.
/// Panels that lie upon each other face the same way where they run side by side.
bool shows_same(const SeamRun& run) { return (run.along == run.reversed) != run.layered; }

/// Numbers of the stitches: stated ones first, and the ones nearer than the other way round first.
std::vector<std::size_t> by_certainty(const std::vector<SeamRun>& runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t s, std::size_t t) {
    if (runs[s].stated != runs[t].stated) return runs[s].stated;
    return runs[s].nearer > runs[t].nearer;
  });
  return order;
}

/// Turns over what stated seams hold together, as long as that brings the other seams' ends nearer.
void bring_nearer(const Pattern& pattern, const FaceGroups& held, std::vector<SeamRun>& runs) {
  // Each turn makes the sum of distances smaller, so this ends; the bound is for safety.
  for (std::size_t turns = 0; turns < pattern.panels.size(); ++turns) {
    std::vector<double> gain(pattern.panels.size(), 0);
    const auto ends = [&](std::size_t s) {
      const Stitch& stitch = pattern.stitches[s];
      return std::array{held.group(stitch.a.panel), held.group(stitch.b.panel)};
    };
    for (std::size_t s = 0; s < runs.size(); ++s) {
      const auto [a, b] = ends(s);
      if (a == b) continue;
      gain[a] -= runs[s].nearer;
      gain[b] -= runs[s].nearer;
    }
    const auto best = std::max_element(gain.begin(), gain.end());
    if (*best < 1e-9) return;
    const int turned = static_cast<int>(best - gain.begin());
    for (std::size_t s = 0; s < runs.size(); ++s) {
      const auto [a, b] = ends(s);
      if ((a == turned) == (b == turned)) continue;
      runs[s].reversed = !runs[s].reversed;
      runs[s].nearer = -runs[s].nearer;
    }
  }
}

/// What the names of left and right halves say of a group of panels, mirrored as given. Positive:
/// they show their wrong sides; negative: their right sides; 0: nothing. Of a front that is seen
/// from outside, the left half lies to the right of the seam to the right half. Drawings are taken
/// as upright.
double inside_out_by_names(const Pattern& pattern, const std::vector<DrawnFace>& faces,
                           const std::vector<bool>& mirrored, const std::vector<int>& group) {
  double sum = 0;
  const auto is = [&](int p) { return classify(witnesses_of(pattern.panels[p])); };
  for (const Stitch& stitch : pattern.stitches) {
    if (std::ranges::find(group, stitch.a.panel) == group.end()) continue;
    const int face = face_sign(is(stitch.a.panel));
    if (face == 0 || face != face_sign(is(stitch.b.panel))) continue;
    const int side = side_sign(is(stitch.a.panel));
    if (side == 0 || side != -side_sign(is(stitch.b.panel))) continue;
    for (const auto& [ref, own] : {std::pair(stitch.a, side), std::pair(stitch.b, -side)}) {
      const EdgeCurve& edge = pattern.panels[ref.panel].edges[ref.edge].curve;
      const double aside = faces[ref.panel].drawn_centre.x() - edge.at(0.5).x();
      sum -= own * face * (mirrored[ref.panel] ? -aside : aside) * edge.length();
    }
  }
  return std::abs(sum) > undecided_halves ? sum : 0;
}

}  // namespace

Orientation orient(const Pattern& pattern, std::vector<Remark>& remarks) {
  std::vector<DrawnFace> faces;
  for (const PatternPanel& panel : pattern.panels) faces.push_back(face_of(panel));
  std::vector<SeamRun> runs;
  const bool placed = has_places(pattern);
  for (const Stitch& stitch : pattern.stitches) {
    runs.push_back(run_of(pattern, stitch, faces));
    // Drawings that lie upon each other are near to each other by chance.
    if (!placed && !runs.back().stated) {
      runs.back().reversed = true;
      runs.back().nearer = 0;
    }
  }

  FaceGroups groups(pattern.panels.size());
  FaceGroups held(pattern.panels.size());
  std::vector<int> twisted;  // panels of seams that can't join right to right
  for (const std::size_t s : by_certainty(runs)) {
    const Stitch& stitch = pattern.stitches[s];
    SeamRun& run = runs[s];
    if (run.stated) held.join(stitch.a.panel, stitch.b.panel, shows_same(run));
    if (groups.join(stitch.a.panel, stitch.b.panel, shows_same(run))) continue;
    if (!run.stated) {
      run.reversed = !run.reversed;
      run.nearer = -run.nearer;
      continue;
    }
    twisted.push_back(stitch.a.panel);
    remarks.push_back({true, pattern.source + ": " + edge_name(pattern, stitch.a) + " and " +
                                 edge_name(pattern, stitch.b) +
                                 " join a right side to a wrong side; state \"reversed\": " +
                                 (run.reversed ? "false" : "true") +
                                 " in the stitch, or check the other seams of these panels"});
  }
  bring_nearer(pattern, held, runs);

  Orientation result;
  FaceGroups faced(pattern.panels.size());
  for (const std::size_t s : by_certainty(runs)) {
    const Stitch& stitch = pattern.stitches[s];
    faced.join(stitch.a.panel, stitch.b.panel, shows_same(runs[s]));
  }
  for (const SeamRun& run : runs) result.reversed.push_back(run.reversed);

  result.mirrored.assign(pattern.panels.size(), false);
  for (int first = 0; first < static_cast<int>(pattern.panels.size()); ++first) {
    if (faced.group(first) != first) continue;
    std::vector<int> group;
    for (int p = first; p < static_cast<int>(pattern.panels.size()); ++p) {
      if (faced.group(p) != first) continue;
      group.push_back(p);
      result.mirrored[p] = faced.turned(p);
    }
    const bool one_sided =
        std::any_of(twisted.begin(), twisted.end(), [&](int p) { return faced.group(p) == first; });
    double outward = 0;
    double drawn = 0;
    double scale = 0;
    Vec3 centre = Vec3::Zero();
    double area = 0;
    for (const int p : group) {
      centre += std::abs(faces[p].area) * faces[p].centre;
      area += std::abs(faces[p].area);
    }
    centre /= area;
    for (const int p : group) {
      const DrawnFace& face = faces[p];
      const double sign = result.mirrored[p] ? -1 : 1;
      outward += sign * std::abs(face.area) * face.normal.dot(face.centre - centre);
      scale += std::abs(face.area) * (face.centre - centre).norm();
      drawn += sign * face.area;
    }
    bool flip = outward < 0;
    if (!(std::abs(outward) > undecided_right_side * scale)) {
      const double named = inside_out_by_names(pattern, faces, result.mirrored, group);
      flip = named != 0 ? named > 0 : drawn < 0;
    }
    for (const int p : group) {
      if (one_sided) {
        result.mirrored[p] = faces[p].area < 0;
      } else if (flip) {
        result.mirrored[p] = !result.mirrored[p];
      }
    }
  }
  return result;
}

}  // namespace toile
