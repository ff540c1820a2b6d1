#include "io/view/seam_editor_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace toile {
namespace seam_editor_page_test {

using nlohmann::ordered_json;

SeamEditorPage small_page() {
  SeamEditorPage page;
  page.name = "bag <b>.json";
  page.pattern = R"({"pattern": {"panels": {"b</script><script>": {}, "a": {}}, "x": 0.1}})";
  return page;
}

ordered_json data_in(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t start = html.find(open) + open.size();
  return ordered_json::parse(html.substr(start, html.find("</script>", start) - start));
}

TEST(SeamEditorPage, HoldsThePatternAsItIs) {
  const SeamEditorPage page = small_page();
  const std::string html = seam_editor_page(page);
  const ordered_json data = data_in(html);
  EXPECT_EQ(data["pattern"].dump(), ordered_json::parse(page.pattern).dump());
  EXPECT_EQ(data["name"], page.name);
  EXPECT_TRUE(data["proposals"].is_null());
  EXPECT_EQ(data["served"], false);
  EXPECT_NE(html.find("<title>bag &lt;b&gt;.json</title>"), std::string::npos);
  EXPECT_EQ(html.find("{{"), std::string::npos);
}

TEST(SeamEditorPage, LoadsNothingFromTheNetwork) {
  const std::string html = seam_editor_page(small_page());
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  for (const char* loading : {"src=\"http", "href=\"http", "src=\"//", "@import"}) {
    EXPECT_EQ(html.find(loading), std::string::npos) << loading;
  }
}

TEST(SeamEditorPage, HasThreeDimensionsWhereABodyIs) {
  SeamEditorPage page = small_page();
  EXPECT_EQ(seam_editor_page(page).find("three.js authors"), std::string::npos);
  page.body = "body.ply";
  page.served = true;
  page.proposals = R"({"seams": []})";
  const std::string html = seam_editor_page(page);
  EXPECT_NE(html.find("three.js authors"), std::string::npos);
  EXPECT_EQ(data_in(html)["body"], "body.ply");
  EXPECT_TRUE(data_in(html)["proposals"].is_object());
}

}  // namespace seam_editor_page_test
}  // namespace toile
