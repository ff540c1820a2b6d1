// Sizes of a body that tell where panels stand.
#pragma once

#include <utility>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Metres throughout. Each call but the first two is linear in the body's vertices or triangles.
class BodySizes {
 public:
  /// `body` has the joints of `skeleton`; both have to live as long. Throws Error when a joint of
  /// the neck or the shoulders is missing.
  BodySizes(const TriangleMesh& body, const Skeleton& skeleton);

  double middle() const { return middle_; }      ///< x of the middle plane
  double shoulder() const { return shoulder_; }  ///< from there to a shoulder joint

  /// z of the skin of the trunk between two heights, the smallest and the largest; that of the
  /// waist joint where there is no skin.
  std::pair<double, double> depth(double low, double high) const;

  /// Height of the shoulder below the neck joint, `aside` from the middle plane.
  double shoulder_height(double aside) const;

  double waist_girth() const;  ///< 0: the waist is open

 private:
  const TriangleMesh& body_;
  const Skeleton& skeleton_;
  double middle_ = 0;
  double shoulder_ = 0;
};

}  // namespace toile
