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
  page.facts = {{"fabric", "<u>silk"}};
  page.verdict = {"sewn & more", PageVerdict::Tone::bad, {{"the hem <rides> up", 0}}};
  page.warnings = {"a <hole>"};
  page.paragraphs = {"A paragraph {{data}} with braces."};
  page.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  page.node_of = {0, 1, 2, 1, 3, 2};  // two pieces that share an edge
  page.flat = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {3, 1}, {2, 1}};
  page.pattern = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 1}, {0, 1}};
  page.triangles = {{0, 1, 2}, {3, 4, 5}, {2, 1, 0}};
  page.regions = {"front</script><script>alert(1)</script>", "back"};
  page.region_of_triangle = {1, 0, 1};
  PageMap map;
  map.tab = "Ease";
  map.reading = "gap";
  map.unit = "mm";
  map.values = {-1, 2, 3, 2, 4.5, 3};
  map.bar = {"Gap, mm", magnitude_ramp(0, 50), "inside", "", {{0, "touches"}, {50, "50 mm"}}};
  page.maps = {map};
  page.settings = {{"body", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}};
  page.lines = {{{{PagePlace{0, 1, 0.25}, PagePlace{0, 2, 0.5}}}, {0, 0.5, 0}, {0, 1, 0}}};
  PageTable table{
      "A table", {"panel", {"mean", true}}, {{"<i>", "1.0"}, {"all", "2.0"}}, {1, -1}, "note"};
  table.lines = {-1, 0};
  page.tables = {table};
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
  const nlohmann::json& surface = data["surface"];
  const auto nodes = numbers<float>(surface["nodes"]);
  ASSERT_EQ(nodes.size(), 12U);
  EXPECT_EQ(nodes[11], 0.5F);
  EXPECT_EQ(numbers<std::uint32_t>(surface["nodeOf"]),
            (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(numbers<float>(surface["flat"])[6], 2.0F);
  EXPECT_EQ(numbers<float>(surface["pattern"])[6], 0.0F);
  // Triangles in the order of their regions, each region a run.
  EXPECT_EQ(numbers<std::uint32_t>(surface["triangles"]),
            (std::vector<std::uint32_t>{3, 4, 5, 0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(data["regions"][0]["first"], 0);
  EXPECT_EQ(data["regions"][0]["count"], 1);
  EXPECT_EQ(data["regions"][1]["first"], 1);
  EXPECT_EQ(data["regions"][1]["count"], 2);
  EXPECT_EQ(data["regions"][0]["name"], "front</script><script>alert(1)</script>");
  const nlohmann::json& map = data["maps"][0];
  EXPECT_EQ(numbers<float>(map["values"]), (std::vector<float>{-1, 2, 3, 2, 4.5, 3}));
  EXPECT_EQ(map["marks"][1][1], "50 mm");
  EXPECT_EQ(map["below"]["text"], "inside");
}

TEST(ViewerPage, RowsNameTheirLines) {
  const std::string html = viewer_page(small_page());
  EXPECT_NE(html.find("<tr data-line=\"0\" tabindex=\"0\"><td>all</td><td data-cm>2.0</td>"),
            std::string::npos);
  const nlohmann::json line = data_in(html)["lines"][0];
  EXPECT_EQ(numbers<std::uint32_t>(line["ends"]), (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_EQ(numbers<float>(line["parts"]), (std::vector<float>{0.25F, 0.5F}));
  EXPECT_EQ(line["normal"], (nlohmann::json{0, 1, 0}));
}

TEST(ViewerPage, LanguagesKnowTheSameWords) {
  const std::string html = viewer_page(small_page());
  const std::string open = "<script type=\"application/json\" id=\"languages\">";
  const std::size_t start = html.find(open) + open.size();
  const nlohmann::json all =
      nlohmann::json::parse(html.substr(start, html.find("</script>", start) - start));
  ASSERT_GT(all["de"].size(), 100U);
  ASSERT_EQ(all["de"].size(), all["fr"].size());
  for (const auto& [english, german] : all["de"].items()) {
    ASSERT_TRUE(all["fr"].contains(english)) << english;
    for (const std::string place : {"{0}", "{1}", "{2}", "{3}", "{4}", "{5}"}) {
      EXPECT_EQ(count(english, place), count(german, place)) << english;
      EXPECT_EQ(count(english, place), count(all["fr"][english], place)) << english;
    }
  }
}

TEST(ViewerPage, UserTextIsEscaped) {
  const std::string html = viewer_page(small_page());
  EXPECT_NE(
      html.find("<h1 translate=\"no\">Gap of &lt;b&gt;&quot;this&quot; &amp; that&lt;/b&gt;</h1>"),
      std::string::npos);
  EXPECT_EQ(count(html, "alert(1)</script>"), 0U);
  EXPECT_EQ(count(html, "<script"), 5U);  // data, words, three.js, its controls, the page's own
  EXPECT_NE(html.find("A paragraph {{data}} with braces."), std::string::npos);
  EXPECT_NE(html.find("<tr data-region=\"1\" tabindex=\"0\"><td translate=\"no\">&lt;i&gt;</td>"),
            std::string::npos);
  for (const char* text :
       {"&lt;u&gt;silk", "sewn &amp; more", "the hem &lt;rides&gt; up", "a &lt;hole&gt;"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
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
