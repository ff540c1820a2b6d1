#include "cloth/relaxation/aggregates.h"

#include <algorithm>

namespace toile {

namespace {

using Shares = std::vector<AggregateShare>;

void sort_unique(Neighbours& neighbours) {
  for (std::vector<int>& of : neighbours) {
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  }
}

void add(Shares& shares, int aggregate, double weight) {
  const auto known = std::find_if(shares.begin(), shares.end(), [&](const AggregateShare& share) {
    return share.aggregate == aggregate;
  });
  if (known == shares.end()) {
    shares.push_back({aggregate, weight});
  } else {
    known->weight += weight;
  }
}

/// The mean of each vertex's shares and of the mean shares of its neighbours.
std::vector<Shares> smoothed(const std::vector<Shares>& shares, const Neighbours& vertices) {
  std::vector<Shares> smooth(shares.size());
  for (std::size_t v = 0; v < shares.size(); ++v) {
    const double own = vertices[v].empty() ? 1 : 0.5;
    for (const auto& [aggregate, weight] : shares[v]) add(smooth[v], aggregate, own * weight);
    for (const int other : vertices[v]) {
      for (const auto& [aggregate, weight] : shares[other]) {
        add(smooth[v], aggregate, 0.5 * weight / static_cast<double>(vertices[v].size()));
      }
    }
  }
  return smooth;
}

}  // namespace

Neighbours neighbours_of(const std::vector<Triangle>& triangles, std::size_t vertices) {
  Neighbours neighbours(vertices);
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      neighbours[t[i]].push_back(t[(i + 1) % 3]);
      neighbours[t[i]].push_back(t[(i + 2) % 3]);
    }
  }
  sort_unique(neighbours);
  return neighbours;
}

Aggregates aggregate(const Neighbours& vertices) {
  Aggregates aggregates;
  std::vector<int> aggregate_around(vertices.size(), -1);
  std::vector<char> taken(vertices.size(), 0);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (taken[v] != 0) continue;
    aggregate_around[v] = static_cast<int>(aggregates.middles.size());
    aggregates.middles.push_back(static_cast<int>(v));
    for (const int other : vertices[v]) taken[other] = 1;
  }
  std::vector<Shares> shares(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (aggregate_around[v] >= 0) {
      shares[v] = {{aggregate_around[v], 1}};
      continue;
    }
    for (const int other : vertices[v]) {
      if (aggregate_around[other] >= 0) shares[v].push_back({aggregate_around[other], 1});
    }
    for (AggregateShare& share : shares[v]) share.weight /= static_cast<double>(shares[v].size());
  }
  aggregates.neighbours.resize(aggregates.middles.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (const int other : vertices[v]) {
      for (const AggregateShare& here : shares[v]) {
        for (const AggregateShare& there : shares[other]) {
          if (here.aggregate != there.aggregate)
            aggregates.neighbours[here.aggregate].push_back(there.aggregate);
        }
      }
    }
  }
  sort_unique(aggregates.neighbours);
  const std::vector<Shares> smooth = smoothed(shares, vertices);
  aggregates.of_vertices.assign(vertices.size(), [&](const auto& list) {
    for (std::size_t v = 0; v < smooth.size(); ++v) {
      for (const AggregateShare& share : smooth[v]) list(v, share);
    }
  });
  return aggregates;
}

}  // namespace toile
