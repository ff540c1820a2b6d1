#include "pattern/mesh/mesh_panels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "pattern/classify/classify.h"
#include "pattern/constants.h"
#include "pattern/mesh/cut_outs.h"
#include "pattern/mesh/doubled_triangles.h"
#include "pattern/mesh/seam_orientation.h"
#include "pattern/mesh/seam_steps.h"
#include "pattern/mesh/triangulate_panel.h"

namespace toile {

namespace {

/// Lines or drill holes of a panel that a note names one by one.
constexpr std::size_t max_named_marks = 8;

/// Per panel, points of its coarse outline that need an interior point in the triangle with their
/// two neighbours on the outline.
using Corners = std::vector<std::vector<int>>;

/// A pattern and how all of its panels are meshed, on any number of levels.
struct Meshing {
  const Pattern& pattern;
  const Orientation& orientation;
  double edge_length = 0;
  std::vector<std::vector<CutOut>> cut_outs;  ///< per panel
};

std::vector<PanelTriangulation> mesh_all(const Meshing& meshing, int subdivisions,
                                         const EdgeSteps& factors, const Corners& split_corners) {
  const double coarse_length = meshing.edge_length * (1 << subdivisions);
  const EdgeSteps steps = steps_along(meshing.pattern, coarse_length, factors);
  std::vector<PanelTriangulation> triangulations;
  for (std::size_t p = 0; p < meshing.pattern.panels.size(); ++p) {
    try {
      triangulations.push_back(triangulate_panel(
          meshing.pattern.panels[p], {meshing.orientation.mirrored[p], coarse_length, subdivisions,
                                      steps[p], split_corners[p], meshing.cut_outs[p]}));
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
  const auto triangles = [&](int subdivisions) {
    return expected_triangles(pattern, edge_length * (1 << subdivisions));
  };
  int subdivisions =
      std::max(0, static_cast<int>(std::lround(std::log2(coarsest_edge / edge_length))));
  const double next = 2 * edge_length * (1 << subdivisions);
  if (triangles(subdivisions) > many_coarsest_triangles && next < longest_coarse_edge) {
    ++subdivisions;
  }
  while (subdivisions < max_subdivisions && triangles(subdivisions) > max_coarsest_triangles) {
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

/// Warns of edges that a label holds and that were merged with others, so that nothing is left to
/// hold. The edge that took one in has its own label, or none.
void warn_of_lost_holds(const Pattern& pattern, std::vector<Remark>& remarks) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const auto is_it = [e](const OutlineStep& step) { return step.edge == static_cast<int>(e); };
      if (!held_by_label(panel.edges[e].label) || std::ranges::any_of(panel.outline, is_it)) {
        continue;
      }
      remarks.push_back({true, pattern.source + ": " +
                                   edge_name(pattern, {static_cast<int>(p), static_cast<int>(e)}) +
                                   " is labelled '" + panel.edges[e].label +
                                   "', but too short to be held while the garment is dressed"});
    }
  }
}

/// The cut-outs of a panel, whose points are counted from `first_point` on.
std::vector<MeshedCutOut> meshed_cut_outs(const std::string& panel,
                                          const std::vector<CutOut>& cut_outs,
                                          const PanelTriangulation& triangulation,
                                          int first_point) {
  std::vector<MeshedCutOut> meshed;
  std::size_t run = 0;
  for (const CutOut& cut_out : cut_outs) {
    MeshedCutOut hole{panel + ".cut_out." + std::to_string(cut_out.index), {}};
    for (std::size_t c = 0; c < cut_out.curves.size(); ++c) {
      const std::vector<int>& along = triangulation.cut_along[run++];
      for (std::size_t i = 0; i + 1 < along.size(); ++i) {
        hole.points.push_back(first_point + along[i]);
      }
    }
    meshed.push_back(std::move(hole));
  }
  return meshed;
}

PanelMesh assemble(const Meshing& meshing, const std::vector<PanelTriangulation>& triangulations) {
  const Pattern& pattern = meshing.pattern;
  const Orientation& orientation = meshing.orientation;
  PanelMesh garment;
  garment.has_places = has_places(pattern);
  for (std::size_t p = 0; p < triangulations.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    const PlanarMesh& mesh = triangulations[p].mesh;
    MeshedPanel meshed;
    meshed.name = panel.name;
    meshed.fabric = panel.fabric;
    meshed.layered = std::ranges::any_of(pattern.stitches, [&](const Stitch& stitch) {
      return stitch.layered && stitch.b.panel == static_cast<int>(p);
    });
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
      if (!how || triangulations[p].along[e].empty()) continue;
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
    std::vector<MeshedCutOut> holes =
        meshed_cut_outs(panel.name, meshing.cut_outs[p], triangulations[p], meshed.first_point);
    std::move(holes.begin(), holes.end(), std::back_inserter(garment.cut_outs));
    for (const PointedMark& mark : triangulations[p].marks.marks) {
      MeshedMark meshed_mark{panel.name + (mark.is_line ? ".internal_line." : ".drill_hole.") +
                                 std::to_string(mark.index),
                             mark.points};
      for (int& point : meshed_mark.points) point += meshed.first_point;
      garment.marks.push_back(std::move(meshed_mark));
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
  std::vector<PanelWitnesses> told;
  told.reserve(pattern.panels.size());
  for (const PatternPanel& panel : pattern.panels) told.push_back(witnesses_of(panel));
  classify(garment, told);
  return garment;
}

/// The outline's corners whose triangles would lie upon others once sewn.
Corners doubled_corners(const PanelMesh& garment,
                        const std::vector<PanelTriangulation>& triangulations) {
  Corners corners(triangulations.size());
  std::size_t p = 0;
  for (const int t : doubled_triangles(garment)) {
    while (t >= garment.panels[p].first_triangle + garment.panels[p].triangles) ++p;
    const int border = triangulations[p].coarse_outline;
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

/// A note for each panel with lines and drill holes that no mesh point lies on.
std::vector<Remark> lost_marks(const Pattern& pattern,
                               const std::vector<PanelTriangulation>& triangulations) {
  std::vector<Remark> notes;
  for (std::size_t p = 0; p < triangulations.size(); ++p) {
    const PointedMarks& marks = triangulations[p].marks;
    std::string text;
    const auto list = [&](const std::string& one, const std::vector<int>& lost) {
      if (lost.empty()) return;
      text += (text.empty() ? "" : ", ") + one + (lost.size() > 1 ? "s" : "");
      for (std::size_t i = 0; i < std::min(lost.size(), max_named_marks); ++i) {
        text += (i == 0 ? " " : ", ") + std::to_string(lost[i]);
      }
      if (lost.size() > max_named_marks) {
        text += " and " + std::to_string(lost.size() - max_named_marks) + " others";
      }
    };
    list("internal line", marks.lost_lines);
    list("drill hole", marks.lost_holes);
    if (text.empty()) continue;
    notes.push_back({false, pattern.source + ": " + quoted(pattern.panels[p]) + ", " + text +
                                ": not marked in the mesh; at this edge length too near to the "
                                "outline or to each other, or outside"});
  }
  return notes;
}

/// `notes` tells of marks that are lost.
PanelMesh mesh_garment(const Meshing& meshing, int subdivisions, const EdgeSteps& factors,
                       std::vector<Remark>& notes) {
  const Corners none(meshing.pattern.panels.size());
  std::vector<PanelTriangulation> triangulations = mesh_all(meshing, subdivisions, factors, none);
  PanelMesh garment = assemble(meshing, triangulations);
  const Corners corners = doubled_corners(garment, triangulations);
  if (corners != none) {
    triangulations = mesh_all(meshing, subdivisions, factors, corners);
    garment = assemble(meshing, triangulations);
  }
  notes = lost_marks(meshing.pattern, triangulations);
  garment.subdivisions = subdivisions;
  garment.edge_length = meshing.edge_length;
  return garment;
}

/// Meshes with shorter steps along the edges at which triangles would be needles. Throws Unmeshable
/// where that does not help.
PanelMesh mesh_with_shorter_steps(const Meshing& meshing, int subdivisions,
                                  std::vector<Remark>& notes) {
  EdgeSteps factors;
  for (const PatternPanel& panel : meshing.pattern.panels)
    factors.emplace_back(panel.edges.size(), 1);
  for (int round = 0;; ++round) {
    try {
      return mesh_garment(meshing, subdivisions, factors, notes);
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
  warn_of_lost_holds(pattern, remarks);
  const Orientation orientation = orient(pattern, remarks);
  Meshing meshing{pattern, orientation, settings.edge_length, {}};
  for (const PatternPanel& panel : pattern.panels) {
    meshing.cut_outs.push_back(cut_outs_to_mesh(panel, settings.edge_length,
                                                pattern.source + ": " + quoted(panel), remarks));
  }
  const int wanted = settings.subdivisions >= 0
                         ? settings.subdivisions
                         : default_subdivisions(pattern, settings.edge_length);
  std::optional<Unmeshable> failure;
  for (int subdivisions = std::min(wanted, max_subdivisions); subdivisions >= 0; --subdivisions) {
    try {
      std::vector<Remark> notes;
      PanelMesh garment = mesh_with_shorter_steps(meshing, subdivisions, notes);
      remarks.insert(remarks.end(), notes.begin(), notes.end());
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
