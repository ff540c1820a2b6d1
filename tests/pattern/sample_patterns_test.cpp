// Every sample pattern as a tailor would check it on the table. Seams match, finished edges run on
// smoothly across a seam, and the measures are those that samples/README.md states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <numeric>

#include "pattern/check/check_pattern.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"
#include "pattern/mesh/seam_orientation.h"
#include "sewn.h"

namespace toile {
namespace sample_patterns_test {

/// A panel, or with a leading '_' all whose names end so, measured across the drawing at a height:
/// darts left out.
struct Width {
  std::string panels;
  double height;    ///< cm, in the drawing
  double expected;  ///< cm, of all these panels together
};

struct Sample {
  std::string name;
  int panels;
  int seams;
  double turn;                   ///< degrees that a finished edge may turn at a seam
  std::vector<double> openings;  ///< cm, the lengths of the borders left when all is sewn, rising
  std::vector<Width> widths;
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) { return out << sample.name; }

const std::vector<Sample>& all_samples() {
  static const std::vector<Sample> samples = {
      {"tshirt",
       8,
       14,
       16,
       {37.4, 37.4, 48.6, 106.0},
       {{"_front", 41.5, 52.0}, {"_back", 41.5, 52.0}}},
      {"fitted_tshirt",
       8,
       14,
       16,
       {37.4, 37.4, 48.6, 83.2},
       {{"_front", 41.5, 52.0}, {"_back", 41.5, 52.0}, {"_front", 18, 39.7}, {"_back", 18, 39.7}}},
      {"walking_dress",
       4,
       6,
       5,
       {49, 49, 52, 157.6},
       {{"_front", 72, 51.77}, {"_back", 72, 51.77}, {"_front", 34, 66.55}, {"_back", 34, 66.55}}},
      {"trousers",
       4,
       18,
       5,
       {40, 40, 73.8},
       {{"_front", 86, 48.63},
        {"_back", 86, 52.14},
        {"_front", 73, 57.02},
        {"_back", 73, 70.12},
        {"_front", 46, 41},
        {"_back", 46, 48}}},
      {"jacket",
       6,
       12,
       5,
       {26.13, 26.13, 55.31, 111.28},
       {{"_front", 40, 53.06},
        {"_back", 40, 51.52},
        {"_front", 25, 51.66},
        {"_back", 25, 50.24},
        {"_front", 6, 54.45},
        {"_back", 6, 54.04},
        {"left_sleeve", 0, 41.38}}},
      {"bodice_dress",
       10,
       32,
       5,
       {43.34, 43.34, 64.33, 136.83},
       {{"front", 18.2, 16},
        {"left_side_front", 0, 18.05},
        {"left_back", 18.2, 23.61},
        {"front", 0.01, 13.4},
        {"skirt_front", 37.5, 20},
        {"left_skirt_side", 37.5, 16.3},
        {"left_skirt_back", 37.5, 26}}},
      {"band", 2, 2, 1, {72.66, 102}, {}},
      {"band_small", 2, 2, 1, {63.59, 88.2}, {}},
      {"gathered_skirt", 4, 6, 1, {74, 148}, {}},
      {"elastic_skirt", 2, 2, 1, {120, 120}, {}},
      {"tube_top", 2, 2, 1, {100, 100}, {}},
  };
  return samples;
}

/// A sample, read and oriented; corners are numbered across panels, sewn ones as one.
class Draft {
 public:
  explicit Draft(const std::string& name) {
    pattern = read_pattern(TOILE_SOURCE_DIR "/samples/" + name + ".json", remarks);
    check_pattern(pattern, remarks);
    const Orientation orientation = orient(pattern, remarks);
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
      first_.push_back(static_cast<int>(parent_.size()));
      for (std::size_t e = 0; e < pattern.panels[p].edges.size(); ++e) {
        parent_.push_back(static_cast<int>(parent_.size()));
      }
    }
    for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
      const Stitch& stitch = pattern.stitches[s];
      sewn_[{stitch.a.panel, stitch.a.edge}] = true;
      sewn_[{stitch.b.panel, stitch.b.edge}] = true;
      const bool reversed = orientation.reversed[s];
      join(corner(stitch.a, false), corner(stitch.b, reversed));
      join(corner(stitch.a, true), corner(stitch.b, !reversed));
    }
  }

