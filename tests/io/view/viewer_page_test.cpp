#include "io/view/viewer_page.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <regex>

namespace toile {
namespace viewer_page_test {

ViewerPage small_page() {
  ViewerPage page;
  page.title = "Gap of <b>\"this\" & that</b>";
  page.paragraphs = {"A paragraph {{data}} with braces."};
  page.surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  page.surface.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 1, 0}};
  page.values = {-1, 2, 3, 4.5};
  page.regions = {"front</script><script>alert(1)</script>", "back"};
  page.region_of_triangle = {1, 0, 1};
  page.quantity = "Gap";
  page.unit = "mm";
  page.ramp = magnitude_ramp(0, 50);
  page.below = "inside";
  page.setting.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  page.setting.triangles = {{0, 1, 2}};
  page.setting_name = "body";
  page.tables = {{"A table", {"panel", "mean"}, {{"<i>", "1.0"}, {"all", "2.0"}}, {1, -1}, "note"}};
  return page;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

/// The JSON element's content.
nlohmann::json data_in(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t start = html.find(open) + open.size();
  return nlohmann::json::parse(html.substr(start, html.find("</script>", start) - start));
}

std::string decoded(const std::string& base64) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int have = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    have += 6;
    if (have >= 8) {
      have -= 8;
      bytes += static_cast<char>(bits >> have & 255U);
    }
  }
  return bytes;
}

template <typename Number>
std::vector<Number> numbers(const nlohmann::json& base64) {
  const std::string bytes = decoded(base64.get<std::string>());
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

TEST(ViewerPage, HoldsTheMeshAndItsValues) {
  const nlohmann::json data = data_in(viewer_page(small_page()));
  const auto points = numbers<float>(data["surface"]["points"]);
  ASSERT_EQ(points.size(), 12U);
  EXPECT_EQ(points[11], 0.5F);
  EXPECT_EQ(numbers<float>(data["surface"]["values"]), (std::vector<float>{-1, 2, 3, 4.5}));
  EXPECT_FALSE(data["surface"]["wide"].get<bool>());
  // Triangles in the order of their regions, each region a run.
  EXPECT_EQ(numbers<std::uint16_t>(data["surface"]["triangles"]),
            (std::vector<std::uint16_t>{1, 3, 2, 0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(data["regions"][0]["first"], 0);
  EXPECT_EQ(data["regions"][0]["count"], 1);
  EXPECT_EQ(data["regions"][1]["first"], 1);
  EXPECT_EQ(data["regions"][1]["count"], 2);
  EXPECT_EQ(data["regions"][0]["name"], "front</script><script>alert(1)</script>");
}

TEST(ViewerPage, LargeMeshesHaveWideIndices) {
  ViewerPage page = small_page();
  page.surface.points.resize(70000, Vec3::Zero());
  page.values.resize(70000, 0);
  page.surface.triangles[0] = {0, 1, 69999};
  const nlohmann::json data = data_in(viewer_page(page));
  EXPECT_TRUE(data["surface"]["wide"].get<bool>());
  EXPECT_EQ(numbers<std::uint32_t>(data["surface"]["triangles"])[5], 69999U);
}

TEST(ViewerPage, UserTextIsEscaped) {
  const std::string html = viewer_page(small_page());
  EXPECT_NE(html.find("<h1>Gap of &lt;b&gt;&quot;this&quot; &amp; that&lt;/b&gt;</h1>"),
            std::string::npos);
  EXPECT_EQ(count(html, "alert(1)</script>"), 0U);
  EXPECT_EQ(count(html, "<script"), 4U);  // data, three.js, its controls, the page's own
  EXPECT_NE(html.find("A paragraph {{data}} with braces."), std::string::npos);
  EXPECT_NE(html.find("<tr data-region=\"1\"><td>&lt;i&gt;</td>"), std::string::npos);
}

TEST(ViewerPage, AsksForNothingFromTheNetwork) {
  ViewerPage page = small_page();
  page.still_png = "\x89PNG";
  const std::string html = viewer_page(page);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(count(html, "<link"), 0U);
  EXPECT_EQ(count(html, "<script src"), 0U);
  EXPECT_EQ(count(html, "@import"), 0U);
  EXPECT_FALSE(std::regex_search(html.substr(0, html.find("id=\"data\"")),
                                 std::regex("(src|href)=.?(https?:)?//")));
  EXPECT_EQ(count(html, "src=\"data:image/png;base64,iVBORw==\""), 1U);
}

TEST(ViewerPage, HoldsThreeJsRelease111) {
  const std::string html = viewer_page(small_page());
  EXPECT_EQ(count(html, "REVISION=\"111\"") + count(html, "REVISION=\"111dev\""), 1U);
  EXPECT_GT(count(html, "OrbitControls"), 1U);
  EXPECT_GT(count(html, "Permission is hereby granted"), 0U);
}

}  // namespace viewer_page_test
}  // namespace toile
