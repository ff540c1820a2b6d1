#include "geometry/scan/scan_samples.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/parallel.h"
#include "geometry/scan/scan_cells.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

constexpr double least_cell = 0.004;  // metres: less than half of a finger
constexpr double neighbours = 2.5;    // cells around a sample that its plane is fitted to
constexpr double by_noise = 8;        // or as many standard deviations of the noise

/// The plane through a sample's neighbours.
struct Plane {
  Vec3 middle;
  Vec3 normal;
  double flatness = 0;
  double density = 0;  // points on a square metre
};

Plane plane_at(const ScanCells& cells, int cell, double reach) {
  const Vec3& at = cells.means()[cell];
  const double wide = reach / 2;  // standard deviation of the weights
  const int around = static_cast<int>(std::ceil(reach / cells.size()));
  double sum = 0;
  Vec3 mean = Vec3::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  cells.near(at, around, [&](int other) {
    const Vec3 to = cells.means()[other] - at;
    const double squared = to.squaredNorm() / (wide * wide);
    if (squared > 5) return;
    const double weight = cells.counts()[other] * std::exp(-squared / 2);
    sum += weight;
    mean += weight * to;
    spread += weight * to * to.transpose();
  });
  mean /= sum;
  spread = (spread / sum - mean * mean.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Vec3& sizes = axes.eigenvalues();
  Plane plane;
  plane.middle = at + mean;
  plane.normal = axes.eigenvectors().col(0);
  // A straight row of points, or a ball of them, has no plane.
  if (sizes[1] > 1e-3 * wide * wide) {
    plane.flatness = std::clamp(1 - 2 * std::max(sizes[0], 0.0) / sizes[1], 0.0, 1.0);
  }
  plane.density = sum / (2 * std::numbers::pi * wide * wide);
  return plane;
}

std::vector<Plane> planes_of(const ScanCells& cells, double reach) {
  std::vector<Plane> planes(cells.cells());
  parallel_for_chunks(cells.cells(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      planes[i] = plane_at(cells, static_cast<int>(i), reach);
  });
  return planes;
}

/// Standard deviation of the points about their neighbours' planes, by the median.
double noise_about(const std::vector<Plane>& planes, const ScanCells& cells,
                   const std::vector<Vec3>& points) {
  std::vector<double> off(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Plane& plane = planes[cells.cell_of()[i]];
    off[i] = std::abs(plane.normal.dot(points[i] - plane.middle));
  }
  return 1.4826 * median(std::move(off));
}

/// Which cells of a coarse grid the body's points are in.
class Shell {
 public:
  Shell(const std::vector<Vec3>& points, double size) : size_(size) {
    for (const Vec3& p : points) box_.extend(p);
    for (int i = 0; i < 3; ++i) cells_[i] = static_cast<int>(box_.sizes()[i] / size_) + 1;
    full_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], 0);
    for (const Vec3& p : points) full_[index(p)] = 1;
  }

  /// Fills the soles, which no camera sees: cells at the floor that have the body's lowest points
  /// to all four sides. Otherwise rays would leave the feet through them.
  void close_soles(const AxisDirection& up) {
    constexpr double foot = 0.16;  // metres: half of the longest sole
    const int reach = static_cast<int>(foot / size_);
    const int layers = static_cast<int>(0.03 / size_) + 1;
    const int a = (up.axis + 1) % 3;
    const int b = (up.axis + 2) % 3;
    std::vector<std::uint8_t> low(static_cast<std::size_t>(cells_[a]) * cells_[b], 0);
    const auto layer = [&](int height) {
      return up.sign > 0 ? height : cells_[up.axis] - 1 - height;
    };
    std::array<int, 3> at{};
    const auto cell = [&](int i, int j, int height) {
      at[a] = i;
      at[b] = j;
      at[up.axis] = layer(height);
      return index(at);
    };
    const auto in_plane = [&](int i, int j) { return static_cast<std::size_t>(j) * cells_[a] + i; };
    for (int j = 0; j < cells_[b]; ++j) {
      for (int i = 0; i < cells_[a]; ++i) {
        for (int height = 0; height < std::min(layers, cells_[up.axis]); ++height) {
          low[in_plane(i, j)] |= full_[cell(i, j, height)];
        }
      }
    }
    const auto meets = [&](int i, int j, int di, int dj) {
      for (int k = 0; k <= reach; ++k, i += di, j += dj) {
        if (i < 0 || j < 0 || i >= cells_[a] || j >= cells_[b]) return false;
        if (low[in_plane(i, j)] != 0) return true;
      }
      return false;
    };
    for (int j = 0; j < cells_[b]; ++j) {
      for (int i = 0; i < cells_[a]; ++i) {
        if (meets(i, j, 1, 0) && meets(i, j, -1, 0) && meets(i, j, 0, 1) && meets(i, j, 0, -1)) {
          full_[cell(i, j, 0)] = 1;
        }
      }
    }
  }

  /// Whether a ray from a point of the body meets no cell beyond those around its start.
  bool escapes(const Vec3& from, const Vec3& direction) const {
    for (double along = 1.6 * size_;; along += 0.7 * size_) {
      const Vec3 at = from + along * direction;
      if (!box_.contains(at)) return true;
      if (full_[index(at)] != 0) return false;
    }
  }

 private:
  std::size_t index(const Vec3& p) const {
    std::array<int, 3> at;
    for (int i = 0; i < 3; ++i) {
      at[i] = std::clamp(static_cast<int>((p[i] - box_.min()[i]) / size_), 0, cells_[i] - 1);
    }
    return index(at);
  }
  std::size_t index(const std::array<int, 3>& at) const {
    return (static_cast<std::size_t>(at[2]) * cells_[1] + at[1]) * cells_[0] + at[0];
  }

  double size_;
  Eigen::AlignedBox3d box_;
  std::array<int, 3> cells_{};
  std::vector<std::uint8_t> full_;
};

