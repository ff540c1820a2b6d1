#include "geometry/scan/smooth_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/parallel.h"
#include "geometry/scan/scan_cells.h"

namespace toile {

namespace {

constexpr int border = 3;            // layers of nodes at the grid's edge that keep their values
constexpr double coarsest = 0.03;    // metres, about, of the first grid
constexpr std::size_t chunk = 4096;  // nodes of a task
/// Spacings that a grid smooths at least. More of it loses hands and feet on coarse grids, less
/// lets unseen places follow the noise at their edges.
constexpr double coarse_smoothing = 0.4;
/// Metres: an angle between slope and normal counts as this much distance. With half as much,
/// clefts close some 3 mm earlier [one run on mean_all].
constexpr double slope_length = 0.02;

/// A grid of values; node (x, y, z) is at index (z ny + y) nx + x.
struct Grid {
  double spacing = 0;
  Vec3 origin;
  std::array<int, 3> nodes{};
  std::vector<float> values;

  std::size_t size() const { return static_cast<std::size_t>(nodes[0]) * nodes[1] * nodes[2]; }
  std::array<std::ptrdiff_t, 3> steps() const {
    return {1, nodes[0], static_cast<std::ptrdiff_t>(nodes[0]) * nodes[1]};
  }
};

template <class Body>
void in_chunks(std::size_t items, const Body& body) {
  parallel_for(chunks_of(items, chunk),
               [&](std::size_t c) { body(c * chunk, std::min(items, (c + 1) * chunk)); });
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sums(chunks_of(a.size(), chunk), 0);
  in_chunks(a.size(), [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
    sums[begin / chunk] = sum;
  });
  double sum = 0;
  for (const double part : sums) sum += part;
  return sum;
}

/// The cell of a grid that holds a sample, and what its corners weigh there.
struct Place {
  std::array<int, 3> cell;
  std::array<double, 8> weight;
  std::array<Vec3, 8> slope;  // of the weights

  Place(const Grid& grid, const Vec3& point) {
    std::array<double, 3> t;
    for (int i = 0; i < 3; ++i) {
      const double at = (point[i] - grid.origin[i]) / grid.spacing;
      cell[i] = std::clamp(static_cast<int>(at), 0, grid.nodes[i] - 2);
      t[i] = at - cell[i];
    }
    for (int c = 0; c < 8; ++c) {
      std::array<double, 3> w;
      std::array<double, 3> d;
      for (int i = 0; i < 3; ++i) {
        const bool far = (c >> i & 1) != 0;
        w[i] = far ? t[i] : 1 - t[i];
        d[i] = (far ? 1 : -1) / grid.spacing;
      }
      weight[c] = w[0] * w[1] * w[2];
      slope[c] = Vec3(d[0] * w[1] * w[2], w[0] * d[1] * w[2], w[0] * w[1] * d[2]);
    }
  }

  std::size_t node(const Grid& grid, int corner) const {
    return (static_cast<std::size_t>(cell[2] + (corner >> 2 & 1)) * grid.nodes[1] + cell[1] +
            (corner >> 1 & 1)) *
               grid.nodes[0] +
           cell[0] + (corner & 1);
  }
};

/// The equations of one grid. The unknowns are numbered in the order of their nodes. Neighbours of
/// unknowns are among them, with values that don't change.
class Equations {
 public:
  Equations(const Grid& grid, const std::vector<std::uint8_t>& active);
  void add_samples(const ScanSamples& samples, const std::vector<double>& trust, double smoothing);
  /// Improves the grid's values, at most `rounds` times.
  void solve(Grid& grid, int rounds) const;

 private:
  using Row = std::array<double, 27>;

  void apply(const std::vector<double>& x, std::vector<double>& bent, std::vector<double>& y) const;
  void stencil(const std::vector<double>& x, std::vector<double>& bent) const;
  double bent_here(const std::vector<double>& bent, std::size_t i) const {
    const std::array<int, 6>& n = near_[i];
    return bent[n[0]] + bent[n[1]] + bent[n[2]] + bent[n[3]] + bent[n[4]] + bent[n[5]] -
           6 * bent[i];
  }

