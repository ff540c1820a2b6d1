#include "cloth/relaxation/attachment_forces.h"

#include <algorithm>

namespace toile {

AttachmentForces::AttachmentForces(const GarmentModel& model, bool of_points) {
  for (const AttachedPoint& attached : model.attachments) {
    const int vertex = of_points ? attached.point : model.node_of_point[attached.point];
    entries_.push_back({static_cast<std::size_t>(vertex), attached});
  }
  std::ranges::stable_sort(entries_, {}, &Entry::vertex);
}

void AttachmentForces::add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const {
  auto entry = std::ranges::lower_bound(entries_, begin, {}, &Entry::vertex);
  for (; entry != entries_.end() && entry->vertex < end; ++entry) {
    Vec4 pull = as_vec4(attachment_pull(entry->attached, as_vec3(x[entry->vertex])));
    pull[3] = entry->attached.stiffness;
    force[entry->vertex] += pull;
  }
}

}  // namespace toile
