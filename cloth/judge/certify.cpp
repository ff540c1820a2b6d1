#include "cloth/judge/certify.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "geometry/intersections.h"

namespace toile {

namespace {

/// Disjoint sets of points; each is named by its lowest.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int of(int p) {
    while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
    return p;
  }
  void join(int a, int b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Triangle> of(std::vector<Triangle> triangles) {
    for (Triangle& t : triangles) {
      for (int& corner : t) corner = of(corner);
    }
    return triangles;
  }

 private:
  std::vector<int> parent_;
};

/// Metres: where a pattern places two sides in one place, only rounding lies between them.
constexpr double rounding = 1e-9;

bool share_a_corner(const Triangle& s, const Triangle& t) {
  return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end();
}

}  // namespace

Certificate::Certificate(const TriangleMesh& body, const TriangleMesh* layers)
    : body_(body), layers_(layers), distance_(body) {}

const FrameFigures& Certificate::check(const DressFrame& frame) {
  FrameFigures& figures = frames_.emplace_back();
  figures.stage = frame.stage;
  figures.vertices = static_cast<int>(frame.points.size());
  Sets sewn(frame.points.size());
  Sets to_be_sewn(frame.points.size());
  for (const MeshedSeam& seam : frame.mesh.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      to_be_sewn.join(seam.a[i], seam.b[i]);
      if ((frame.points[seam.a[i]] - frame.points[seam.b[i]]).norm() < rounding) {
        sewn.join(seam.a[i], seam.b[i]);
      } else {
        ++figures.open_pairs;
      }
    }
  }
  const TriangleMesh cloth{frame.points, sewn.of(frame.mesh.triangles)};
  const std::vector<Triangle> closed = to_be_sewn.of(frame.mesh.triangles);
  for (const auto& [s, t] : self_intersections(cloth)) {
    ++figures.self;
    figures.across_seams += share_a_corner(closed[s], closed[t]) &&
                            !share_a_corner(cloth.triangles[s], cloth.triangles[t]);
  }
  const std::vector<TrianglePair> with_body = intersections(cloth, body_);
  figures.body = static_cast<int>(with_body.size());
  if (layers_ != nullptr) figures.layers = static_cast<int>(intersections(cloth, *layers_).size());

  Sets pieces(frame.points.size());
  for (const Triangle& t : cloth.triangles) {
    pieces.join(t[0], t[1]);
    pieces.join(t[0], t[2]);
  }
  std::set<int> meeting;
  for (const TrianglePair& pair : with_body) meeting.insert(pieces.of(cloth.triangles[pair[0]][0]));
  std::set<int> all;
  for (const Triangle& t : cloth.triangles) all.insert(pieces.of(t[0]));
  // What does not meet the surface is on one side of it: any point tells which.
  for (const int piece : all) {
    if (meeting.count(piece) != 0) continue;
    figures.inside += distance_.nearest(frame.points[piece]).distance < 0;
  }
  return figures;
}

std::optional<int> Certificate::clean_from() const {
  std::size_t first = frames_.size();
  while (first > 0 && frames_[first - 1].clean()) --first;
  if (first == frames_.size()) return std::nullopt;
  return static_cast<int>(first);
}

bool Certificate::stayed_clean() const {
  const auto closed = std::find_if(frames_.begin(), frames_.end(), [](const FrameFigures& frame) {
    return frame.clean() && frame.open_pairs == 0;
  });
  return closed != frames_.end() &&
         std::all_of(closed, frames_.end(), [](const FrameFigures& f) { return f.clean(); });
}

std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result) {
  std::vector<Vec3> points = result.placement.placed;
  points.resize(garment.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      points[garment.triangles[t][i]] = result.nodes[result.triangles[t][i]];
    }
  }
  return points;
}

}  // namespace toile