  const Grid& grid_;
  std::vector<std::size_t> node_;           // per number; one more number stands for no node
  std::vector<std::uint8_t> unknown_;       // per number
  std::vector<std::array<int, 6>> near_;    // per number
  std::vector<int> number_;                 // per node, -1: none
  std::vector<int> row_of_;                 // per number, -1: no sample is near
  std::vector<int> row_number_;             // per row
  std::vector<Row> rows_;                   // of the samples' terms, by neighbour
  std::vector<std::array<int, 27>> reach_;  // per row, the neighbours' numbers
  std::vector<double> wanted_;              // per row
  double stiffness_ = 0;
};

Equations::Equations(const Grid& grid, const std::vector<std::uint8_t>& active)
    : grid_(grid), number_(grid.size(), -1) {
  const auto steps = grid.steps();
  std::vector<std::uint8_t> held(grid.size(), 0);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (active[i] == 0) continue;
    held[i] = 1;
    for (const std::ptrdiff_t step : steps) held[i + step] = held[i - step] = 1;
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (held[i] == 0) continue;
    number_[i] = static_cast<int>(node_.size());
    node_.push_back(i);
    unknown_.push_back(active[i]);
  }
  const int none = static_cast<int>(node_.size());
  near_.resize(node_.size());
  in_chunks(node_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (int k = 0; k < 6; ++k) {
        const std::ptrdiff_t step = k % 2 == 0 ? steps[k / 2] : -steps[k / 2];
        const int other = number_[node_[i] + step];
        near_[i][k] = other < 0 ? none : other;
      }
    }
  });
  row_of_.assign(node_.size(), -1);
}

void Equations::add_samples(const ScanSamples& samples, const std::vector<double>& trust,
                            double smoothing) {
  stiffness_ = smoothing * smoothing * smoothing / grid_.spacing;
  // Of slopes against values.
  const double turn = std::pow(std::max(smoothing, slope_length), 2);
  for (std::size_t s = 0; s < samples.points.size(); ++s) {
    const Place place(grid_, samples.points[s]);
    std::array<int, 8> number;
    for (int c = 0; c < 8; ++c) {
      number[c] = number_[place.node(grid_, c)];
      if (number[c] < 0 || row_of_[number[c]] >= 0) continue;
      row_of_[number[c]] = static_cast<int>(rows_.size());
      row_number_.push_back(number[c]);
      rows_.push_back({});
      wanted_.push_back(0);
    }
    const double weight = samples.areas[s] * trust[s];
    const double slope_weight = weight * turn * samples.flatness[s];
    for (int a = 0; a < 8; ++a) {
      if (number[a] < 0) continue;
      const int row = row_of_[number[a]];
      wanted_[row] += slope_weight * place.slope[a].dot(samples.normals[s]);
      for (int b = 0; b < 8; ++b) {
        int offset = 0;
        for (int i = 2; i >= 0; --i) offset = 3 * offset + (b >> i & 1) - (a >> i & 1) + 1;
        rows_[row][offset] += weight * place.weight[a] * place.weight[b] +
                              slope_weight * place.slope[a].dot(place.slope[b]);
      }
    }
  }
  const auto steps = grid_.steps();
  const int none = static_cast<int>(node_.size());
  reach_.resize(rows_.size());
  in_chunks(rows_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const auto at = static_cast<std::ptrdiff_t>(node_[row_number_[r]]);
      for (int k = 0; k < 27; ++k) {
        const std::ptrdiff_t other =
            at + (k % 3 - 1) * steps[0] + (k / 3 % 3 - 1) * steps[1] + (k / 9 - 1) * steps[2];
        const bool is_there = other >= 0 && other < static_cast<std::ptrdiff_t>(grid_.size());
        const int number = is_there ? number_[other] : -1;
        reach_[r][k] = number < 0 ? none : number;
      }
    }
  });
}

/// Sums the second differences of `x` at every number.
void Equations::stencil(const std::vector<double>& x, std::vector<double>& bent) const {
  in_chunks(node_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) bent[i] = bent_here(x, i);
  });
}

void Equations::apply(const std::vector<double>& x, std::vector<double>& bent,
                      std::vector<double>& y) const {
  stencil(x, bent);
  in_chunks(node_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (unknown_[i] == 0) {
        y[i] = 0;
        continue;
      }
      double sum = stiffness_ * bent_here(bent, i);
      if (const int row = row_of_[i]; row >= 0) {
        for (int k = 0; k < 27; ++k) sum += rows_[row][k] * x[reach_[row][k]];
      }
      y[i] = sum;
    }
  });
}

