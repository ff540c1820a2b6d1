#include "io/distance_cache_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/output_file.h"

namespace toile {

namespace {

using Checksum = std::uint64_t;
using Cube = DistanceCache::Cube;
constexpr std::size_t levels = std::tuple_size_v<decltype(DistanceCache::levels)>;

/// The standard library's hash. A file written with another library fails the check and is not
/// used.
Checksum checksum(const void* bytes, std::size_t count) {
  return std::hash<std::string_view>{}({static_cast<const char*>(bytes), count});
}

template <class T>
Checksum checksum_of(const std::vector<T>& items) {
  return checksum(items.data(), items.size() * sizeof(T));
}

/// What a file begins with; the cubes of each level follow.
struct Head {
  /// The version in it changes with the format of the rest of the file.
  std::array<char, 24> magic = {"toile body distances 2\n"};
  /// A machine of the other byte order reads another number and rejects the file.
  std::uint64_t byte_order = 0x0102030405060708;
  Checksum of_points = 0;  ///< of the body
  Checksum of_triangles = 0;
  double cell = 0;
  double band = 0;
  std::array<int, 3> first = {};
  std::array<int, 3> size = {};
  std::array<std::uint64_t, levels> cubes = {};
  std::array<Checksum, levels> of_cubes = {};
  Checksum of_head = 0;  ///< of all that stands before

  Checksum sum() const { return checksum(this, sizeof(Head) - sizeof(Checksum)); }
  bool is_of(const Head& body) const {
    return magic == body.magic && byte_order == body.byte_order && of_points == body.of_points &&
           of_triangles == body.of_triangles && of_head == sum();
  }
  std::uint64_t all_cubes() const {
    return std::accumulate(cubes.begin(), cubes.end(), std::uint64_t{0});
  }
};
static_assert(sizeof(Head) == 144, "has gaps, whose bytes are anything");
static_assert(std::is_trivially_copyable_v<Head> && std::is_trivially_copyable_v<Cube>);

Head head_of(const TriangleMesh& body) {
  Head head;
  head.of_points = checksum_of(body.points);
  head.of_triangles = checksum_of(body.triangles);
  return head;
}

template <class T>
bool read(std::ifstream& file, T* items, std::size_t count) {
  return static_cast<bool>(
      file.read(reinterpret_cast<char*>(items), static_cast<std::streamsize>(count * sizeof(T))));
}

}  // namespace

void write_distance_cache(const std::filesystem::path& path, const TriangleMesh& body,
                          const DistanceCache& cache) {
  Head head = head_of(body);
  head.cell = cache.cell;
  head.band = cache.band;
  head.first = cache.first;
  head.size = cache.size;
  for (std::size_t l = 0; l < levels; ++l) {
    head.cubes[l] = cache.levels[l].size();
    head.of_cubes[l] = checksum_of(cache.levels[l]);
  }
  head.of_head = head.sum();
  std::string bytes;
  bytes.reserve(sizeof head + head.all_cubes() * sizeof(Cube));
  bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
  for (const std::vector<Cube>& cubes : cache.levels) {
    bytes.append(reinterpret_cast<const char*>(cubes.data()), cubes.size() * sizeof(Cube));
  }
  write_file(path, bytes);
}

std::optional<DistanceCache> read_distance_cache(const std::filesystem::path& path,
                                                 const TriangleMesh& body) {
  std::ifstream file(path, std::ios::binary);
  Head head;
  if (!file || !read(file, &head, 1) || !head.is_of(head_of(body))) return std::nullopt;
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(path, failed);
  const std::uint64_t most = (size - sizeof head) / sizeof(Cube);  // so that no sum overflows
  if (failed || std::ranges::any_of(head.cubes, [&](auto count) { return count > most; }) ||
      size != sizeof head + head.all_cubes() * sizeof(Cube)) {
    return std::nullopt;
  }
  DistanceCache cache{head.cell, head.band, head.first, head.size, {}};
  for (std::size_t l = 0; l < levels; ++l) {
    // Read in place: there are tens of megabytes of them.
    cache.levels[l].resize(head.cubes[l]);
    if (!read(file, cache.levels[l].data(), head.cubes[l]) ||
        checksum_of(cache.levels[l]) != head.of_cubes[l]) {
      return std::nullopt;
    }
  }
  return cache;
}

}  // namespace toile
