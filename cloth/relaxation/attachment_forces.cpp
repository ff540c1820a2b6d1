#include "cloth/relaxation/attachment_forces.h"

#include <algorithm>

namespace toile {

AttachmentForces::AttachmentForces(const GarmentModel& model, bool of_points) {
  for (const AttachedPoint& held : model.attachments) {
    const int vertex = of_points ? held.point : model.node_of_point[held.point];
    entries_.push_back({static_cast<std::size_t>(vertex), held});
  }
  std::ranges::stable_sort(entries_, {}, &Entry::vertex);
}

void AttachmentForces::add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const {
  auto entry = std::ranges::lower_bound(entries_, begin, {}, &Entry::vertex);
  for (; entry != entries_.end() && entry->vertex < end; ++entry) {
    Vec4 pull = as_vec4(attachment_pull(entry->held, as_vec3(x[entry->vertex])));
    pull[3] = entry->held.stiffness;
    force[entry->vertex] += pull;
  }
}

}  // namespace toile
