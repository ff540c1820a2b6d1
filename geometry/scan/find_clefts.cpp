#include "geometry/scan/find_clefts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/body/body_frame.h"
#include "geometry/body/centreline.h"
#include "geometry/error.h"

namespace toile {

namespace {

// Shares of the height.
constexpr double shin = 0.25;        // below the hands, above the feet
constexpr double above = 0.56;       // above every crotch, below the waist
constexpr double tube_step = 0.003;  // between the nodes of tubes
/// Metres of overlap that thighs' tubes may have, and still be apart. With 25 or 50 mm, the crotch
/// of three bodies is the same to 0.1 mm.
constexpr double leg_overlap = 0.03;
/// Metres by which the crotch is higher than its outline goes on: the mesh ends about as much
/// below. The crotch of four bodies is 0 to 4 mm too low with it, and 4 mm lower without. Each
/// millimetre makes the girths of thighs 1.4 mm larger, as they are taken higher up.
constexpr double leg_lift = 0.004;
/// Most of a sample's normal that points across: farther, it is a thigh's and not the crotch's. At
/// half of it, the crotch of every second scan is 5 mm lower; without it, that of every eighth 20.
constexpr double crotch_across = 0.6;
/// Share of the height, to both sides of the middle, in which samples are the crotch's. With 0.006,
/// crotches of one body's scans differ by 6 mm, and with 0.01 by 3. But then that of a scan of
/// 40,000 points is 13 mm too low.
constexpr double crotch_slab = 0.008;
/// As leg_overlap of arm and trunk, whose tubes overlap by up to 40 mm at armpits. With 0.1 scans
/// of three bodies are the same; with 0.02, armpits of two are 4 mm lower.
constexpr double arm_overlap = 0.06;
/// Share of the height that an armpit is below the shoulder above it. It is 0.0746 to 0.0759 of
/// mean_all, mean_male and makehuman_base, 0.079 to 0.09 of mannequins. With 0.072 armpits of their
/// scans are 7 mm too low to 19 too high. With 0.0765 they are 15 too low to 8 too high.
constexpr double armpit_depth = 0.0755;
/// Metres, most that an armpit is higher or lower than its outline goes on. Scans of five bodies
/// need 28 mm at most.
constexpr double most_arm_lift = 0.08;
/// Metres between tubes and half of their samples: what is farther off is no limb.
constexpr double worst_error = 0.004;

/// The frame in which the body stands along y on y = 0.
class Upright {
 public:
  explicit Upright(const RoughBody& body)
      : turn_(
            Eigen::Quaterniond::FromTwoVectors(body.up.vector(), Vec3::UnitY()).toRotationMatrix()),
        floor_(body.floor) {}

  TriangleMesh mesh(TriangleMesh mesh) const {
    for (Vec3& p : mesh.points) p = turn_ * p - floor_ * Vec3::UnitY();
    return mesh;
  }
  Vec3 given(const Vec3& p) const { return turn_.transpose() * (p + floor_ * Vec3::UnitY()); }
  Vec3 given_direction(const Vec3& d) const { return turn_.transpose() * d; }

