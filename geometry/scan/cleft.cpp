#include "geometry/scan/cleft.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile {

namespace {

// Metres. Without the bounds of roof and sight, bellies and shoulders were smoothed away. Each was
// halved and doubled with a scan of the mannequin and of mean_all, 50k points, and what no camera
// saw was compared. Of it 95 and 83 % are within 10 mm, and the crotch is 3 and 6 mm too low.
//
// Between tubes: only what is nearer counts. At half, 95 and 90 %; at double as before.
constexpr double near_gap = 0.03;
// From here on they don't count. At half, 93 and 91 %, with a spur of 3 cm on the mannequin; at
// double as before.
constexpr double far_gap = 0.06;
// Within which two surfaces blend. At half as before; at double, 99 and 84 %, and the crotch of
// mean_all is 12 mm too low.
constexpr double fillet = 0.008;
// Below the roof, where tubes begin to count, and above it, where they end. Half or double of
// either changes less than 0.1 %.
constexpr double under_roof = 0.01;
constexpr double over_roof = 0.03;
// A gap that a grid may fill although it was seen. Half or double changes less than 0.1 %.
constexpr double narrow = 0.015;
// Cosines from straight below the roof's axis: the roof counts only below. At half of `aside` as
// before. At double of it, and at half or double of `below`, the crotch is 24 to 34 mm too low.
constexpr double aside = 0.5;
constexpr double below = 0.75;

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

Cleft::Cleft(LimbTube one, LimbTube other, LimbTube roof, const CleftOptions& options)
    : one_(std::move(one)), other_(std::move(other)), roof_(std::move(roof)), options_(options) {
  const auto add = [this](const LimbTube& tube, const LimbTube& facing) {
    for (int s = 0; s < tube.stations(); ++s) {
      for (int a = 0; a < tube.angles(); ++a) {
        const Vec3 p = tube.point(s, a);
        if (facing.off(p) < far_gap && roof_.off(p) + options_.lift > -over_roof) box_.extend(p);
      }
    }
  };
  add(one_, other_);
  add(other_, one_);
}

double Cleft::operator()(const Vec3& point, double distance, double unseen) const {
  if (!box_.contains(point)) return distance;
  const double to_roof = roof_.off(point) + options_.lift;
  if (to_roof < -over_roof || roof_.facing(point) < aside) return distance;
  const double to_one = one_.off(point);
  const double to_other = other_.off(point);
  const double gap = to_one + to_other;
  const double share = (1 - rise(near_gap, far_gap, gap)) * rise(-over_roof, -under_roof, to_roof) *
                       rise(aside, below, roof_.facing(point));
  const double apart =
      std::clamp((options_.least_gap - gap) / 2, 0.0, (options_.least_gap + options_.overlap) / 2);
  const double tubes = std::min(to_one, to_other) + apart;
  const double change = share * (blended_least(tubes, to_roof) - distance);
  // What was seen is believed. But a grid may have filled a gap that is narrow.
  return distance +
         (change < 0 ? unseen : std::max(unseen, 1 - rise(narrow, near_gap, gap))) * change;
}

}  // namespace toile
