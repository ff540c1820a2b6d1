#include "cloth/judge/certify.h"

#include <algorithm>
#include <set>

#include "cloth/scene/constants.h"
#include "geometry/disjoint_sets.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

bool share_a_corner(const Triangle& s, const Triangle& t) {
  return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end();
}

}  // namespace

Certificate::Certificate(const TriangleMesh& body, const TriangleMesh* layers)
    : body_(body), layers_(layers), distance_(body) {}

const FrameCheck& Certificate::check(const DressFrame& frame) {
  FrameCheck& found = frames_.emplace_back();
  found.stage = frame.stage;
  found.points = static_cast<int>(frame.points.size());
  DisjointSets sewn(frame.points.size());
  DisjointSets to_be_sewn(frame.points.size());
  for (const MeshedSeam& seam : frame.mesh.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      to_be_sewn.join(seam.a[i], seam.b[i]);
      if ((frame.points[seam.a[i]] - frame.points[seam.b[i]]).norm() < same_place) {
        sewn.join(seam.a[i], seam.b[i]);
      } else {
        ++found.open_pairs;
      }
    }
  }
  const TriangleMesh cloth{frame.points, sewn.joined(frame.mesh.triangles)};
  const std::vector<Triangle> closed = to_be_sewn.joined(frame.mesh.triangles);
  for (const auto& [s, t] : self_intersections(cloth)) {
    ++found.self;
    found.across_seams += share_a_corner(closed[s], closed[t]) &&
                          !share_a_corner(cloth.triangles[s], cloth.triangles[t]);
  }
  const std::vector<TrianglePair> with_body = intersections(cloth, body_);
  found.body = static_cast<int>(with_body.size());
  if (layers_ != nullptr) found.layers = static_cast<int>(intersections(cloth, *layers_).size());

  DisjointSets components(frame.points.size());
  for (const Triangle& t : cloth.triangles) {
    components.join(t[0], t[1]);
    components.join(t[0], t[2]);
  }
  std::set<int> meeting;
  for (const TrianglePair& pair : with_body)
    meeting.insert(components.of(cloth.triangles[pair[0]][0]));
  std::set<int> all;
  for (const Triangle& t : cloth.triangles) all.insert(components.of(t[0]));
  // A component that does not meet the surface is all on one side of it, and so is any of its
  // points.
  for (const int component : all) {
    if (meeting.count(component) != 0) continue;
    found.inside += distance_.closest_point(frame.points[component]).distance < 0;
  }
  return found;
}

std::optional<int> Certificate::clean_from() const {
  std::size_t first = frames_.size();
  while (first > 0 && frames_[first - 1].clean()) --first;
  if (first == frames_.size()) return std::nullopt;
  return static_cast<int>(first);
}

bool Certificate::stayed_clean() const {
  const auto closed = std::find_if(frames_.begin(), frames_.end(), [](const FrameCheck& frame) {
    return frame.clean() && frame.open_pairs == 0;
  });
  return closed != frames_.end() &&
         std::all_of(closed, frames_.end(), [](const FrameCheck& f) { return f.clean(); });
}

}  // namespace toile
