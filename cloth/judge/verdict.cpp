#include "cloth/judge/verdict.h"

#include <algorithm>

#include "cloth/ease/figure_errors.h"
#include "cloth/ease/standing_measures.h"
#include "cloth/judge/drafted.h"
#include "cloth/judge/on_floor.h"
#include "geometry/intersections.h"

namespace toile {

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::unsewable:
      return "unsewable";
    case Verdict::intersecting:
      return "intersecting";
    case Verdict::misplaced:
      return "misplaced";
    case Verdict::unwrapped:
      return "unwrapped";
    case Verdict::unconverged:
      return "unconverged";
    case Verdict::unstable:
      return "unstable";
    case Verdict::too_tight:
      return "too_tight";
    case Verdict::sewn:
      return "sewn";
  }
  return "";
}

namespace {

/// Whether a level runs through an armhole. A dress that is far too wide has its armholes at the
/// bust, and is not open there by its seams.
bool is_at_armhole(const DressedGarment& dressed, const std::vector<Opening>& openings,
                   double height) {
  return std::ranges::any_of(openings, [&](const Opening& opening) {
    if (opening.limbs.left_arm == opening.limbs.right_arm) return false;
    const auto is_below = [&](int node) { return dressed.points[node].y() < height; };
    return std::ranges::any_of(opening.nodes, is_below) &&
           !std::ranges::all_of(opening.nodes, is_below);
  });
}

/// Sets `fit` and `levels`.
void measure_fit(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                 const Skeleton& skeleton, Judgement& judgement) {
  if (!has_all_limbs(skeleton)) return;
  GirthOptions options;
  options.step = 0;
  for (const MeshedPanel& panel : pattern.panels) options.grains.push_back(panel.grain);
  const BodyMeasures measures = standing_measures(body, skeleton);
  Girths girths = measure_girths(dressed, body, skeleton, measures, options);
  judgement.levels = measure_garment_levels(dressed, body, skeleton, worn_as(pattern), measures);
  set_drafted(pattern, dressed, body, skeleton, girths.rows, judgement.levels);
  judgement.fit = fit_of(girths.rows, judgement.levels);
  // The nearest level may be one that was not measured. A waist that is sewn wide is wide.
  const auto is_open = [&](const GirthLeftOut& level) {
    return level.is_open && !is_at_armhole(dressed, judgement.worn.openings, level.height);
  };
  std::optional<FitLevel>& nearest = judgement.fit.nearest;
  if (nearest && nearest->level != "waist seam" && std::ranges::any_of(girths.left_out, is_open)) {
    nearest.reset();
  }
}

}  // namespace

Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, const DressingEnd& end, const TriangleMesh* layers) {
  Judgement judgement;
  judgement.garment = measure_garment(pattern, dressed);
  judgement.height_error = height_error(pattern.edge_length);
  judgement.slits = find_slits(pattern, dressed);
  judgement.band_ends = find_band_ends(pattern, dressed);
  if (end.on_floor) judgement.on_floor = panels_on_floor(pattern, dressed, *end.on_floor);
  if (skeleton != nullptr) {
    judgement.wraps = measure_wraps(pattern, dressed, *skeleton);
    judgement.worn = check_worn(pattern, dressed, *skeleton, &body);
    measure_fit(pattern, dressed, body, *skeleton, judgement);
    // No seam was left open where it would shut the opening: a V neckline has two such edges, too.
    std::erase_if(judgement.slits, [&](const Slit& slit) {
      return std::ranges::any_of(judgement.worn.openings, [&](const Opening& opening) {
        return is_too_small(opening, slit.rest) &&
               std::ranges::find(opening.nodes, slit.node) != opening.nodes.end();
      });
    });
    const auto pelvis = skeleton->joints.find("pelvis");
    if (judgement.garment.seams.open == 0 && pelvis != skeleton->joints.end()) {
      judgement.asymmetry = measure_asymmetry(pattern, dressed, pelvis->second.x());
    }
  }
  const TriangleMesh cloth{dressed.points, dressed.triangles};
  judgement.body_intersections = static_cast<int>(intersections(cloth, body).size());
  judgement.self_intersections = static_cast<int>(self_intersections(cloth).size());
  if (layers != nullptr) {
    judgement.layer_intersections = static_cast<int>(intersections(cloth, *layers).size());
  }
  const int all_intersections =
      judgement.body_intersections + judgement.self_intersections + judgement.layer_intersections;
  if (judgement.garment.seams.open > 0) {
    judgement.verdict = Verdict::unsewable;
  } else if (all_intersections > 0) {
    judgement.verdict = Verdict::intersecting;
  } else if (judgement.worn.misplaced) {
    judgement.verdict = Verdict::misplaced;
  } else if (!judgement.worn.unwrapped.empty()) {
    judgement.verdict = Verdict::unwrapped;
  } else if (!end.converged) {
    judgement.verdict = Verdict::unconverged;
  } else if (!end.stays.value_or(true)) {
    judgement.verdict = Verdict::unstable;
  } else if (!end.tight_seams.empty() || !judgement.garment.overstretched.empty()) {
    judgement.verdict = Verdict::too_tight;
  } else {
    judgement.verdict = Verdict::sewn;
  }
  return judgement;
}

}  // namespace toile
