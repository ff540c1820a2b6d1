#include "cloth/judge/asymmetry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "cloth/judge/constants.h"
#include "geometry/border_loops.h"
#include "geometry/closest_points.h"

namespace toile {

namespace {

/// The outline of a flat panel: its longest border.
struct Outline {
  std::vector<int> points;     // material points
  std::vector<Vec2> flat;      // metres
  std::vector<double> shares;  // of the way around, at each point
  double length = 0;           // metres

  /// Metres: the place at a share of the way around, backwards from the point `from`.
  Vec2 backwards(std::size_t from, double share) const {
    double at = shares[from] - share;
    at -= std::floor(at);
    const auto after = std::ranges::upper_bound(shares, at);
    const auto begin = static_cast<std::size_t>(after - shares.begin()) - 1;
    const std::size_t end = (begin + 1) % flat.size();
    const double next = end == 0 ? 1 : shares[end];
    return flat[begin] + (at - shares[begin]) / (next - shares[begin]) * (flat[end] - flat[begin]);
  }
};

/// How a panel's mirror image lies upon its partner.
struct Mirroring {
  int partner = -1;
  Eigen::Rotation2Dd turn{0};
  Vec2 from = Vec2::Zero();  // metres: the middle of the panel's outline
  Vec2 to = Vec2::Zero();    // metres: the middle of the partner's

  /// The place on the partner of a place on the panel.
  Vec2 operator()(const Vec2& flat) const {
    const Vec2 off = flat - from;
    return to + turn * Vec2(-off.x(), off.y());
  }
};

Vec2 middle_of(const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

class MirroredPattern {
 public:
  MirroredPattern(const PanelMesh& pattern, const DressedGarment& dressed, double middle)
      : pattern_(pattern),
        dressed_(dressed),
        middle_(middle),
        panel_of_(panel_of_points(pattern)),
        node_of_(pattern.flat.size(), 0) {
    for (std::size_t t = 0; t < pattern.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) node_of_[pattern.triangles[t][i]] = dressed.triangles[t][i];
    }
  }

  std::optional<Asymmetry> measure() {
    if (!find_partners() || !seams_are_mirrored()) return std::nullopt;
    Asymmetry worst;
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p) compare(p, worst);
    return worst;
  }

 private:
  Outline outline_of(const MeshedPanel& panel) const {
    const auto first = pattern_.triangles.begin() + panel.first_triangle;
    const std::vector<Triangle> triangles(first, first + panel.triangles);
    Outline longest;
    for (const std::vector<int>& loop : border_loops(triangles, pattern_.flat.size())) {
      Outline outline;
      outline.points = loop;
      outline.flat.reserve(loop.size());
      outline.shares.reserve(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        outline.flat.push_back(pattern_.flat[loop[i]]);
        outline.shares.push_back(outline.length);
        outline.length +=
            (pattern_.flat[loop[(i + 1) % loop.size()]] - pattern_.flat[loop[i]]).norm();
      }
      for (double& share : outline.shares) share /= outline.length;
      if (outline.length > longest.length) longest = std::move(outline);
    }
    return longest;
  }

  /// Index of the outline's sharpest corner: its mirror image is a point of the partner, too.
  static std::size_t sharpest(const Outline& outline) {
    const std::size_t count = outline.flat.size();
    std::size_t found = 0;
    double least = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 in = outline.flat[i] - outline.flat[(i + count - 1) % count];
      const Vec2 out = outline.flat[(i + 1) % count] - outline.flat[i];
      const double cosine = in.normalized().dot(out.normalized());
      if (cosine >= least) continue;
      least = cosine;
      found = i;
    }
    return found;
  }

