#include "io/sidecar.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/output_file.h"

namespace toile {
namespace sidecar_test {

namespace fs = std::filesystem;

class Sidecar : public testing::Test {
 protected:
  Sidecar() : folder_(fs::temp_directory_path() / ("toile-sidecar-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~Sidecar() override { fs::remove_all(folder_); }

  /// The name of what is read for tank.v2.obj.
  std::string found() const {
    const auto is_kite = [](const JsonValue& root) {
      return root.is_object() && root.find("kite");
    };
    return sidecar_beside(folder_ / "tank.v2.obj", "kite", is_kite).filename().string();
  }

  fs::path folder_;
};

TEST_F(Sidecar, HasItsKindInItsName) {
  EXPECT_EQ(sidecar_path("some/tank.v2.obj", "kite"), fs::path("some/tank.v2.kite.json"));
  EXPECT_EQ(found(), "tank.v2.kite.json");
}

TEST_F(Sidecar, OfAnEarlierVersionIsReadWhereThereIsNoOther) {
  write_file(folder_ / "tank.v2.json", R"({"kite": 1})");
  EXPECT_EQ(found(), "tank.v2.json");
  // Whatever is in the other: its reader says what is wrong with it.
  write_file(folder_ / "tank.v2.kite.json", "");
  EXPECT_EQ(found(), "tank.v2.kite.json");
}

TEST_F(Sidecar, IsNotWhatHasTheEarlierNameOnly) {
  const fs::path earlier = folder_ / "tank.v2.json";
  write_file(earlier, R"({"pattern": {}})");
  EXPECT_EQ(found(), "tank.v2.kite.json");
  fs::remove(earlier);
  fs::create_directory(earlier);
  EXPECT_EQ(found(), "tank.v2.kite.json");
}

TEST_F(Sidecar, OfAnEarlierVersionThatIsDamagedIsReadAndRefused) {
  write_file(folder_ / "tank.v2.json", R"({"kite": )");
  EXPECT_EQ(found(), "tank.v2.json");
}

}  // namespace sidecar_test
}  // namespace toile
