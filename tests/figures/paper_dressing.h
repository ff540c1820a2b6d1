// A garment dressed by the paper's method, with all that its figures show: the way, the result, the
// verdict [Zhong & Xu 2009, Fig. 10 to 13].
#pragma once

#include <string>
#include <vector>

#include "cloth/judge/verdict.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/dress_springs.h"
#include "geometry/body/mannequin/mannequin.h"
#include "pattern/panel_mesh.h"

namespace toile::figures {

/// The sample mannequin, and what it wears.
struct Wearer {
  explicit Wearer(const Pose& pose);

  Mannequin mannequin;
  Collider subject;
};

/// A pattern of samples/, meshed with such edges (metres). Throws Error as read_pattern().
PanelMesh sample_garment(const std::string& name, double edge_length);

/// The garment at one time of its way. Changes in percent against the flat pattern, signed.
struct DressingMoment {
  double seconds = 0;  ///< simulated
  std::string stage;
  std::vector<double> area;       ///< per panel
  std::vector<double> perimeter;  ///< per panel, of all its triangles
  double largest_area() const;    ///< of |change|
  double largest_perimeter() const;
};

struct DressingState {
  std::string caption;
  std::vector<Vec3> points;  ///< per material point, metres
};

/// Edges off the seams that are strained beyond the limit, by panel and nearest joint.
struct StrainedPlace {
  std::string panel;
  std::string joint;
  int edges = 0;
  double largest = 0;      ///< |length/rest - 1|
  bool longer = false;     ///< the most strained one is stretched, not crushed
  Vec3 at = Vec3::Zero();  ///< its middle, metres
};

struct PaperDressing {
  std::string name;
  PanelMesh garment;
  SpringDressOptions options;
  DressResult result;
  DressedGarment dressed;
  Judgement judgement;
  std::vector<DressingMoment> moments;  ///< about a hundred a second simulated
  std::vector<DressingState> states;    ///< position, wrap (twice), sew, drape, as far as it came
  std::vector<StrainedPlace> places;    ///< the most strained first
  double seconds = 0;                   ///< of the computer, position to verdict

  long steps() const;
  double simulated() const;  ///< seconds
  /// Seconds of the computer per step; 0 without steps.
  double seconds_per_step() const;
  /// Largest over the way, percent.
  double max_area() const;
  double max_perimeter() const;
};

/// As the figures dress: strain is controlled by three passes a step while wrapping and sewing, and
/// by sweeps until 1 % holds while draping.
SpringDressOptions figure_options();

/// Dresses and judges; says on stderr what it does and what came out. The wearer wears what it
/// wore: Wearer::subject.add_layer() puts the garment on for the next. Throws Error as
/// dress_springs().
PaperDressing dress_by_paper(const std::string& name, const PanelMesh& garment,
                             const Wearer& wearer,
                             const SpringDressOptions& options = figure_options(),
                             const Fabric& fabric = {});

/// The edges off the seams beyond `limit`, gathered to places, the most strained first.
std::vector<StrainedPlace> strained_places(const PanelMesh& garment,
                                           const std::vector<Vec3>& points,
                                           const Skeleton& skeleton, double limit);

}  // namespace toile::figures