  /// Lays the panel's mirror image upon the partner, corner `first` upon point `at`. Returns the
  /// metres, on average, by which the panels do not mirror each other where they start; infinite:
  /// the outlines differ.
  double lay(const Outline& panel, std::size_t first, const Outline& partner, std::size_t at,
             Mirroring& mirroring) const {
    std::vector<Vec2> there;
    there.reserve(panel.flat.size());
    for (const double share : panel.shares) {
      const double way = share - panel.shares[first];
      there.push_back(partner.backwards(at, way - std::floor(way)));
    }
    mirroring.from = middle_of(panel.flat);
    mirroring.to = middle_of(there);
    double along = 0;
    double across = 0;
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Vec2 off = panel.flat[i] - mirroring.from;
      const Vec2 a(-off.x(), off.y());
      const Vec2 b = there[i] - mirroring.to;
      along += a.dot(b);
      across += a.x() * b.y() - a.y() * b.x();
    }
    mirroring.turn = Eigen::Rotation2Dd(std::atan2(across, along));
    for (std::size_t i = 0; i < there.size(); ++i) {
      if ((mirroring(panel.flat[i]) - there[i]).norm() > mirrored_outline) {
        return std::numeric_limits<double>::infinity();
      }
    }
    double off = 0;
    for (std::size_t i = 0; i < there.size(); ++i) {
      const auto nearest = std::ranges::min_element(
          partner.flat, {}, [&](const Vec2& p) { return (p - there[i]).squaredNorm(); });
      const Vec3& image = pattern_.placed[partner.points[nearest - partner.flat.begin()]];
      off += (mirrored(pattern_.placed[panel.points[i]]) - image).norm();
    }
    return off / static_cast<double>(there.size());
  }

  bool find_partners() {
    std::vector<Outline> outlines;
    outlines.reserve(pattern_.panels.size());
    for (const MeshedPanel& panel : pattern_.panels) outlines.push_back(outline_of(panel));
    mirrorings_.reserve(outlines.size());
    for (std::size_t a = 0; a < outlines.size(); ++a) {
      const std::size_t first = sharpest(outlines[a]);
      double best = std::numeric_limits<double>::infinity();
      Mirroring found;
      for (std::size_t b = 0; b < outlines.size(); ++b) {
        const double differs = std::abs(outlines[a].length - outlines[b].length);
        if (differs > 2 * mirrored_outline ||
            pattern_.panels[a].fabric != pattern_.panels[b].fabric) {
          continue;
        }
        for (std::size_t at = 0; at < outlines[b].flat.size(); ++at) {
          Mirroring tried;
          const double off = lay(outlines[a], first, outlines[b], at, tried);
          if (off >= best) continue;
          best = off;
          found = tried;
          found.partner = static_cast<int>(b);
        }
      }
      if (found.partner < 0) return false;
      mirrorings_.push_back(found);
    }
    for (std::size_t a = 0; a < mirrorings_.size(); ++a) {
      if (mirrorings_[mirrorings_[a].partner].partner != static_cast<int>(a)) return false;
    }
    return true;
  }

  bool seams_are_mirrored() const {
    for (const MeshedSeam& seam : pattern_.seams) {
      const std::size_t stride = std::max<std::size_t>(1, seam.a.size() / mirrored_seam_points);
      for (std::size_t i = 0; i < seam.a.size(); i += stride) {
        if (node_of_[seam.a[i]] != node_of_[seam.b[i]]) return false;
        if ((image_of(seam.a[i]) - image_of(seam.b[i])).norm() > mirrored_seam) return false;
      }
    }
    return true;
  }

  Vec3 mirrored(const Vec3& p) const { return {2 * middle_ - p.x(), p.y(), p.z()}; }

  /// Metres: where the drape has the mirror image of a material point.
  Vec3 image_of(int point) const {
    const Mirroring& mirroring = mirrorings_[panel_of_[point]];
    const MeshedPanel& partner = pattern_.panels[mirroring.partner];
    const Vec2 flat = mirroring(pattern_.flat[point]);
    const auto in_space = [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };
    Vec3 image = Vec3::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (int t = partner.first_triangle; t < partner.first_triangle + partner.triangles; ++t) {
      const Triangle& corners = pattern_.triangles[t];
      std::array<Vec3, 3> at;
      for (int i = 0; i < 3; ++i) at[i] = in_space(pattern_.flat[corners[i]]);
      const Vec3 weights = closest_on_triangle(in_space(flat), at[0], at[1], at[2]);
      const Vec3 closest = weights[0] * at[0] + weights[1] * at[1] + weights[2] * at[2];
      const double off = (closest - in_space(flat)).squaredNorm();
      if (off >= nearest) continue;
      nearest = off;
      image.setZero();
      for (int i = 0; i < 3; ++i) image += weights[i] * dressed_.points[node_of_[corners[i]]];
      if (off == 0) break;
    }
    return image;
  }

  /// What of a panel starts at the left is compared with its mirror images.
  void compare(std::size_t index, Asymmetry& worst) const {
    const MeshedPanel& panel = pattern_.panels[index];
    const int stride = std::max(1, panel.points / mirrored_points);
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int p = panel.first_point; p < panel.first_point + panel.points; p += stride) {
      if (pattern_.placed[p].x() <= middle_) continue;
      const Vec3 off = dressed_.points[node_of_[p]] - mirrored(image_of(p));
      worst.largest = std::max({worst.largest, std::abs(off.x()), std::abs(off.y())});
      sum += off;
      ++count;
    }
    if (count == 0) return;
    const double height = std::abs(sum.y()) / count;
    const double across = std::abs(sum.x()) / count;
    if (std::max(height, across) <= worst.crooked()) return;
    worst.height = height;
    worst.across = across;
    worst.panel = panel.name;
    worst.mirror = pattern_.panels[mirrorings_[index].partner].name;
    if (height > across ? sum.y() > 0 : sum.x() < 0) std::swap(worst.panel, worst.mirror);
  }

  const PanelMesh& pattern_;
  const DressedGarment& dressed_;
  const double middle_;
  std::vector<int> panel_of_;          // per material point
  std::vector<int> node_of_;           // per material point
  std::vector<Mirroring> mirrorings_;  // per panel
};

}  // namespace

std::optional<Asymmetry> measure_asymmetry(const PanelMesh& pattern, const DressedGarment& dressed,
                                           double middle) {
  return MirroredPattern(pattern, dressed, middle).measure();
}

}  // namespace toile
