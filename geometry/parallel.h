// Work in parts of fixed size, so that results don't depend on the threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace toile {

/// Vertices that one task handles. With 512 a coarse mesh is a single task: a T-shirt at 10 mm
/// takes 1.3 times as long on two cores; 32 to 256 are alike there, but with 128 the coarse meshes
/// of a preview fall into two or three tasks, of which one core has twice as many.
inline constexpr std::size_t vertex_chunk = 64;

inline std::size_t chunks_of(std::size_t items, std::size_t size) {
  return (items + size - 1) / size;
}

/// Runs `work` for each of `tasks`, side by side where that pays.
template <typename Work>
void parallel_for(std::size_t tasks, const Work& work) {
  if (tasks < 2) {
    for (std::size_t t = 0; t < tasks; ++t) work(t);
    return;
  }
  tbb::parallel_for(std::size_t{0}, tasks, work, tbb::static_partitioner());
}

/// Runs `work(begin, end)` for ranges of as many vertices, which make up all of `items`.
template <typename Work>
void parallel_for_chunks(std::size_t items, const Work& work) {
  parallel_for(chunks_of(items, vertex_chunk), [&](std::size_t c) {
    work(c * vertex_chunk, std::min(items, (c + 1) * vertex_chunk));
  });
}

}  // namespace toile
