// Numbers at the nodes of a box of a grid, each computed on first use.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace toile {

/// A number for each node of a box, 0 until it is stored. Only the pages of stored numbers take
/// memory. Several threads may store and load at once.
class NodeValues {
 public:
  using Index = std::array<int, 3>;

  NodeValues() = default;
  /// Nodes from `first` on, `size` along each axis, with indices of any sign.
  NodeValues(const Index& first, const Index& size) : first_(first), size_(size) {
    // calloc() gives zeros, and pages that nobody writes to take no memory.
    values_.reset(static_cast<float*>(std::calloc(count() + overhang, sizeof(float))));
    if (values_ == nullptr) throw std::bad_alloc();
  }

  const Index& first() const { return first_; }
  const Index& size() const { return size_; }
  std::size_t count() const { return static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]; }
  /// The place of a node in the order of storage: along x first, then y, then z.
  std::size_t place(const Index& node) const {
    return (static_cast<std::size_t>(node[2] - first_[2]) * size_[1] + (node[1] - first_[1])) *
               size_[0] +
           (node[0] - first_[0]);
  }
  float load(std::size_t place) const {
    return std::atomic_ref(values_[place]).load(std::memory_order_relaxed);
  }
  /// Returns what was stored before.
  float store(std::size_t place, float value) {
    return std::atomic_ref(values_[place]).exchange(value, std::memory_order_relaxed);
  }
  /// All numbers, to read several at once. Each is whole: 0 or what was stored. Three more may be
  /// read than there are.
  const float* data() const { return values_.get(); }

 private:
  static constexpr std::size_t overhang = 3;
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };

  Index first_ = {0, 0, 0};
  Index size_ = {0, 0, 0};
  std::unique_ptr<float[], Free> values_;
};

}  // namespace toile
