#include "io/distance_cache_file.h"

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

namespace {

using Checksum = std::uint64_t;
using Count = std::uint64_t;

/// The version in it changes with the format of the rest of the file.
constexpr char magic[] = "toile body distances 1\n";
/// A machine of the other byte order reads another number and rejects the file.
constexpr std::uint32_t byte_order = 0x01020304;

/// The standard library's hash. A file written with another library fails the check and is not
/// used.
Checksum checksum(const void* bytes, std::size_t count) {
  return std::hash<std::string_view>{}({static_cast<const char*>(bytes), count});
}

template <class T>
void append(std::string& bytes, const T* items, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(items), count * sizeof(T));
}

std::string head_of(const TriangleMesh& body) {
  std::string head = magic;
  append(head, &byte_order, 1);
  const Checksum of_body[] = {
      checksum(body.points.data(), body.points.size() * sizeof(body.points[0])),
      checksum(body.triangles.data(), body.triangles.size() * sizeof(body.triangles[0]))};
  append(head, of_body, 2);
  return head;
}

/// Moves `count` items from the front of `bytes` to `items`. False when there are too few bytes.
template <class T>
bool take(std::string_view& bytes, T* items, std::size_t count) {
  if (bytes.size() / sizeof(T) < count) return false;
  if (count > 0) std::memcpy(items, bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

}  // namespace

void write_distance_cache(const std::filesystem::path& path, const TriangleMesh& body,
                          const DistanceCache& cache) {
  std::string bytes = head_of(body);
  append(bytes, &cache.cell, 1);
  append(bytes, &cache.band, 1);
  append(bytes, cache.first.data(), cache.first.size());
  append(bytes, cache.size.data(), cache.size.size());
  for (const auto& cubes : cache.levels) {
    const Count count = cubes.size();
    append(bytes, &count, 1);
    append(bytes, cubes.data(), cubes.size());
  }
  const Checksum of_all = checksum(bytes.data(), bytes.size());
  append(bytes, &of_all, 1);
  write_file(path, bytes);
}

std::optional<DistanceCache> read_distance_cache(const std::filesystem::path& path,
                                                 const TriangleMesh& body) {
  std::string content;
  try {
    content = read_file(path);
  } catch (const Error&) {
    return std::nullopt;
  }
  std::string_view bytes = content;
  const std::string head = head_of(body);
  Checksum of_all = 0;
  if (!bytes.starts_with(head) || bytes.size() < head.size() + sizeof of_all) return std::nullopt;
  std::memcpy(&of_all, bytes.data() + bytes.size() - sizeof of_all, sizeof of_all);
  bytes.remove_suffix(sizeof of_all);
  if (of_all != checksum(bytes.data(), bytes.size())) return std::nullopt;
  bytes.remove_prefix(head.size());
  DistanceCache cache;
  if (!take(bytes, &cache.cell, 1) || !take(bytes, &cache.band, 1) ||
      !take(bytes, cache.first.data(), cache.first.size()) ||
      !take(bytes, cache.size.data(), cache.size.size())) {
    return std::nullopt;
  }
  for (auto& cubes : cache.levels) {
    Count count = 0;
    if (!take(bytes, &count, 1) || count > bytes.size() / sizeof(DistanceCache::Cube)) {
      return std::nullopt;
    }
    cubes.resize(count);
    if (!take(bytes, cubes.data(), count)) return std::nullopt;
  }
  return cache;
}

}  // namespace toile