  bool sewn(const EdgeRef& ref) const { return sewn_.contains({ref.panel, ref.edge}); }

  const EdgeCurve& curve(const EdgeRef& ref) const {
    return pattern.panels[static_cast<std::size_t>(ref.panel)]
        .edges[static_cast<std::size_t>(ref.edge)]
        .curve;
  }

  /// The corner at an edge's start or end, before sewing: the place in the outline of the step that
  /// begins there.
  int corner(const EdgeRef& ref, bool end) const {
    const auto& outline = pattern.panels[static_cast<std::size_t>(ref.panel)].outline;
    const auto step = std::find_if(outline.begin(), outline.end(),
                                   [&](const OutlineStep& s) { return s.edge == ref.edge; });
    const auto place = step - outline.begin() + (step->forward == end ? 1 : 0);
    return first_[static_cast<std::size_t>(ref.panel)] +
           static_cast<int>(place % static_cast<std::ptrdiff_t>(outline.size()));
  }

  int root(int corner) const {
    while (parent_[static_cast<std::size_t>(corner)] != corner) {
      corner = parent_[static_cast<std::size_t>(corner)];
    }
    return corner;
  }

  /// One corner of a panel.
  struct Corner {
    int root;      ///< the sewn corner that it belongs to
    double angle;  ///< degrees that the cloth fills there
    int finished;  ///< how many of its two edges are finished, not sewn
    std::string place;
  };

  std::vector<Corner> corners() const {
    std::vector<Corner> result;
    for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
      const PatternPanel& panel = pattern.panels[static_cast<std::size_t>(p)];
      const std::size_t n = panel.outline.size();
      double area = 0;
      for (const OutlineStep& step : panel.outline) {
        const std::vector<Vec2> points =
            panel.edges[static_cast<std::size_t>(step.edge)].curve.sample(16);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          const double cross =
              points[i].x() * points[i + 1].y() - points[i].y() * points[i + 1].x();
          area += step.forward ? cross : -cross;
        }
      }
      for (std::size_t i = 0; i < n; ++i) {
        const OutlineStep& in = panel.outline[(i + n - 1) % n];
        const OutlineStep& out = panel.outline[i];
        const auto direction = [&](const OutlineStep& step, bool leaving) {
          const EdgeCurve& c = panel.edges[static_cast<std::size_t>(step.edge)].curve;
          constexpr double little = 1e-4;
          const bool at_start = step.forward == leaving;
          const Vec2 chord = at_start ? c.at(little) - c.start() : c.at(1 - little) - c.end();
          return std::atan2(chord.y(), chord.x());
        };
        double angle = (direction(in, false) - direction(out, true)) * (area > 0 ? 1 : -1);
        angle = std::fmod(angle * 180 / std::numbers::pi + 720, 360);
        const EdgeRef in_ref{p, in.edge};
        const EdgeRef out_ref{p, out.edge};
        result.push_back({root(first_[static_cast<std::size_t>(p)] + static_cast<int>(i)), angle,
                          !sewn(in_ref) + !sewn(out_ref), edge_name(pattern, out_ref)});
      }
    }
    return result;
  }

  /// The lengths of the borders left when all seams are sewn, in cm, rising.
  std::vector<double> openings() const {
    std::map<int, int> loop;  // a sewn corner to another one of its border
    const auto end_of = [&](int c) {
      while (loop.contains(c) && loop[c] != c) c = loop[c];
      return c;
    };
    std::map<int, double> length;
    for (const bool measure : {false, true}) {
      for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
        for (int e = 0;
             e < static_cast<int>(pattern.panels[static_cast<std::size_t>(p)].edges.size()); ++e) {
          if (sewn({p, e})) continue;
          const int a = end_of(root(corner({p, e}, false)));
          const int b = end_of(root(corner({p, e}, true)));
          if (measure) {
            length[a] += curve({p, e}).length() * 100;
          } else {
            loop[std::max(a, b)] = std::min(a, b);
          }
        }
      }
    }
    std::vector<double> result;
    for (const auto& [corner, sum] : length) result.push_back(sum);
    std::sort(result.begin(), result.end());
    return result;
  }

  /// In cm.
  double width(const Width& wanted) const {
    double sum = 0;
    for (const PatternPanel& panel : pattern.panels) {
      const bool all_ending_so = wanted.panels.starts_with('_');
      if (all_ending_so ? !panel.name.ends_with(wanted.panels) : panel.name != wanted.panels)
        continue;
      std::vector<double> crossings;
      const double y = wanted.height / 100 + 1e-7;  // beside a corner, not through it
      for (const PatternEdge& edge : panel.edges) {
        const std::vector<Vec2> points = edge.curve.sample(200);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          const Vec2& a = points[i];
          const Vec2& b = points[i + 1];
          if ((a.y() < y) == (b.y() < y)) continue;
          crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        sum += (crossings[i + 1] - crossings[i]) * 100;
      }
    }
    return sum;
  }

  Pattern pattern;
  std::vector<Remark> remarks;

 private:
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

  std::vector<int> first_;  ///< of each panel's corners
  std::vector<int> parent_;
  std::map<std::array<int, 2>, bool> sewn_;
};

