#include "cloth/judge/verdict.h"

#include "cloth/judge/constants.h"
#include "geometry/intersections.h"

namespace toile {

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::unsewable:
      return "unsewable";
    case Verdict::intersecting:
      return "intersecting";
    case Verdict::unwrapped:
      return "unwrapped";
    case Verdict::unconverged:
      return "unconverged";
    case Verdict::sewn:
      return "sewn";
  }
  return "";
}

Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, bool converged, const TriangleMesh* layers,
                const std::vector<TightSeam>& tight) {
  Judgement judgement;
  judgement.garment = measure_garment(pattern, dressed);
  if (skeleton != nullptr) judgement.wraps = measure_wraps(pattern, dressed, *skeleton);
  const TriangleMesh cloth{dressed.points, dressed.triangles};
  judgement.body_intersections = static_cast<int>(intersections(cloth, body).size());
  judgement.self_intersections = static_cast<int>(self_intersections(cloth).size());
  if (layers != nullptr) {
    judgement.layer_intersections = static_cast<int>(intersections(cloth, *layers).size());
  }
  const int all_intersections =
      judgement.body_intersections + judgement.self_intersections + judgement.layer_intersections;
  judgement.unsewable_seams = judgement.garment.seams.open_seams;
  for (const TightSeam& seam : tight) {
    judgement.unsewable_seams.push_back({seam.name, seam.missing_cm});
  }
  for (const WrapFigure& wrap : judgement.wraps) {
    if (wrap.tube && wrap.fraction < around_share) judgement.unwrapped.push_back(wrap.part);
  }
  if (!judgement.unsewable_seams.empty()) {
    judgement.verdict = Verdict::unsewable;
  } else if (all_intersections > 0) {
    judgement.verdict = Verdict::intersecting;
  } else if (!judgement.unwrapped.empty()) {
    judgement.verdict = Verdict::unwrapped;
  } else if (!converged) {
    judgement.verdict = Verdict::unconverged;
  } else {
    judgement.verdict = Verdict::sewn;
  }
  return judgement;
}

}  // namespace toile
