// dress --cache: what is kept of a body, and that it changes nothing.
#include <gtest/gtest.h>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace cache_test {

class Cache : public WornSample {
 protected:
  void SetUp() override {
    make_body();
    mesh(sample("tube_top"), "40mm");
    expect_same("without", {}, "");
    all = computed("without");
  }

  /// Dresses as NAME; the garment has to be what it is without.
  void expect_same(const std::string& name, std::vector<std::string> options,
                   const std::string& warning) const {
    options.insert(options.end(), {"--quality", "draft"});
    const auto done = dress(name, options);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(read_text(folder / (name + ".obj")), read_text(folder / "without.obj")) << name;
    EXPECT_NE(done.err.find(warning), std::string::npos) << done.err;
  }

  int computed(const std::string& name) const { return report(name)["body_distances_computed"]; }

  const fs::path cache = folder / "body.distances";
  const fs::path raised = folder / "body.raised.distances";
  int all = 0;
};

TEST_F(Cache, IsKeptWhenAskedForAndChangesNothing) {
  EXPECT_GT(all, 0);
  EXPECT_FALSE(fs::exists(cache));
  expect_same("first", {"--cache"}, "");
  EXPECT_EQ(computed("first"), all);
  EXPECT_TRUE(fs::exists(cache));
  EXPECT_TRUE(fs::exists(raised));
  const auto written = fs::last_write_time(raised);
  expect_same("second", {"--cache"}, "");
  EXPECT_EQ(computed("second"), 0);
  EXPECT_EQ(fs::last_write_time(raised), written);
}

TEST_F(Cache, OfAnotherBodyIsMadeAnew) {
  const std::string own = ".own";
  for (const char* file : {"body.ply", "body.body.json"})
    fs::copy(folder / file, folder / (file + own));
  succeed("make-mannequin", {"-o", body, "--pose", "walking", "-q"});
  ASSERT_EQ(dress("other", {"--cache", "--quality", "draft"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(cache));
  for (const char* file : {"body.ply", "body.body.json"})
    fs::rename(folder / (file + own), folder / file);
  expect_same("after_another", {"--cache"}, "");
  EXPECT_EQ(computed("after_another"), all);
  expect_same("again", {"--cache"}, "");
  EXPECT_EQ(computed("again"), 0);
}

TEST_F(Cache, ThatCannotBeKeptIsAWarning) {
  fs::create_directory(cache);
  expect_same("nowhere", {"--cache"}, "are not kept");
  EXPECT_EQ(computed("nowhere"), all);
}

}  // namespace cache_test
}  // namespace toile::pipeline
