#include "cloth/judge/on_floor.h"

#include <gtest/gtest.h>

#include "tests/cloth/figure.h"

namespace toile {
namespace on_floor_test {

TEST(OnFloor, NamesThePanelsThatLieThere) {
  PanelMesh garment = test::tube();
  EXPECT_TRUE(panels_on_floor(garment, test::as_dressed(garment, garment.placed), 0.004).empty());
  // One corner of the front hangs down to the floor.
  garment.placed[test::tube_columns / 2] = Vec3(0, 0.003, 0.2);
  EXPECT_EQ(panels_on_floor(garment, test::as_dressed(garment, garment.placed), 0.004),
            std::vector<std::string>{"front"});
}

}  // namespace on_floor_test
}  // namespace toile
