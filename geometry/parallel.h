// Parallel work whose results don't depend on the threads. A task has a fixed size, and writes what
// belongs to it alone.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cstddef>

namespace toile {

/// Vertices that one task handles. With 512, a coarse mesh is a single task, and a T-shirt at 10 mm
/// takes 1.3 times as long on two cores. 32 to 256 take the same time there. With 128, the coarse
/// meshes of a preview make two or three tasks, and one core gets twice as many as the other.
inline constexpr std::size_t vertex_chunk = 64;

/// Number of chunks of `size` items that hold all `items`.
inline std::size_t chunks_of(std::size_t items, std::size_t size) {
  return (items + size - 1) / size;
}

/// Calls `body(task)` for each task in [0, tasks), in parallel where there are two or more.
template <typename Body>
void parallel_for(std::size_t tasks, const Body& body) {
  if (tasks < 2) {
    for (std::size_t t = 0; t < tasks; ++t) body(t);
    return;
  }
  tbb::parallel_for(std::size_t{0}, tasks, body, tbb::static_partitioner());
}

/// Calls `body(item)` for each item in [0, items), in parallel. Threads take items from each other,
/// which pays where their costs differ much. A single item is worth a task, if need be.
template <typename Index, typename Body>
void parallel_for_items(Index items, const Body& body) {
  tbb::parallel_for(Index{0}, items, body);
}

/// Calls `body(begin, end)` for ranges of `grain` items that together cover [0, items). Threads
/// take ranges from each other.
template <typename Body>
void parallel_for_ranges(std::size_t items, std::size_t grain, const Body& body) {
  parallel_for_items(chunks_of(items, grain),
                     [&](std::size_t c) { body(c * grain, std::min(items, (c + 1) * grain)); });
}

/// Calls all of `works`, in parallel.
template <typename... Works>
void parallel_invoke(const Works&... works) {
  tbb::parallel_invoke(works...);
}

/// Calls `body(begin, end)` for ranges of vertex_chunk items that together cover [0, items).
template <typename Body>
void parallel_for_chunks(std::size_t items, const Body& body) {
  parallel_for(chunks_of(items, vertex_chunk), [&](std::size_t c) {
    body(c * vertex_chunk, std::min(items, (c + 1) * vertex_chunk));
  });
}

}  // namespace toile