/// The 26 directions to a cell's neighbours, of unit length.
std::vector<Vec3> ray_directions() {
  std::vector<Vec3> directions;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) directions.push_back(Vec3(x, y, z).normalized());
      }
    }
  }
  return directions;
}

/// Turns the normals outward.
void orient(const ScanCells& cells, const AxisDirection& up, double spacing, ScanSamples& samples) {
  Shell shell(samples.points, std::max({2 * spacing, 1.5 * cells.size(), 0.008}));
  shell.close_soles(up);
  const std::vector<Vec3> directions = ray_directions();
  std::vector<Vec3> out(samples.points.size());  // the sum of the rays that leave the body
  parallel_for_chunks(out.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i].setZero();
      for (const Vec3& direction : directions) {
        if (shell.escapes(samples.points[i], direction)) out[i] += direction;
      }
    }
  });
  if (samples.normals_given) {
    // Given normals are right or all wrong.
    double sum = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      sum += samples.areas[i] * out[i].dot(samples.normals[i]);
    }
    if (sum < 0) {
      for (Vec3& normal : samples.normals) normal = -normal;
    }
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i].dot(samples.normals[i]) < 0) samples.normals[i] = -samples.normals[i];
  }
  // Neighbours mend what single votes got wrong.
  std::vector<Vec3> next(samples.normals.size());
  for (int round = 0; round < 2; ++round) {
    parallel_for_chunks(next.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Vec3 sum = Vec3::Zero();
        cells.near(samples.points[i], 2, [&](int other) {
          sum += samples.flatness[other] * cells.counts()[other] * samples.normals[other];
        });
        next[i] = sum.dot(samples.normals[i]) < 0 ? Vec3(-samples.normals[i]) : samples.normals[i];
      }
    });
    samples.normals.swap(next);
  }
}

/// Mean of the given normals of each cell; false: too many are missing.
bool take_normals(const PointCloud& body, const ScanCells& cells, ScanSamples& samples) {
  if (body.normals.size() != body.points.size()) return false;
  std::vector<Vec3> sums(cells.cells(), Vec3::Zero());
  for (std::size_t i = 0; i < body.points.size(); ++i) sums[cells.cell_of()[i]] += body.normals[i];
  const auto lost =
      std::count_if(sums.begin(), sums.end(), [](const Vec3& sum) { return !(sum.norm() > 1e-6); });
  if (10 * static_cast<std::size_t>(lost) > sums.size()) return false;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].norm() > 1e-6) {
      samples.normals[i] = sums[i].normalized();
      samples.flatness[i] = std::min(1.0, sums[i].norm() / cells.counts()[i]);
    } else {
      samples.flatness[i] = 0;
    }
  }
  return true;
}

}  // namespace

ScanSamples sample_scan(const PointCloud& body, const AxisDirection& up, double spacing) {
  // About a point to a cell: larger ones would round fingertips off.
  const double size = std::max(0.75 * spacing, least_cell);
  const ScanCells cells(body.points, size);
  std::vector<Plane> planes = planes_of(cells, neighbours * size);
  double noise = noise_about(planes, cells, body.points);
  // Planes through few cells follow the noise, and so hide a part of it.
  if (by_noise * noise > neighbours * size) {
    planes = planes_of(cells, by_noise * noise);
    noise = noise_about(planes, cells, body.points);
  }
  ScanSamples samples;
  samples.spacing = spacing;
  samples.noise = noise;
  samples.cell = size;
  samples.points = cells.means();
  samples.sample_of = cells.cell_of();
  // A lone point stands for no more than six ordinary ones.
  const double largest = 6 * spacing * spacing;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    samples.normals.push_back(planes[i].normal);
    samples.flatness.push_back(planes[i].flatness);
    samples.areas.push_back(cells.counts()[i] * std::min(largest, 1 / planes[i].density));
  }
  samples.normals_given = take_normals(body, cells, samples);
  orient(cells, up, spacing, samples);
  return samples;
}

}  // namespace toile
