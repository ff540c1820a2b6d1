// The program find-seams, from a pattern without seams to one that has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace find_seams_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;
using Json = nlohmann::ordered_json;

using Edges = std::set<std::pair<std::string, int>>;

std::set<Edges> seams_of(const Json& pattern) {
  std::set<Edges> seams;
  for (const Json& stitch : pattern["pattern"]["stitches"]) {
    Edges edges;
    for (int i = 0; i < 2; ++i) {
      edges.emplace(stitch[i]["panel"].get<std::string>(), stitch[i]["edge"].get<int>());
    }
    seams.insert(edges);
  }
  return seams;
}

/// The sample T-shirt with its seams, and a file of it without them.
class FindSeams : public testing::Test {
 protected:
  FindSeams() {
    Json bare = whole;
    bare["pattern"]["stitches"] = Json::array();
    write_text(folder / "bare.json", bare.dump());
  }

  pipeline::Run find(const std::string& pattern, const std::vector<std::string>& options) {
    std::vector<std::string> words = {(folder / pattern).string(), "-o",
                                      (folder / "sewn.json").string()};
    words.insert(words.end(), options.begin(), options.end());
    return run("find-seams", words, 60);
  }

  Json sewn() const { return Json::parse(read_text(folder / "sewn.json")); }

  const ScratchFolder folder;
  const Json whole = Json::parse(read_text(std::string(TOILE_SOURCE_DIR) + "/samples/tshirt.json"));
};