 private:
  Eigen::Matrix3d turn_;
  double floor_;
};

Vec3 square_to(const Vec3& axis, const Vec3& direction) {
  return (direction - direction.dot(axis) * axis).normalized();
}

/// How far a point is along an axis.
double along(const TubeAxis& axis, const Vec3& p) { return axis.along.dot(p - axis.start); }

double from_axis(const TubeAxis& axis, const Vec3& p) {
  const double at = std::clamp(along(axis, p), 0.0, axis.length);
  return (p - axis.start - at * axis.along).norm();
}

template <class Test>
std::vector<int> samples_where(const ScanSamples& samples, const Test& test) {
  std::vector<int> which;
  for (std::size_t s = 0; s < samples.points.size(); ++s) {
    if (test(samples.points[s])) which.push_back(static_cast<int>(s));
  }
  return which;
}

/// The outline around `centre` of the plane square to `across`; it is open below. It is fitted to
/// samples within `slab` metres of the plane whose normals have no more than `most_across` of
/// `across`. `outside` is as of TubeOptions.
LimbTube roof_at(const Vec3& centre, const Vec3& across, const Vec3& up, double height, double slab,
                 double most_across, double outside, const ScanSamples& samples) {
  TubeAxis axis;
  axis.along = across;
  axis.length = 2 * slab;
  axis.start = centre - slab * across;
  axis.toward = square_to(across, -up);
  const double high = 0.14 * height;
  std::vector<int> which = samples_where(samples, [&](const Vec3& p) {
    return std::abs(across.dot(p - centre)) < slab && (p - centre).norm() < high;
  });
  std::erase_if(which,
                [&](int s) { return std::abs(across.dot(samples.normals[s])) > most_across; });
  return {axis, samples, which, {tube_step * height, 0.5, outside}};
}

struct Legs {
  std::array<TubeAxis, 2> axes;
  Vec3 pelvis;  // in the middle of the trunk, above the crotch
};

/// The legs of a mesh that stands along y on y = 0.
std::optional<Legs> find_legs(const TriangleMesh& mesh, double height) {
  WalkOptions walk;
  walk.step = height / 200;
  walk.min_area = 3.5e-4 * height * height;
  walk.reach = 0.05 * height;
  walk.length = height;
  std::vector<Section> shins = slice(mesh, Vec3(0, shin * height, 0), Vec3::UnitY());
  std::erase_if(shins, [&](const Section& s) { return !s.closed || s.area < walk.min_area; });
  if (shins.size() != 2) return std::nullopt;
  std::array<std::vector<Station>, 2> up;
  for (int leg = 0; leg < 2; ++leg) {
    up[leg] = walk_level(mesh, shins[leg].centroid, above * height, walk);
  }
  std::size_t first = 0;
  const std::size_t both = std::min(up[0].size(), up[1].size());
  while (first < both && up[0][first].section.centroid != up[1][first].section.centroid) ++first;
  // The last sections before the legs meet lean to each other.
  const std::size_t used = first - std::min<std::size_t>(first, 4);
  if (used < 12 || first == both) return std::nullopt;
  Legs legs;
  for (int leg = 0; leg < 2; ++leg) {
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < used; ++i) mean += up[leg][i].section.centroid;
    mean /= static_cast<double>(used);
    Vec3 slope = Vec3::Zero();
    double spread = 0;
    for (std::size_t i = 0; i < used; ++i) {
      const Vec3 off = up[leg][i].section.centroid - mean;
      slope += off.y() * off;
      spread += off.y() * off.y();
    }
    slope /= spread;
    TubeAxis& axis = legs.axes[leg];
    axis.start = mean + (shin * height - mean.y()) * slope;
    axis.along = slope.normalized();
    axis.length = (above - shin) * height * slope.norm();
  }
  const Vec3 apart = legs.axes[1].start - legs.axes[0].start;
  legs.axes[0].toward = square_to(legs.axes[0].along, apart);
  legs.axes[1].toward = square_to(legs.axes[1].along, -apart);
  const std::vector<Section> trunk = slice(mesh, Vec3(0, above * height, 0), Vec3::UnitY());
  if (trunk.empty()) return std::nullopt;
  legs.pelvis = trunk.front().centroid;
  return legs;
}

}  // namespace

std::optional<Cleft> leg_cleft(const RoughBody& body, const ScanSamples& samples,
                               double least_gap) {
  const Upright upright(body);
  std::optional<Legs> legs = find_legs(upright.mesh(body.mesh), body.height);
  if (!legs) return std::nullopt;
  for (TubeAxis& axis : legs->axes) {
    axis.start = upright.given(axis.start);
    axis.along = upright.given_direction(axis.along);
    axis.toward = upright.given_direction(axis.toward);
  }
  const auto tube = [&](int leg) {
    const TubeAxis& own = legs->axes[leg];
    const TubeAxis& other = legs->axes[1 - leg];
    return LimbTube(own, samples,
                    samples_where(samples,
                                  [&](const Vec3& p) {
                                    const double at = along(own, p);
                                    return at > 0 && at < own.length &&
                                           from_axis(own, p) < from_axis(other, p);
                                  }),
                    {.step = tube_step * body.height});
  };
  const Vec3 across = square_to(body.up.vector(), legs->axes[1].start - legs->axes[0].start);
  // The middle between both legs, in the depth and at the height of the pelvis.
  Vec3 middle = upright.given(legs->pelvis);
  const auto beside = [&](int leg) {
    const TubeAxis& axis = legs->axes[leg];
    return across.dot(axis.start + along(axis, middle) * axis.along - middle);
  };
  middle += (beside(0) + beside(1)) / 2 * across;
  LimbTube one = tube(0);
  LimbTube other = tube(1);
  LimbTube roof = roof_at(middle, across, body.up.vector(), body.height, crotch_slab * body.height,
                          crotch_across, 0.6, samples);
  if (!(std::max({one.error(), other.error(), roof.error()}) <= worst_error)) return std::nullopt;
  return Cleft(std::move(one), std::move(other), std::move(roof),
               {least_gap, leg_overlap, leg_lift});
}