class SamplePatterns : public testing::TestWithParam<Sample> {};

TEST_P(SamplePatterns, AreReadCheckedAndMeshedWithoutARemark) {
  Draft draft(GetParam().name);
  EXPECT_EQ(static_cast<int>(draft.pattern.panels.size()), GetParam().panels);
  EXPECT_EQ(static_cast<int>(draft.pattern.stitches.size()), GetParam().seams);
  const PanelMesh mesh = mesh_panels(draft.pattern, {.edge_length = 0.015}, draft.remarks);
  for (const Remark& remark : draft.remarks) ADD_FAILURE() << remark.text;
  for (int coarser = 0; coarser <= mesh.subdivisions; ++coarser) {
    EXPECT_EQ(samples::sewn_fault(mesh, coarser), "") << coarser << " levels coarser";
  }
}

TEST_P(SamplePatterns, HaveSeamsWhoseSidesAgree) {
  const Draft draft(GetParam().name);
  double worst = 0;
  for (const Stitch& stitch : draft.pattern.stitches) {
    if (stitch.gathered) continue;
    const double off = std::abs(draft.curve(stitch.a).length() - draft.curve(stitch.b).length());
    EXPECT_LT(off, 0.0015) << stitch.name;
    worst = std::max(worst, off);
  }
  std::cout << GetParam() << ": seam sides differ by at most " << worst * 1000 << " mm\n";
}

// A hem, neckline or armhole that is not square to its seams has a peak or a notch there.
TEST_P(SamplePatterns, HaveFinishedEdgesThatRunOnAcrossSeams) {
  const Draft draft(GetParam().name);
  std::map<int, std::vector<Draft::Corner>> sewn;
  for (const Draft::Corner& corner : draft.corners()) sewn[corner.root].push_back(corner);
  double worst = 0;
  for (const auto& [root, met] : sewn) {
    int finished = 0;
    double sum = 0;
    for (const Draft::Corner& corner : met) {
      finished += corner.finished;
      sum += corner.angle;
    }
    if (finished != 2 || met.size() < 2) continue;
    EXPECT_NEAR(sum, 180, GetParam().turn) << met[0].place << " and what is sewn to it";
    worst = std::max(worst, std::abs(sum - 180));
  }
  std::cout << GetParam() << ": finished edges turn by at most " << worst << " degrees at a seam\n";
}

TEST_P(SamplePatterns, MeasureWhatTheirTableSays) {
  const Draft draft(GetParam().name);
  const std::vector<double> openings = draft.openings();
  ASSERT_EQ(openings.size(), GetParam().openings.size());
  for (std::size_t i = 0; i < openings.size(); ++i) {
    EXPECT_NEAR(openings[i], GetParam().openings[i], 0.06) << "opening " << i;
  }
  for (const Width& width : GetParam().widths) {
    EXPECT_NEAR(draft.width(width), width.expected, 0.06)
        << width.panels << " at " << width.height << " cm";
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SamplePatterns, testing::ValuesIn(all_samples()),
                         [](const auto& sample) { return sample.param.name; });

}  // namespace sample_patterns_test
}  // namespace toile
