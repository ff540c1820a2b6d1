#include "geometry/scan/limb_tube.h"

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/statistics.h"

namespace toile {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Term = std::pair<int, double>;

/// Metres: bends within a few times this length are smoothed away.
constexpr double tube_smoothing = 0.012;
/// Metres behind the nearest sample of a patch: what is farther is a hand's.
constexpr double depth = 0.025;
/// Metres from the wall at which a sample counts a quarter.
constexpr double stray = 0.01;
constexpr double full_turn = 2 * std::numbers::pi;

/// Least squares over the nodes of a grid.
class Sums {
 public:
  explicit Sums(std::size_t nodes) : right_(Eigen::VectorXd::Zero(static_cast<int>(nodes))) {}

  void add(std::initializer_list<Term> terms, double wanted, double weight) {
    for (const Term& a : terms) {
      right_[a.first] += weight * a.second * wanted;
      for (const Term& b : terms) {
        entries_.emplace_back(a.first, b.first, weight * a.second * b.second);
      }
    }
  }
  Eigen::VectorXd solved() const {
    Sparse matrix(right_.size(), right_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Sparse> solver(matrix);
    return solver.solve(right_);
  }

 private:
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

}  // namespace

LimbTube::LimbTube(const TubeAxis& axis, const ScanSamples& samples, const std::vector<int>& which,
                   const TubeOptions& options)
    : axis_(axis),
      across_(axis.along.cross(axis.toward)),
      options_(options),
      error_(std::numeric_limits<double>::infinity()) {
  const double step = options.step;
  stations_ = std::max(4, static_cast<int>(std::lround(axis.length / step)) + 1);
  std::vector<double> all;
  for (const int s : which) {
    const Vec3 off = samples.points[s] - axis_.start;
    all.push_back((off - off.dot(axis_.along) * axis_.along).norm());
  }
  const double ordinary = all.empty() ? step : median(all);
  angles_ = std::max(24, 4 * static_cast<int>(std::lround(full_turn * ordinary / step / 4)));
  radii_.assign(static_cast<std::size_t>(stations_) * angles_, ordinary);

  std::vector<Place> places;
  std::vector<double> areas;
  for (const int s : which) {
    const Place at = place(samples.points[s]);
    if (at.station < 0 || at.station > stations_ - 1 || at.radius < step) continue;
    const Vec3 off = samples.points[s] - axis_.start;
    const Vec3 out = (off - off.dot(axis_.along) * axis_.along) / at.radius;
    if (out.dot(samples.normals[s]) < options.outside) continue;
    places.push_back(at);
    areas.push_back(samples.areas[s]);
  }
  constexpr int sectors = 24;
  const auto patch = [&](const Place& at) {
    const auto along = static_cast<std::size_t>(at.station / 4);
    return along * sectors + static_cast<int>(at.angle / angles_ * sectors) % sectors;
  };
  std::vector<double> nearest(static_cast<std::size_t>(stations_ / 4 + 1) * sectors,
                              std::numeric_limits<double>::infinity());
  for (const Place& at : places) nearest[patch(at)] = std::min(nearest[patch(at)], at.radius);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].radius > nearest[patch(places[i])] + depth) continue;
    places[kept] = places[i];
    areas[kept++] = areas[i];
  }
  places.resize(kept);
  areas.resize(kept);
  if (kept > 0) fit(places, areas);
}

LimbTube::Place LimbTube::place(const Vec3& point) const {
  const Vec3 off = point - axis_.start;
  const double x = off.dot(axis_.toward);
  const double y = off.dot(across_);
  double angle = std::atan2(y, x) / full_turn * angles_;
  if (angle < 0) angle += angles_;
  return {off.dot(axis_.along) / options_.step, angle, std::hypot(x, y)};
}

std::vector<double> LimbTube::ordinary_radii(const std::vector<Place>& places) const {
  std::vector<std::vector<double>> at(stations_);
  for (const Place& p : places) at[std::lround(p.station)].push_back(p.radius);
  std::vector<double> radii(stations_);
  for (int s = 0; s < stations_; ++s) {
    std::vector<double> band;
    for (int reach = 4; band.empty(); reach *= 2) {
      for (int k = std::max(0, s - reach); k <= std::min(stations_ - 1, s + reach); ++k) {
        band.insert(band.end(), at[k].begin(), at[k].end());
      }
    }
    radii[s] = median(std::move(band));
  }
  return radii;
}

