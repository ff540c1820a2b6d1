// Loops over flat arrays in pieces of fixed size, so that no sum depends on the number of threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace toile {

/// Enough work for a task to be worth its start, few enough for two cores to share a garment.
inline constexpr int spring_chunk = 512;

inline int chunks_of(int items) { return (items + spring_chunk - 1) / spring_chunk; }

/// Calls work(chunk, first, last) for every chunk of [0, items).
template <typename Work>
void in_spring_chunks(int items, const Work& work) {
  if (items <= spring_chunk) {
    if (items > 0) work(0, 0, items);
    return;
  }
  tbb::parallel_for(0, chunks_of(items), [&](int c) {
    work(c, c * spring_chunk, std::min(items, (c + 1) * spring_chunk));
  });
}

}  // namespace toile