TEST_F(FindSeams, FindsThoseOfTheSampleAgain) {
  const auto done = find("bare.json", {"--min-confidence", "0"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.out, "");
  EXPECT_EQ(seams_of(sewn()), seams_of(whole));
  EXPECT_HOLDS(done.err, "left open:");
  // All but the stitches is as it was, the order of the keys included.
  Json other = sewn();
  other["pattern"]["stitches"] = Json::array();
  EXPECT_EQ(other.dump(), Json::parse(read_text(folder / "bare.json")).dump());
}

TEST_F(FindSeams, WhatIsUncertainIsListedNotSewn) {
  const auto done = find("bare.json", {"--min-confidence", "1"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_HOLDS(done.err, "0 seams sewn, 14 undecided");
  EXPECT_TRUE(sewn()["pattern"]["stitches"].empty());
}

TEST_F(FindSeams, ATimeLimitKeepsTheBestFoundSoFarAndSaysSo) {
  const std::string told = (folder / "report.json").string();
  const auto early =
      find("bare.json", {"--time-limit", "1e-6", "--min-confidence", "0", "--report", told});
  ASSERT_EQ(early.exit_code, 0) << early.err;
  EXPECT_HOLDS(early.err, "the time limit ended the search");
  EXPECT_HOLDS(read_text(told), "the time limit ended the search");
  const std::set<Edges> known = seams_of(whole);
  std::size_t right = 0;
  for (const Edges& seam : seams_of(sewn())) right += known.count(seam);
  EXPECT_GE(2 * right, known.size()) << "one look at all edges finds most of a T-shirt";
  const auto late = find("bare.json", {"--time-limit", "60", "--min-confidence", "0"});
  EXPECT_EQ(late.err.find("time limit"), std::string::npos);
  EXPECT_EQ(seams_of(sewn()), known);
  const auto none = find("bare.json", {"--time-limit", "0"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_HOLDS(none.err, "--time-limit");
}

TEST_F(FindSeams, PocketsAreLeftOutUnlessTheyAreAskedFor) {
  // A shirt of two squares, for speed.
  const auto square = [](double side) {
    Json piece;
    piece["vertices"] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    for (int i = 0; i < 4; ++i) piece["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
    return piece;
  };
  Json file;
  file["properties"] = {{"units_in_meter", 100}};
  file["pattern"]["stitches"] = Json::array();
  file["pattern"]["panels"] = {{"front", square(50)}, {"back", square(50)}, {"pocket", square(12)}};
  write_text(folder / "pocket.json", file.dump());
  const std::string report = (folder / "seams.json").string();
  const auto done = find("pocket.json", {"--report", report});
  EXPECT_NE(done.exit_code, 1) << done.err;
  EXPECT_HOLDS(done.err, "left out: pocket (pocket)");
  // The file keeps it, and is meshed without it.
  Json kept = sewn();
  EXPECT_EQ(kept["pattern"]["panels"]["pocket"]["left_out"], "pocket");
  for (auto& [name, panel] : kept["pattern"]["panels"].items()) panel.erase("left_out");
  EXPECT_EQ(kept["pattern"]["panels"].dump(), file["pattern"]["panels"].dump());
  const auto meshed = run("mesh-pattern", {folder / "sewn.json", "--edge-length", "50mm", "-o",
                                           folder / "garment.obj"});
  EXPECT_EQ(meshed.exit_code, 0) << meshed.err;
  EXPECT_HOLDS(meshed.err, "left out: pocket (pocket)");
  const Json garment = Json::parse(read_text(folder / "garment.garment.json"));
  EXPECT_EQ(garment["panels"].size(), 2u);
  const auto drawn =
      run("export-pattern", {folder / "sewn.json", "-o", folder / "sheet.svg", "-q"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_HOLDS(read_text(folder / "sheet.svg"), "Cut 1, left out: pocket");
  // The mark says enough: a pocket by another name stays out, and what is asked for comes in.
  Json renamed = sewn();
  renamed["pattern"]["panels"]["patch"] = renamed["pattern"]["panels"]["pocket"];
  renamed["pattern"]["panels"].erase("pocket");
  write_text(folder / "patch.json", renamed.dump());
  EXPECT_HOLDS(find("patch.json", {}).err, "left out: patch (pocket)");
  EXPECT_NE(find("patch.json", {"--with", "patch"}).exit_code, 1);
  EXPECT_FALSE(sewn()["pattern"]["panels"]["patch"].contains("left_out"));
  EXPECT_EQ(Json::parse(read_text(report))["left_out"].dump(),
            R"([{"panel":"pocket","kind":"pocket"}])");
  // What is taken in and finds no seam is named: it would fall off the body.
  const auto taken = find("pocket.json", {"--with", "pocket", "--min-confidence", "1"});
  EXPECT_HOLDS(taken.err, "no seam holds panel 'pocket'");
  EXPECT_FALSE(sewn()["pattern"]["panels"]["pocket"].contains("left_out"));
  const auto unknown = find("pocket.json", {"--with", "flap"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_HOLDS(unknown.err, "--with 'flap': names no panel of the pattern");
}

TEST_F(FindSeams, SeamsThatAreAskedForAreSewn) {
  Json one = whole;
  one["pattern"]["stitches"] = Json::array({whole["pattern"]["stitches"][0]});
  write_text(folder / "one.json", one.dump());
  const auto done = find("one.json", {"--keep", "--sew", "left_front:0 left_back:5", "--report",
                                      (folder / "seams.json").string()});
  EXPECT_NE(done.exit_code, 1) << done.err;
  const std::set<Edges> seams = seams_of(sewn());
  EXPECT_TRUE(seams.contains({{"left_front", 0}, {"left_back", 5}}));
  EXPECT_TRUE(seams.contains(*seams_of(one).begin()));
}

TEST_F(FindSeams, WhatIsListedCanBeAskedFor) {
  // The waistband of a draft is cut in two, for front and back.
  const std::string draft = TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/hugo.json";
  const std::string report = (folder / "seams.json").string();
  const auto seams = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {draft, "-o", (folder / "sewn.json").string(), "--report",
                                      report};
    words.insert(words.end(), options.begin(), options.end());
    const auto done = run("find-seams", words, 120);
    EXPECT_NE(done.exit_code, 1) << done.err;
    return Json::parse(read_text(report));
  };
  const auto side = [](const Json& at) {
    return at["panel"].get<std::string>() + ":" + std::to_string(at["edge"].get<int>());
  };
  const Json listed = seams({});
  const std::set<Edges> before = seams_of(sewn());
  int asked = 0;
  for (const Json& cut : listed["splits"]) {
    if (cut["panel"] != "waistband") continue;
    for (const Json& seam : listed["seams"]) {
      for (const char* key : {"edge", "rest"}) {
        const Json part = {{"panel", "waistband"}, {"edge", cut[key]}};
        if (seam["a"] != part && seam["b"] != part) continue;
        const Json again = seams({"--sew", side(seam["a"]) + " " + side(seam["b"])});
        EXPECT_EQ(seams_of(sewn()), before);
        EXPECT_EQ(again["splits"], listed["splits"]);
        EXPECT_EQ(std::ranges::count_if(again["seams"],
                                        [&](const Json& found) {
                                          return found["given"] == true &&
                                                 found["a"] == seam["a"] && found["b"] == seam["b"];
                                        }),
                  1);
        ++asked;
      }
    }
  }
  EXPECT_GE(asked, 2);
}

TEST_F(FindSeams, NamesWhatCannotBeSewn) {
  const auto panel = find("bare.json", {"--sew", "front:0 left_back:5"});
  EXPECT_EQ(panel.exit_code, 1);
  EXPECT_HOLDS(panel.err, "names panel 'front'");
  const auto edge = find("bare.json", {"--sew", "left_front:9 left_back:5"});
  EXPECT_EQ(edge.exit_code, 1);
  EXPECT_HOLDS(edge.err, "has edges 0 to 5");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bare.json"}));
}

}  // namespace find_seams_test
}  // namespace toile
