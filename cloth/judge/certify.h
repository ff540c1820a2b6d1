// The independent judge of a dressing: every state on the way, with exact predicates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/frame.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// What is wrong with one state on the way: counts of pairs of triangles that intersect.
struct FrameFigures {
  std::string stage;
  int points = 0;        ///< material points of the mesh in hand
  int open_pairs = 0;    ///< pairs of seam points that are not in one place
  int body = 0;          ///< with the body
  int layers = 0;        ///< with the layers below
  int self = 0;          ///< with itself
  int across_seams = 0;  ///< of `self`, those that will be neighbours once the seams are closed
  int inside = 0;        ///< pieces of cloth that meet no surface because they are inside the body

  bool clean() const { return body + layers + self + inside == 0; }
};

/// Checks the states of one dressing. It knows nothing of the solver: it takes the points as they
/// are and joins two of them where a seam does and they are in one place, less than 1e-9 m apart;
/// all else is decided by intersections().
class Certificate {
 public:
  /// `body`, closed and outward-oriented, and `layers`, null for none, have to outlive it.
  Certificate(const TriangleMesh& body, const TriangleMesh* layers);

  /// Checks the next state. About O(n log n) in the triangles of cloth and body.
  const FrameFigures& check(const DressFrame& frame);

  const std::vector<FrameFigures>& frames() const { return frames_; }
  /// The first frame from which on all are clean; none when the last is not.
  std::optional<int> clean_from() const;
  /// Whether no frame was unclean after the first clean one with closed seams; false when there is
  /// no such frame.
  bool stayed_clean() const;

 private:
  const TriangleMesh& body_;
  const TriangleMesh* layers_;
  SurfaceDistance distance_;
  std::vector<FrameFigures> frames_;
};

}  // namespace toile