void LimbTube::fit(const std::vector<Place>& places, const std::vector<double>& areas) {
  const std::vector<double> rest = ordinary_radii(places);
  const auto node = [this](int s, int a) { return s * angles_ + (a + angles_) % angles_; };
  const double stiffness = std::pow(tube_smoothing, 4);
  std::vector<double> trust(places.size(), 1);
  std::vector<double> off(places.size());
  for (int round = 0; round < 3; ++round) {
    Sums sums(radii_.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place& at = places[i];
      const int s = std::clamp(static_cast<int>(at.station), 0, stations_ - 2);
      const int a = static_cast<int>(at.angle);
      const double t = at.station - s;
      const double u = at.angle - a;
      sums.add({{node(s, a), (1 - t) * (1 - u)},
                {node(s, a + 1), (1 - t) * u},
                {node(s + 1, a), t * (1 - u)},
                {node(s + 1, a + 1), t * u}},
               at.radius, areas[i] * trust[i]);
    }
    for (int s = 0; s < stations_; ++s) {
      const double arc = rest[s] * full_turn / angles_;
      const double weight = stiffness * options_.step * arc;
      const double own = 1 / (rest[s] * rest[s]);
      const double bend = 1 / (arc * arc);
      const double straight = 1 / (options_.step * options_.step);
      const double twist = 1 / (options_.step * arc);
      for (int a = 0; a < angles_; ++a) {
        sums.add({{node(s, a - 1), bend}, {node(s, a), own - 2 * bend}, {node(s, a + 1), bend}},
                 (2 - options_.roundness) * own * rest[s], weight);
        if (s + 1 == stations_) continue;
        sums.add({{node(s, a), twist},
                  {node(s, a + 1), -twist},
                  {node(s + 1, a), -twist},
                  {node(s + 1, a + 1), twist}},
                 0, 2 * weight);
        if (s == 0) continue;
        sums.add(
            {{node(s - 1, a), straight}, {node(s, a), -2 * straight}, {node(s + 1, a), straight}},
            0, weight);
      }
    }
    const Eigen::VectorXd found = sums.solved();
    if (!found.allFinite()) return;  // too few samples
    for (std::size_t i = 0; i < radii_.size(); ++i) radii_[i] = found[static_cast<int>(i)];
    // Strays count less [Geman & McClure 1987].
    for (std::size_t i = 0; i < places.size(); ++i) {
      off[i] = std::abs(places[i].radius - wall(places[i]));
      const double share = 1 + off[i] * off[i] / (stray * stray);
      trust[i] = 1 / (share * share);
    }
  }
  error_ = median(off);
}

double LimbTube::radius(int station, int angle) const {
  return radii_[static_cast<std::size_t>(station) * angles_ + (angle + angles_) % angles_];
}

Vec3 LimbTube::point(int station, int angle) const {
  const double at = full_turn * angle / angles_;
  return axis_.start + station * options_.step * axis_.along +
         radius(station, angle) * (std::cos(at) * axis_.toward + std::sin(at) * across_);
}

double LimbTube::wall(const Place& at) const {
  const double station = std::clamp(at.station, 0.0, stations_ - 1.001);
  const int s = static_cast<int>(station);
  const int a = static_cast<int>(at.angle);
  const double t = station - s;
  const double u = at.angle - a;
  return (1 - t) * ((1 - u) * radius(s, a) + u * radius(s, a + 1)) +
         t * ((1 - u) * radius(s + 1, a) + u * radius(s + 1, a + 1));
}

double LimbTube::facing(const Vec3& point) const {
  const Vec3 off = point - axis_.start;
  const double radius = (off - off.dot(axis_.along) * axis_.along).norm();
  return radius > 0 ? off.dot(axis_.toward) / radius : 0;
}

double LimbTube::off(const Vec3& point) const {
  const Place at = place(point);
  return at.radius - wall(at);
}

}  // namespace toile
