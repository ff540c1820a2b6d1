// Forces of attachments on the vertices that they hold.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/vec4.h"

namespace toile {

/// Forces of attachments. Vertices are the model's material points with `of_points`, as while seams
/// stand open; else they are its nodes.
class AttachmentForces {
 public:
  AttachmentForces(const GarmentModel& model, bool of_points);

  bool empty() const { return entries_.empty(); }
  /// Adds the attachments' forces (N) on vertices `begin` to `end` to `force`, and bounds of their
  /// stiffness (N/m) as the fourth component. `x`: metres, one a vertex.
  void add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const;

 private:
  struct Entry {
    std::size_t vertex;
    AttachedPoint attached;
  };
  std::vector<Entry> entries_;  // by ascending vertex
};

}  // namespace toile
