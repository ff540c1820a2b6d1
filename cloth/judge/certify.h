// The independent judge of a dressing: checks every recorded state with exact predicates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/frame.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// What is wrong with one recorded state. Counts are pairs of triangles that intersect, unless said
/// otherwise.
struct FrameCheck {
  std::string stage;
  int points = 0;        ///< material points of the state's mesh
  int open_pairs = 0;    ///< pairs of seam points that are apart
  int body = 0;          ///< of cloth and body
  int layers = 0;        ///< of cloth and the layers below
  int self = 0;          ///< of cloth and cloth
  int across_seams = 0;  ///< of `self`: pairs that will be neighbours once the seams are closed
  int inside = 0;  ///< components of cloth that meet no surface because they are inside the body

  bool clean() const { return body + layers + self + inside == 0; }
};

/// Checks the states of one dressing. It knows nothing of the solver. It takes the points as they
/// are, and joins two points of a seam that are less than 1e-9 m apart. intersections() decides
/// everything else.
class Certificate {
 public:
  /// `body` is closed and outward-oriented. `layers` is null when there are none. Both have to
  /// outlive the certificate.
  Certificate(const TriangleMesh& body, const TriangleMesh* layers);

  /// Checks the next state. About O(n log n) in the triangles of cloth and body.
  const FrameCheck& check(const DressFrame& frame);

  const std::vector<FrameCheck>& frames() const { return frames_; }
  /// Index of the first frame from which on all are clean. None when the last frame is not clean.
  std::optional<int> clean_from() const;
  /// Whether no frame was unclean after the first clean one with closed seams. False when there is
  /// no such frame.
  bool stayed_clean() const;

 private:
  const TriangleMesh& body_;
  const TriangleMesh* layers_;
  SurfaceDistance distance_;
  std::vector<FrameCheck> frames_;
};

}  // namespace toile
