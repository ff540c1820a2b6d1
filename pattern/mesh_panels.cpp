#include "pattern/mesh_panels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/error.h"
#include "geometry/mesh_polygon.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"
#include "pattern/constants.h"
#include "pattern/doubled_triangles.h"
#include "pattern/seam_orientation.h"
#include "pattern/seam_steps.h"

namespace toile {

namespace {

/// A panel that cannot be meshed with as many subdivisions, and why.
struct Unmeshable {
  std::string panel;  ///< "panel 'front'", and its edge where one is at fault
  std::string problem;
  std::vector<int> edges = {};  ///< those that shorter steps may help, indices in the panel
  std::size_t index = 0;        ///< of the panel
};

std::string quoted(const PatternPanel& panel) { return "panel '" + panel.name + "'"; }

/// The mesh of one panel. Indices count the points of this panel.
struct PanelTriangulation {
  PlanarMesh mesh;
  std::vector<std::vector<int>> along;  ///< per edge, points from its start to its end
  int coarse_border = 0;                ///< border points of the coarsest level; they come first
};

/// Per panel, points of its coarse outline that need an interior point in the triangle with their
/// two neighbours on the outline.
using Corners = std::vector<std::vector<int>>;

class PanelMesher {
 public:
  PanelMesher(const PatternPanel& panel, bool mirrored) : panel_(panel), mirrored_(mirrored) {}

  PanelTriangulation mesh(const std::vector<int>& steps, double coarse_length, int subdivisions,
                          const std::vector<int>& split_corners) {
    steps_ = steps;
    const std::vector<Vec2> outline = coarse_outline();
    if (outline.size() < 3) throw Unmeshable{quoted(panel_), "has too few border points"};
    if (first_crossing(outline)) {
      throw Unmeshable{quoted(panel_), "has an outline that crosses itself"};
    }
    triangulation_.coarse_border = static_cast<int>(outline.size());
    try {
      triangulation_.mesh = mesh_polygon(outline, coarse_length, split_corners);
    } catch (const Error&) {
      throw Unmeshable{quoted(panel_), "can't be triangulated"};
    }
    for (int level = 0; level < subdivisions; ++level) subdivide();
    if (smallest_angle(triangulation_.mesh.points, triangulation_.mesh.triangles) < needle_angle) {
      const SharpPlace place = sharpest_place();
      const std::string edge = place.edge < 0 ? "" : ", edge " + std::to_string(place.edge);
      throw Unmeshable{quoted(panel_) + edge, "gets triangles like needles", place.long_steps};
    }
    return std::move(triangulation_);
  }

 private:
  /// The edges of the panel at the sharpest triangle.
  struct SharpPlace {
    int edge = -1;                ///< that most of its corners lie on; -1: it is at none
    std::vector<int> long_steps;  ///< edges that it touches, of steps no shorter than half of it
  };

  SharpPlace sharpest_place() const {
    const PlanarMesh& mesh = triangulation_.mesh;
    const auto angle = [&](const Triangle& t) {
      return smallest_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    };
    const Triangle sharpest = *std::min_element(
        mesh.triangles.begin(), mesh.triangles.end(),
        [&](const Triangle& s, const Triangle& t) { return angle(s) < angle(t); });
    const auto length = [&](int a, int b) { return (mesh.points[a] - mesh.points[b]).norm(); };
    const double longest =
        std::max({length(sharpest[0], sharpest[1]), length(sharpest[1], sharpest[2]),
                  length(sharpest[2], sharpest[0])});
    SharpPlace place;
    std::size_t most = 0;
    for (std::size_t e = 0; e < triangulation_.along.size(); ++e) {
      const std::vector<int>& along = triangulation_.along[e];
      std::vector<int> corners;
      for (const int p : along) {
        if (std::ranges::find(sharpest, p) != sharpest.end()) corners.push_back(p);
      }
      if (corners.size() > most) {
        most = corners.size();
        place.edge = static_cast<int>(e);
      }
      if (corners.empty()) continue;
      double whole = 0;
      for (std::size_t i = 0; i + 1 < along.size(); ++i) whole += length(along[i], along[i + 1]);
      const double step = whole / static_cast<double>(along.size() - 1);
      if (step >= 0.5 * longest) place.long_steps.push_back(static_cast<int>(e));
    }
    return place;
  }

  Vec2 flat(const Vec2& drawn) const { return {mirrored_ ? -drawn.x() : drawn.x(), drawn.y()}; }

