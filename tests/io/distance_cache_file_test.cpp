#include "io/distance_cache_file.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/error.h"
#include "io/output_file.h"
#include "tests/support/run_program.h"
#include "tests/support/shapes.h"

namespace toile {
namespace distance_cache_file_test {

class KnownDistancesFile : public testing::Test {
 protected:
  KnownDistancesFile() {
    cache.cell = 0.005;
    cache.band = 0.01;
    cache.first = {-1, 3, -5};
    cache.size = {12, 16, 20};
    for (int l = 0; l < 3; ++l) {
      for (int c = 0; c < 2 + l; ++c) {
        DistanceCache::Cube cube{5 * c + l, {}};
        for (int i = 0; i < 64; ++i) cube.values[i] = 0.1F * static_cast<float>(i - l) / 3;
        cache.levels[l].push_back(cube);
      }
    }
    write_distance_cache(path, body, cache);
  }

  const pipeline::ScratchFolder folder;
  const std::filesystem::path path = folder / "body.distances";
  const TriangleMesh body = test::sphere(0.1, 2);
  DistanceCache cache;
};

TEST_F(KnownDistancesFile, ReadsBackWhatWasWritten) {
  const auto read = read_distance_cache(path, body);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->cell, cache.cell);
  EXPECT_EQ(read->band, cache.band);
  EXPECT_EQ(read->first, cache.first);
  EXPECT_EQ(read->size, cache.size);
  for (int l = 0; l < 3; ++l) {
    ASSERT_EQ(read->levels[l].size(), cache.levels[l].size());
    for (std::size_t c = 0; c < cache.levels[l].size(); ++c) {
      EXPECT_EQ(read->levels[l][c].number, cache.levels[l][c].number);
      EXPECT_EQ(read->levels[l][c].values, cache.levels[l][c].values);
    }
  }
}

TEST_F(KnownDistancesFile, IsOfThisBodyOnly) {
  TriangleMesh moved = body;
  moved.points.back().x() += 1e-15;
  EXPECT_FALSE(read_distance_cache(path, moved).has_value());
  TriangleMesh turned = body;
  std::rotate(turned.triangles[0].begin(), turned.triangles[0].begin() + 1,
              turned.triangles[0].end());
  EXPECT_FALSE(read_distance_cache(path, turned).has_value());
}

TEST_F(KnownDistancesFile, SaysNothingWhenDamaged) {
  const std::string whole = read_file(path);
  EXPECT_FALSE(read_distance_cache(folder / "none", body).has_value());
  for (std::size_t kept = 0; kept < whole.size(); kept += 7) {
    write_file(path, whole.substr(0, kept));
    ASSERT_FALSE(read_distance_cache(path, body).has_value()) << kept;
  }
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] ^= static_cast<char>(1U << random() % 8);
    write_file(path, damaged);
    ASSERT_FALSE(read_distance_cache(path, body).has_value());
  }
  write_file(path, whole + "more");
  EXPECT_FALSE(read_distance_cache(path, body).has_value());
  write_file(path, whole);
  EXPECT_TRUE(read_distance_cache(path, body).has_value());
}

}  // namespace distance_cache_file_test
}  // namespace toile
