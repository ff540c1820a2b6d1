// Pulls of attachments on the vertices that they hold.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/vec4.h"

namespace toile {

/// Vertices are the model's nodes, or its material points while seams stand open.
class AttachmentForces {
 public:
  AttachmentForces(const GarmentModel& model, bool of_points);

  bool empty() const { return entries_.empty(); }
  /// Adds to the forces (N) on vertices `begin` to `end`, with all vertices at `x`, and to the
  /// bounds of their stiffness (N/m), the fourth.
  void add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const;

 private:
  struct Entry {
    std::size_t vertex;
    AttachedPoint attached;
  };
  std::vector<Entry> entries_;  // by vertex, rising
};

}  // namespace toile