  /// The outline's walk, turned so that it runs counter-clockwise in flat coordinates.
  std::vector<OutlineStep> walk() const {
    std::vector<Vec2> points;
    for (const OutlineStep& step : panel_.outline) {
      std::vector<Vec2> sample = panel_.edges[step.edge].curve.sample(8 * steps_[step.edge]);
      if (!step.forward) std::reverse(sample.begin(), sample.end());
      for (const Vec2& point : sample) points.push_back(flat(point));
    }
    std::vector<OutlineStep> steps = panel_.outline;
    if (signed_area(points) < 0) {
      std::reverse(steps.begin(), steps.end());
      for (OutlineStep& step : steps) step.forward = !step.forward;
    }
    return steps;
  }

  std::vector<Vec2> coarse_outline() {
    std::vector<Vec2> outline;
    triangulation_.along.assign(panel_.edges.size(), {});
    const std::vector<OutlineStep> steps = walk();
    for (const OutlineStep& step : steps) {
      const int count = steps_[step.edge];
      std::vector<Vec2> sample = panel_.edges[step.edge].curve.sample(count);
      if (!step.forward) std::reverse(sample.begin(), sample.end());
      for (int i = 0; i < count; ++i) {
        triangulation_.along[step.edge].push_back(static_cast<int>(outline.size()));
        outline.push_back(flat(sample[i]));
      }
    }
    for (std::size_t s = 0; s < steps.size(); ++s) {
      std::vector<int>& along = triangulation_.along[steps[s].edge];
      along.push_back(triangulation_.along[steps[(s + 1) % steps.size()].edge].front());
    }
    for (const OutlineStep& step : steps) {
      std::vector<int>& along = triangulation_.along[step.edge];
      if (!step.forward) std::reverse(along.begin(), along.end());
    }
    return outline;
  }

  /// Splits every triangle in four, in the order that PanelMesh states.
  void subdivide() {
    std::map<std::array<int, 2>, int> middles;
    std::vector<Vec2>& points = triangulation_.mesh.points;
    const auto key = [](int a, int b) { return std::array{std::min(a, b), std::max(a, b)}; };
    for (std::size_t e = 0; e < triangulation_.along.size(); ++e) {
      const std::vector<int> coarse = triangulation_.along[e];
      if (coarse.empty()) continue;  // merged with another edge
      std::vector<int> fine;
      const double spans = 2.0 * static_cast<double>(coarse.size() - 1);
      for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        const int middle = static_cast<int>(points.size());
        middles[key(coarse[i], coarse[i + 1])] = middle;
        points.push_back(
            flat(panel_.edges[e].curve.at((2.0 * static_cast<double>(i) + 1) / spans)));
        fine.push_back(coarse[i]);
        fine.push_back(middle);
      }
      fine.push_back(coarse.back());
      triangulation_.along[e] = std::move(fine);
    }
    const auto middle_of = [&](int a, int b) {
      const auto [found, added] = middles.try_emplace(key(a, b), static_cast<int>(points.size()));
      if (added) {
        const Vec2 middle = (points[a] + points[b]) / 2;
        points.push_back(middle);
      }
      return found->second;
    };
    std::vector<Triangle> fine;
    fine.reserve(4 * triangulation_.mesh.triangles.size());
    for (const auto& [c0, c1, c2] : triangulation_.mesh.triangles) {
      const int m01 = middle_of(c0, c1);
      const int m12 = middle_of(c1, c2);
      const int m20 = middle_of(c2, c0);
      fine.push_back({c0, m01, m20});
      fine.push_back({m01, c1, m12});
      fine.push_back({m20, m12, c2});
      fine.push_back({m01, m12, m20});
    }
    triangulation_.mesh.triangles = std::move(fine);
    // Where a curve bulges inward, its new points come too close to the middles opposite.
    std::vector<bool> border(points.size(), false);
    for (const std::vector<int>& along : triangulation_.along) {
      for (const int point : along) border[point] = true;
    }
    raise_angles(triangulation_.mesh, border, acceptable_angle);
  }

  const PatternPanel& panel_;
  bool mirrored_;
  std::vector<int> steps_;
  PanelTriangulation triangulation_;
};

std::vector<PanelTriangulation> mesh_all(const Pattern& pattern, const Orientation& orientation,
                                         double edge_length, int subdivisions,
                                         const EdgeSteps& factors, const Corners& split_corners) {
  const double coarse_length = edge_length * (1 << subdivisions);
  const EdgeSteps steps = steps_along(pattern, coarse_length, factors);
  std::vector<PanelTriangulation> triangulations;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    PanelMesher mesher(pattern.panels[p], orientation.mirrored[p]);
    try {
      triangulations.push_back(
          mesher.mesh(steps[p], coarse_length, subdivisions, split_corners[p]));
    } catch (Unmeshable& unmeshable) {
      unmeshable.index = p;
      throw;
    }
  }
  return triangulations;
}

