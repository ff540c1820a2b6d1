#include "cloth/judge/verdict.h"

#include <algorithm>

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

Fit measure_fit(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton& skeleton) {
  if (!has_all_limbs(skeleton)) return {};
  std::vector<double> grains;
  for (const MeshedPanel& panel : pattern.panels) grains.push_back(panel.grain);
  const GirthEases girths = measure_girth_ease(dressed, body, skeleton, grains, 0);
  Fit fit = fit_of(girths.levels, measure_garment_levels(dressed, body, skeleton),
                   measure_limb_ease(dressed, body, skeleton, grains));
  // The nearest level may be one that was not measured.
  if (std::ranges::any_of(girths.left_out, &LevelLeftOut::is_open)) fit.nearest.reset();
  return fit;
}

}  // namespace

Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, const DressingEnd& end, const TriangleMesh* layers) {
  Judgement judgement;
  judgement.garment = measure_garment(pattern, dressed);
  judgement.slits = find_slits(pattern, dressed);
  if (skeleton != nullptr) {
    judgement.wraps = measure_wraps(pattern, dressed, *skeleton);
    judgement.worn = check_worn(pattern, dressed, *skeleton, &body);
    judgement.fit = measure_fit(pattern, dressed, body, *skeleton);
    // No seam was left open where it would shut the opening: a V neckline has two such edges, too.
    std::erase_if(judgement.slits, [&](const Slit& slit) {
      return std::ranges::any_of(judgement.worn.openings, [&](const Opening& opening) {
        return is_too_small(opening, slit.rest) &&
               std::ranges::find(opening.nodes, slit.node) != opening.nodes.end();
      });
    });
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
  } else if (!end.tight_seams.empty()) {
    judgement.verdict = Verdict::too_tight;
  } else {
    judgement.verdict = Verdict::sewn;
  }
  return judgement;
}

}  // namespace toile