std::vector<Cleft> arm_clefts(const RoughBody& body, const ScanSamples& samples, double least_gap) {
  const Upright upright(body);
  std::vector<Cleft> clefts;
  std::optional<BodyFrame> frame;
  try {
    frame = body_frame(upright.mesh(body.mesh), "scan");
  } catch (const Error&) {
    return clefts;
  }
  if (!frame->skeleton) return clefts;
  const auto joint = [&](const std::string& name) {
    return upright.given(frame->given(frame->skeleton->joint(name)));
  };
  const Vec3 up = body.up.vector();
  const Vec3 left = upright.given_direction(frame->rotation.transpose() * Vec3::UnitX());
  const double h = body.height;
  const double armpits = up.dot(joint("chest"));
  std::array<TubeAxis, 2> arms;
  for (int i = 0; i < 2; ++i) {
    const std::string side = i == 0 ? "left_" : "right_";
    const Vec3 elbow = joint(side + "elbow");
    const Vec3 shoulder = joint(side + "shoulder");
    arms[i].start = elbow;
    arms[i].along = (shoulder - elbow).normalized();
    arms[i].length = (shoulder - elbow).norm();
    arms[i].toward = square_to(arms[i].along, i == 0 ? Vec3(-left) : left);
  }
  TubeAxis trunk;
  trunk.start = joint("waist");
  trunk.along = up;
  trunk.length = armpits + 0.05 * h - up.dot(trunk.start);
  trunk.toward = square_to(up, left);
  const auto arm_end = [&](int i) { return Vec3(arms[i].start + arms[i].length * arms[i].along); };
  const LimbTube trunk_tube(trunk, samples,
                            samples_where(samples,
                                          [&](const Vec3& p) {
                                            const double at = along(trunk, p);
                                            if (at < 0 || at > trunk.length) return false;
                                            const bool is_left = left.dot(p - trunk.start) > 0;
                                            const int i = is_left ? 0 : 1;
                                            const double beyond =
                                                (is_left ? 1 : -1) * left.dot(p - arm_end(i));
                                            if (up.dot(p) > armpits - 0.03 * h) return beyond < 0;
                                            return from_axis(arms[i], p) > 0.045 * h;
                                          }),
                            {.step = tube_step * h});
  for (int i = 0; i < 2; ++i) {
    const Vec3 outward = i == 0 ? left : Vec3(-left);
    const Vec3 shoulder = arm_end(i);
    LimbTube arm(arms[i], samples,
                 samples_where(samples,
                               [&](const Vec3& p) {
                                 const double at = along(arms[i], p);
                                 return at > 0 && at < arms[i].length &&
                                        from_axis(arms[i], p) < 0.055 * h &&
                                        outward.dot(p - shoulder) > -0.005 * h;
                               }),
                 {.step = tube_step * h});
    LimbTube roof = roof_at(shoulder, outward, up, h, 0.009 * h, 1, 0.2, samples);
    if (!(std::max({arm.error(), trunk_tube.error(), roof.error()}) <= worst_error)) continue;
    // From the shoulder down to where the outline goes on.
    const int across = roof.stations() / 2;
    const double deep = up.dot(roof.point(across, roof.angles() / 2) - roof.point(across, 0));
    const double lift = std::clamp(deep - armpit_depth * h, -most_arm_lift, most_arm_lift);
    clefts.emplace_back(std::move(arm), trunk_tube, std::move(roof),
                        CleftOptions{least_gap, arm_overlap, lift});
  }
  return clefts;
}

}  // namespace toile