/// Triangles that a mesh of such edges would have, about.
double expected_triangles(const Pattern& pattern, double edge_length) {
  double triangles = 0;
  for (const PatternPanel& panel : pattern.panels) {
    std::vector<Vec2> points;
    double length = 0;
    for (const OutlineStep& step : panel.outline) {
      const EdgeCurve& curve = panel.edges[step.edge].curve;
      length += curve.length();
      for (int i = 0; i < 8; ++i) points.push_back(curve.at((step.forward ? i : 8 - i) / 8.0));
    }
    triangles += std::abs(signed_area(points)) / (std::sqrt(3.0) / 4 * edge_length * edge_length) +
                 length / edge_length;
  }
  return triangles;
}

void check_size(const Pattern& pattern, double edge_length) {
  const double triangles = expected_triangles(pattern, edge_length);
  if (triangles <= max_garment_triangles) return;
  throw Error(pattern.source,
              triangles < 1e12
                  ? "would need about " + std::to_string(static_cast<int>(triangles / 1e6)) +
                        " million triangles"
                  : "would need more than a million million triangles",
              "check 'units_in_meter', or ask for a longer --edge-length");
}

/// Subdivisions that keep the coarsest edges at about coarsest_edge, or its mesh small.
int default_subdivisions(const Pattern& pattern, double edge_length) {
  int subdivisions =
      std::max(0, static_cast<int>(std::lround(std::log2(coarsest_edge / edge_length))));
  while (subdivisions < max_subdivisions &&
         expected_triangles(pattern, edge_length * (1 << subdivisions)) > max_coarsest_triangles) {
    ++subdivisions;
  }
  return subdivisions;
}

std::string default_name(const Pattern& pattern, const Stitch& stitch) {
  const auto side = [&](const EdgeRef& ref) {
    return pattern.panels[ref.panel].name + "." + std::to_string(ref.edge);
  };
  return side(stitch.a) + "-" + side(stitch.b);
}

std::vector<int> share_of(const std::vector<int>& along, PanelAttachment::Share share) {
  if (share == PanelAttachment::Share::whole) return along;
  return {share == PanelAttachment::Share::start ? along.front() : along.back()};
}

/// How GarmentCode's label of an edge says that it is held while the garment is dressed. A neckline
/// would slide off the shoulders, and a strapless top down the chest. The waist of low trousers,
/// `lower_interface`, may slip below the hips before it is closed. But held from the first, a
/// waist stands too high on a smaller body than its own: of 46 such, two fewer are dressed.
std::optional<Attachment> held_by_label(const std::string& label) {
  Attachment held;
  if (label == "left_collar" || label == "right_collar") {
    held.to = AttachedTo::side;
    return held;
  }
  held.to = AttachedTo::height;
  held.only_if_it_slips = label == "lower_interface";
  if (held.only_if_it_slips || label == "strapless_top") return held;
  return std::nullopt;
}

PanelMesh assemble(const Pattern& pattern, const Orientation& orientation,
                   const std::vector<PanelTriangulation>& triangulations) {
  PanelMesh garment;
  garment.has_places = has_places(pattern);
  for (std::size_t p = 0; p < triangulations.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    const PlanarMesh& mesh = triangulations[p].mesh;
    MeshedPanel meshed;
    meshed.name = panel.name;
    meshed.part = panel.part;
    meshed.label = panel.label;
    meshed.fabric = panel.fabric;
    meshed.placement = orientation.mirrored[p] ? mirrored(panel.placement) : panel.placement;
    meshed.grain = orientation.mirrored[p] ? -panel.grain : panel.grain;
    meshed.first_point = static_cast<int>(garment.flat.size());
    meshed.points = static_cast<int>(mesh.points.size());
    meshed.first_triangle = static_cast<int>(garment.triangles.size());
    meshed.triangles = static_cast<int>(mesh.triangles.size());
    for (const Vec2& point : mesh.points) {
      garment.flat.push_back(point);
      garment.placed.push_back(
          panel.place({orientation.mirrored[p] ? -point.x() : point.x(), point.y()}));
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      garment.triangles.push_back(
          {a + meshed.first_point, b + meshed.first_point, c + meshed.first_point});
    }
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      if (!panel.edges[e].elastic) continue;
      MeshedElastic elastic{panel.name + "." + std::to_string(e), triangulations[p].along[e],
                            panel.edges[e].elastic->ratio, panel.edges[e].elastic->stiffness};
      for (int& point : elastic.points) point += meshed.first_point;
      garment.elastics.push_back(std::move(elastic));
    }
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const std::optional<Attachment> how = held_by_label(panel.edges[e].label);
      if (!how) continue;
      MeshedAttachment held{panel.name + "." + std::to_string(e), triangulations[p].along[e], *how};
      for (int& point : held.points) point += meshed.first_point;
      garment.attachments.push_back(std::move(held));
    }
    for (const PanelAttachment& attached : panel.attachments) {
      MeshedAttachment meshed_attachment{
          panel.name + "." + attached.name,
          share_of(triangulations[p].along[attached.edge], attached.share), attached.how};
      for (int& point : meshed_attachment.points) point += meshed.first_point;
      garment.attachments.push_back(std::move(meshed_attachment));
    }
    garment.panels.push_back(std::move(meshed));
  }
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const auto side = [&](const EdgeRef& ref) {
      std::vector<int> points = triangulations[ref.panel].along[ref.edge];
      for (int& point : points) point += garment.panels[ref.panel].first_point;
      return points;
    };
    MeshedSeam seam;
    seam.name = stitch.name.empty() ? default_name(pattern, stitch) : stitch.name;
    seam.a = side(stitch.a);
    seam.b = side(stitch.b);
    if (orientation.reversed[s]) std::reverse(seam.b.begin(), seam.b.end());
    seam.length_a = pattern.panels[stitch.a.panel].edges[stitch.a.edge].curve.length();
    seam.length_b = pattern.panels[stitch.b.panel].edges[stitch.b.edge].curve.length();
    garment.seams.push_back(std::move(seam));
  }
  return garment;
}

