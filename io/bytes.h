// Numbers as bytes of either order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace toile {

/// The number that the sizeof(Number) bytes from `bytes` on hold in `order`.
template <class Number>
Number load(const char* bytes, std::endian order) {
  static_assert(std::is_arithmetic_v<Number>);
  char turned[sizeof(Number)];
  std::memcpy(turned, bytes, sizeof turned);
  if (order != std::endian::native) std::reverse(turned, turned + sizeof turned);
  Number value;
  std::memcpy(&value, turned, sizeof value);
  return value;
}

/// Appends `value` in little-endian order.
template <class Number>
void store(std::string& bytes, Number value) {
  static_assert(std::is_arithmetic_v<Number>);
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof raw);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof raw);
  bytes.append(raw, sizeof raw);
}

}  // namespace toile
