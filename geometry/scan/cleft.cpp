#include "geometry/scan/cleft.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile {

namespace {

// Metres.
constexpr double near = 0.03;      // between tubes: only they count
constexpr double far = 0.06;       // they don't count
constexpr double overlap = 0.01;   // of tubes that are taken to be apart all the same
constexpr double fillet = 0.008;   // within which two surfaces blend
constexpr double under_roof = 0.01;
constexpr double over_roof = 0.03;

/// 0 up to `low`, 1 from `high` on, with two derivatives.
double rise(double low, double high, double at) {
  const double t = std::clamp((at - low) / (high - low), 0.0, 1.0);
  return t * t * t * (t * (6 * t - 15) + 10);
}

/// The lesser of two, less where they are near to each other.
double blended_least(double a, double b) {
  const double share = std::max(0.0, 1 - std::abs(a - b) / fillet);
  return std::min(a, b) - share * share * share * fillet / 6;
}

}  // namespace

Cleft::Cleft(LimbTube one, LimbTube other, LimbTube roof, double least_gap)
    : one_(std::move(one)),
      other_(std::move(other)),
      roof_(std::move(roof)),
      least_gap_(least_gap) {
  const auto add = [this](const LimbTube& tube, const LimbTube& facing) {
    for (int s = 0; s < tube.stations(); ++s) {
      for (int a = 0; a < tube.angles(); ++a) {
        const Vec3 p = tube.point(s, a);
        if (facing.off(p) < far && roof_.off(p) > -over_roof) box_.extend(p);
      }
    }
  };
  add(one_, other_);
  add(other_, one_);
}

double Cleft::operator()(const Vec3& point, double distance) const {
  if (!box_.contains(point)) return distance;
  const double to_roof = roof_.off(point);
  if (to_roof < -over_roof) return distance;
  const double to_one = one_.off(point);
  const double to_other = other_.off(point);
  const double gap = to_one + to_other;
  const double share = (1 - rise(near, far, gap)) * rise(-over_roof, -under_roof, to_roof);
  if (share == 0) return distance;
  const double apart = std::clamp((least_gap_ - gap) / 2, 0.0, (least_gap_ + overlap) / 2);
  const double tubes = std::min(to_one, to_other) + apart;
  return distance + share * (blended_least(tubes, to_roof) - distance);
}

}  // namespace toile