/// The outline's corners whose triangles would lie upon others once sewn.
Corners doubled_corners(const PanelMesh& garment,
                        const std::vector<PanelTriangulation>& triangulations) {
  Corners corners(triangulations.size());
  std::size_t p = 0;
  for (const int t : doubled_triangles(garment)) {
    while (t >= garment.panels[p].first_triangle + garment.panels[p].triangles) ++p;
    const int border = triangulations[p].coarse_border;
    Triangle local = garment.triangles[t];
    std::vector<int> coarse;
    for (int& corner : local) {
      corner -= garment.panels[p].first_point;
      if (corner < border) coarse.push_back(corner);
    }
    for (const int corner : coarse) {
      const auto neighbour = [&](int other) {
        return other == corner || other == (corner + 1) % border ||
               other == (corner + border - 1) % border;
      };
      // On finer levels only the corner itself is of the coarse outline.
      if (coarse.size() == 1 || std::all_of(local.begin(), local.end(), neighbour)) {
        corners[p].push_back(corner);
        break;
      }
    }
  }
  return corners;
}

PanelMesh mesh_garment(const Pattern& pattern, const Orientation& orientation, double edge_length,
                       int subdivisions, const EdgeSteps& factors) {
  const Corners none(pattern.panels.size());
  std::vector<PanelTriangulation> triangulations =
      mesh_all(pattern, orientation, edge_length, subdivisions, factors, none);
  PanelMesh garment = assemble(pattern, orientation, triangulations);
  const Corners corners = doubled_corners(garment, triangulations);
  if (corners != none) {
    triangulations = mesh_all(pattern, orientation, edge_length, subdivisions, factors, corners);
    garment = assemble(pattern, orientation, triangulations);
  }
  garment.subdivisions = subdivisions;
  garment.edge_length = edge_length;
  return garment;
}

/// Meshes with shorter steps along the edges at which triangles would be needles. Throws Unmeshable
/// where that does not help.
PanelMesh mesh_with_shorter_steps(const Pattern& pattern, const Orientation& orientation,
                                  double edge_length, int subdivisions) {
  EdgeSteps factors;
  for (const PatternPanel& panel : pattern.panels) factors.emplace_back(panel.edges.size(), 1);
  for (int round = 0;; ++round) {
    try {
      return mesh_garment(pattern, orientation, edge_length, subdivisions, factors);
    } catch (const Unmeshable& unmeshable) {
      if (unmeshable.edges.empty() || round == max_step_halvings) throw;
      for (const int e : unmeshable.edges) factors[unmeshable.index][e] *= 2;
    }
  }
}

}  // namespace

PanelMesh mesh_panels(const Pattern& pattern, const MeshSettings& settings,
                      std::vector<Remark>& remarks) {
  check_size(pattern, settings.edge_length);
  const Orientation orientation = orient(pattern, remarks);
  const int wanted = settings.subdivisions >= 0
                         ? settings.subdivisions
                         : default_subdivisions(pattern, settings.edge_length);
  std::optional<Unmeshable> failure;
  for (int subdivisions = std::min(wanted, max_subdivisions); subdivisions >= 0; --subdivisions) {
    try {
      PanelMesh garment =
          mesh_with_shorter_steps(pattern, orientation, settings.edge_length, subdivisions);
      if (failure) {
        remarks.push_back({false, pattern.source + ": " + failure->panel + " " + failure->problem +
                                      " on the coarser level; " + std::to_string(subdivisions) +
                                      " subdivisions are used"});
      }
      return garment;
    } catch (const Unmeshable& unmeshable) {
      failure = unmeshable;
    }
  }
  throw Error(pattern.source + ": " + failure->panel, failure->problem + " at this edge length",
              "ask for a shorter --edge-length, or widen the corner there");
}

}  // namespace toile