void Equations::solve(Grid& grid, int rounds) const {
  const std::size_t count = node_.size();
  const std::size_t all = count + 1;  // the last stands for nodes without a number and stays 0
  const auto steps = grid.steps();
  std::vector<double> residual(all, 0);
  std::vector<double> scale(all, 0);
  std::vector<double> bent(all, 0);
  in_chunks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = node_[i];
      double sum = -6.0 * grid.values[at];
      for (const std::ptrdiff_t step : steps) {
        sum += static_cast<double>(grid.values[at + step]) + grid.values[at - step];
      }
      bent[i] = sum;
    }
  });
  in_chunks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (unknown_[i] == 0) continue;
      double sum = -stiffness_ * bent_here(bent, i);
      scale[i] = 42 * stiffness_;
      if (const int row = row_of_[i]; row >= 0) {
        sum += wanted_[row];
        scale[i] += rows_[row][13];
        for (int k = 0; k < 27; ++k) {
          if (const int other = reach_[row][k]; other < static_cast<int>(count)) {
            sum -= rows_[row][k] * grid.values[node_[other]];
          }
        }
      }
      residual[i] = sum;
    }
  });
  std::vector<double> x(all, 0);
  std::vector<double> z(all, 0);
  std::vector<double> p(all, 0);
  std::vector<double> ap(all, 0);
  const auto precondition = [&] {
    in_chunks(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) z[i] = unknown_[i] ? residual[i] / scale[i] : 0;
    });
  };
  precondition();
  p = z;
  double rz = dot(residual, z);
  const double enough = 1e-6 * rz;
  for (int round = 0; round < rounds && rz > enough; ++round) {
    apply(p, bent, ap);
    const double step = rz / dot(p, ap);
    in_chunks(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        x[i] += step * p[i];
        residual[i] -= step * ap[i];
      }
    });
    precondition();
    const double next = dot(residual, z);
    const double turn = next / rz;
    rz = next;
    in_chunks(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + turn * p[i];
    });
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (unknown_[i]) grid.values[node_[i]] += static_cast<float>(x[i]);
  }
}

/// The grid with half the spacing, cubic between the coarse nodes.
Grid refined(const Grid& coarse) {
  Grid grid = coarse;
  for (int axis = 0; axis < 3; ++axis) {
    Grid next = grid;
    next.nodes[axis] = 2 * grid.nodes[axis] - 1;
    next.values.assign(next.size(), 0);
    const std::ptrdiff_t step = grid.steps()[axis];
    const int last = grid.nodes[axis] - 1;
    parallel_for(static_cast<std::size_t>(next.nodes[2]), [&](std::size_t z) {
      for (int y = 0; y < next.nodes[1]; ++y) {
        for (int x = 0; x < next.nodes[0]; ++x) {
          std::array<int, 3> at = {x, y, static_cast<int>(z)};
          const bool between = at[axis] % 2 != 0;
          at[axis] /= 2;
          const float* const from =
              &grid.values[(static_cast<std::size_t>(at[2]) * grid.nodes[1] + at[1]) *
                               grid.nodes[0] +
                           at[0]];
          float value = *from;
          if (between) {
            value = (value + from[step]) / 2;
            if (at[axis] > 0 && at[axis] + 1 < last) {
              value += (*from + from[step] - from[-step] - from[2 * step]) / 16;
            }
          }
          next.values[(z * next.nodes[1] + y) * next.nodes[0] + x] = value;
        }
      }
    });
    grid = std::move(next);
  }
  grid.spacing = coarse.spacing / 2;
  return grid;
}

/// The first grid: distances to the samples, without a sign.
Grid first_grid(const ScanSamples& samples, double spacing) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : samples.points) box.extend(p);
  Grid grid;
  grid.spacing = spacing;
  for (int i = 0; i < 3; ++i) {
    const int cells = static_cast<int>(std::ceil(box.sizes()[i] / spacing)) + 2 * (border + 2);
    grid.nodes[i] = cells + 1;
    grid.origin[i] = box.center()[i] - cells * spacing / 2;
  }
  const std::vector<Vec3> near = ScanCells(samples.points, spacing).means();
  grid.values.resize(grid.size());
  parallel_for(static_cast<std::size_t>(grid.nodes[2]), [&](std::size_t z) {
    std::size_t i = z * grid.nodes[1] * grid.nodes[0];
    for (int y = 0; y < grid.nodes[1]; ++y) {
      for (int x = 0; x < grid.nodes[0]; ++x, ++i) {
        const Vec3 at = grid.origin + spacing * Vec3(x, y, static_cast<double>(z));
        double least = std::numeric_limits<double>::max();
        for (const Vec3& p : near) least = std::min(least, (p - at).squaredNorm());
        grid.values[i] = static_cast<float>(std::sqrt(least));
      }
    }
  });
  return grid;
}

