#include "tests/figures/page.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "tests/figures/sheet.h"

namespace toile::figures {
namespace page_test {

std::filesystem::path empty_folder(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(FiguresPage, HoldsWhatTheSheetsSay) {
  const auto folder = empty_folder("toile_page");
  for (const char* name : {"fig10", "fig9"}) {
    Sheet sheet(folder, name, std::string("Title of ") + name);
    sheet.say("less < more");
    sheet.chart({"rise", "s", "%", {{"</script>", {{0, 1}, {2, 3}}}}});
    sheet.compare("largest", "1.44 %", "0.25 %", true);
    sheet.pictures("seen", {{"PNG", "front"}});
    sheet.write();
  }
  const std::string page = figures_page(folder);
  EXPECT_LT(page.find("Title of fig9"), page.find("Title of fig10"));
  for (const char* text : {"less &lt; more", "1.44 %", "<td class=\"good\">held</td>",
                           "data:image/png;base64,UE5H", "\\u003c/script>", "new Chart("}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  // Nothing is asked for from elsewhere.
  for (const char* text : {"src=\"http", "href=\"http", "url("}) {
    EXPECT_EQ(page.find(text), std::string::npos) << text;
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "fig9_rise.csv"));
}

TEST(FiguresPage, AFolderWithoutSheetsIsRefused) {
  EXPECT_THROW(figures_page(empty_folder("toile_no_page")), Error);
}

}  // namespace page_test
}  // namespace toile::figures