/// Which nodes of a grid are solved for: all of a coarse one, and those near the surface of a fine
/// one.
std::vector<std::uint8_t> active_nodes(const Grid& grid, double band, const ScanSamples& samples) {
  std::vector<std::uint8_t> active(grid.size(), 0);
  const auto may = [&](int x, int y, int z) {
    return x >= border && y >= border && z >= border && x < grid.nodes[0] - border &&
           y < grid.nodes[1] - border && z < grid.nodes[2] - border;
  };
  parallel_for(static_cast<std::size_t>(grid.nodes[2]), [&](std::size_t z) {
    std::size_t i = z * grid.nodes[1] * grid.nodes[0];
    for (int y = 0; y < grid.nodes[1]; ++y) {
      for (int x = 0; x < grid.nodes[0]; ++x, ++i) {
        active[i] = std::abs(grid.values[i]) < band && may(x, y, static_cast<int>(z));
      }
    }
  });
  for (const Vec3& p : samples.points) {
    const Place place(grid, p);
    for (int c = 0; c < 8; ++c) {
      if (may(place.cell[0] + (c & 1), place.cell[1] + (c >> 1 & 1), place.cell[2] + (c >> 2))) {
        active[place.node(grid, c)] = 1;
      }
    }
  }
  return active;
}

/// How far each sample is believed. Those far off the surface of the coarser grid are strays
/// [Geman & McClure 1987].
std::vector<double> trust_in(const ScanSamples& samples, const Grid& grid, double reach) {
  std::vector<double> trust(samples.points.size(), 1);
  parallel_for_chunks(trust.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Place place(grid, samples.points[s]);
      double off = 0;
      for (int c = 0; c < 8; ++c) off += place.weight[c] * grid.values[place.node(grid, c)];
      const double share = 1 + off * off / (reach * reach);
      trust[s] = 1 / (share * share);
    }
  });
  return trust;
}

}  // namespace

SmoothDistance::SmoothDistance(const ScanSamples& samples, const SmoothDistanceOptions& options) {
  int levels = 1;
  while (options.spacing * (1 << levels) < coarsest * 1.5) ++levels;
  Grid grid = first_grid(samples, options.spacing * (1 << (levels - 1)));
  for (int level = 0; level < levels; ++level) {
    if (level > 0) grid = refined(grid);
    const double band = level == 0 ? std::numeric_limits<double>::max() : 6 * grid.spacing;
    // Coarse grids miss hands and feet. Only the last one may call their points strays.
    const bool is_last = level + 1 == levels;
    const std::vector<double> trust =
        is_last ? trust_in(samples, grid, std::max(4 * samples.noise, 2 * grid.spacing))
                : std::vector<double>(samples.points.size(), 1);
    Equations equations(grid, active_nodes(grid, band, samples));
    equations.add_samples(samples, trust,
                          std::max(options.smoothing, coarse_smoothing * grid.spacing));
    equations.solve(grid, level == 0 ? 800 : level == 1 ? 300 : level == 2 ? 120 : 60);
  }
  spacing_ = grid.spacing;
  origin_ = grid.origin;
  nodes_ = grid.nodes;
  values_ = std::move(grid.values);
  low_ = origin_ + 2 * spacing_ * Vec3::Ones();
  for (int i = 0; i < 3; ++i) high_[i] = origin_[i] + (nodes_[i] - 3) * spacing_;
}

double SmoothDistance::operator()(const Vec3& point) const {
  std::array<int, 3> cell;
  std::array<std::array<double, 4>, 3> w;
  for (int i = 0; i < 3; ++i) {
    const double at = std::clamp((point[i] - origin_[i]) / spacing_, 1.0, nodes_[i] - 2.001);
    cell[i] = static_cast<int>(at);
    const double t = at - cell[i];
    // Catmull-Rom: cubic, with continuous slopes.
    w[i] = {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2,
            (t - 1) * t * t / 2};
  }
  double sum = 0;
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      const float* const row =
          &values_[(static_cast<std::size_t>(cell[2] + z - 1) * nodes_[1] + cell[1] + y - 1) *
                       nodes_[0] +
                   cell[0] - 1];
      sum += w[2][z] * w[1][y] *
             (w[0][0] * row[0] + w[0][1] * row[1] + w[0][2] * row[2] + w[0][3] * row[3]);
    }
  }
  return sum;
}

}  // namespace toile
