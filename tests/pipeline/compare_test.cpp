// toile compare: runs side by side, failed ones too, and the best size by its rule.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/csv.h"
#include "tests/support/run_program.h"

namespace toile::pipeline {
namespace compare_test {

using Json = nlohmann::json;

/// Reports as toile fit leaves them, with what compare reads.
class Compare : public testing::Test {
 protected:
  /// Of the pattern NAME on that body. `eases`: centimetres and their errors, by level.
  void write_fit(const std::string& folder, const std::string& name, const std::string& body,
                 const std::map<std::string, std::array<double, 2>>& eases,
                 const std::string& fit = "ok") const {
    const fs::path out = scratch / folder;
    fs::create_directories(out);
    write(out / "body.report.json",
          {{"read", {{"file", "bodies/" + body + ".obj"}}}, {"body", {{"usable", true}}}});
    write(out / "mesh.json", {{"pattern", "patterns/" + name + ".json"}});
    write(out / "dressed.json", {{"program", "dress"},
                                 {"verdict", "sewn"},
                                 {"fit", {{"verdict", fit}, {"levels", Json::array()}}},
                                 {"scene", {{"fabric", "denim"}}},
                                 {"warnings", Json::array()}});
    Json ease = {{"program", "ease-map"}, {"girths", Json::array()}};
    for (const auto& [level, figures] : eases) {
      ease["girths"].push_back(
          {{"level", level}, {"as_cut_ease_cm", figures[0]}, {"plus_minus_as_cut_cm", figures[1]}});
    }
    write(out / "ease.json", ease);
    write_text(out / "ease.html", "a page");
  }
  static void write(const fs::path& file, const Json& json) { write_text(file, json.dump()); }

  pipeline::Run compare(const std::vector<std::string>& folders,
                        std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"compare"};
    for (const std::string& folder : folders) words.push_back(scratch / folder);
    words.insert(words.end(), {"-o", scratch / "table.csv", "-q"});
    words.insert(words.end(), more.begin(), more.end());
    return run("toile", words);
  }
  /// The lines of table.csv by their reports' names, each by its columns.
  std::map<std::string, std::map<std::string, std::string>> table() const {
    std::map<std::string, std::map<std::string, std::string>> lines;
    const auto rows = parse_csv(read_text(scratch / "table.csv"), "table.csv");
    for (std::size_t i = 1; i < rows.size(); ++i) {
      std::map<std::string, std::string> line;
      EXPECT_EQ(rows[i].fields.size(), rows[0].fields.size());
      for (std::size_t k = 0; k < rows[i].fields.size(); ++k) {
        line[rows[0].fields[k]] = rows[i].fields[k];
      }
      lines[fs::path(line["report"]).filename()] = line;
    }
    return lines;
  }

  ScratchFolder scratch;
};

TEST_F(Compare, TheBestIsTheSmallestThatSurelyGoesAround) {
  write_fit("a", "shirt_36", "anna", {{"bust", {4, 0.5}}, {"hip", {0.4, 0.5}}});
  write_fit("b", "shirt_38", "anna", {{"bust", {8, 0.5}}, {"hip", {0.6, 0.5}}});
  write_fit("c", "shirt_40", "anna", {{"bust", {12, 0.5}}, {"hip", {4, 0.5}}});
  write_fit("d", "shirt_40", "berta", {{"bust", {-3, 0.5}}}, "too_small");
  const pipeline::Run done = compare({"c", "b", "a", "d"});
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_EQ(done.out,
            "shirt on anna in denim: best size 38, worst ease 0.6 ± 0.5 cm at the hip\n"
            "shirt on berta in denim: best size none, no size ended well and is large enough\n");
  auto lines = table();
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines["b"]["best"], "yes");
  EXPECT_EQ(lines["a"]["best"] + lines["c"]["best"] + lines["d"]["best"], "");
  EXPECT_EQ(lines["a"]["garment"], "shirt");
  EXPECT_EQ(lines["a"]["size"], "36");
  EXPECT_EQ(lines["a"]["body"], "anna");
  EXPECT_EQ(lines["a"]["fabric"], "denim");
  EXPECT_EQ(lines["a"]["worst_level"], "hip");
  EXPECT_EQ(lines["d"]["worst_ease_cm"], "-3.0");
  EXPECT_EQ(lines["d"]["plus_minus_ease_cm"], "0.5");
  EXPECT_EQ(lines["d"]["fit"], "too_small");
}

TEST_F(Compare, WithATargetItIsTheNearestToThat) {
  write_fit("a", "shirt-S", "anna", {{"bust", {4, 0.5}}, {"hip", {3, 0.5}}});
  write_fit("b", "shirt-M", "anna", {{"bust", {8.5, 0.5}}, {"hip", {7, 0.5}}});
  write_fit("c", "shirt-2XL", "anna", {{"bust", {15, 0.5}}, {"hip", {12, 0.5}}});
  // fitted: bust 7.6 to 10.2, hip 5.1 to 7.6.
  const pipeline::Run done = compare({"c", "b", "a"}, {"--target", "fitted"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.out, "shirt on anna in denim: best size M, within 'fitted' at all levels\n");
  auto lines = table();
  EXPECT_EQ(lines["a"]["off_level"], "bust");
  EXPECT_EQ(lines["a"]["off_cm"], "-3.6");
  EXPECT_EQ(lines["c"]["off_cm"], "4.8");
  EXPECT_EQ(lines["b"]["target"], "fitted");
  // Without it the smallest would do.
  EXPECT_NE(compare({"a", "b"}).out.find("best size S,"), std::string::npos);
}

TEST_F(Compare, RunsThatFailedAreRead) {
  write_fit("a", "shirt_36", "anna", {{"bust", {4, 0.5}}});
  write_fit("b", "shirt_38", "anna", {{"bust", {6, 0.5}}});
  for (const char* file : {"dressed.json", "ease.json", "ease.html"}) {
    fs::remove(scratch / "b" / file);
  }
  write_fit("c", "shirt_40", "anna", {{"bust", {8, 0.5}}});
  write(scratch / "c" / "body.report.json",
        {{"read", {{"file", "anna.obj"}}}, {"body", {{"usable", false}}}});
  // A knee around both legs and a neckline tell no size; what has no level is no girth with a name.
  write_fit("d", "shirt_42", "anna", {{"bust", {9, 0.5}}, {"knee", {-20, 1}}, {"", {-30, 1}}});
  write_fit("e", "shirt_44", "anna", {});
  EXPECT_EQ(compare({"a", "b", "c", "d", "e"}).exit_code, 0);
  auto lines = table();
  EXPECT_EQ(lines["b"]["verdict"], "error");
  EXPECT_EQ(lines["b"]["why"], "it ended while it was dressed");
  EXPECT_EQ(lines["b"]["size"], "38");
  EXPECT_EQ(lines["b"]["page"], "");
  EXPECT_EQ(lines["c"]["why"], "the body can't be relied on");
  EXPECT_EQ(lines["d"]["worst_level"], "bust");
  EXPECT_EQ(lines["e"]["worst_ease_cm"], "");
  EXPECT_EQ(lines["a"]["best"], "yes");
}

TEST_F(Compare, WhatIsNoRunIsAnError) {
  fs::create_directories(scratch / "empty");
  write_text(scratch / "other.json", R"({"program": "render"})");
  write_text(scratch / "damaged.json", R"({"program": )");
  for (const char* wrong : {"empty", "gone", "other.json", "damaged.json"}) {
    const pipeline::Run done = compare({wrong});
    EXPECT_EQ(done.exit_code, 1) << wrong;
    EXPECT_NE(done.err.find(wrong), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(scratch / "table.csv"));
  }
  // A table is not written over a report.
  write_fit("a", "shirt_36", "anna", {{"bust", {4, 0.5}}});
  EXPECT_EQ(run("toile", {"compare", scratch / "a", "-o", scratch / "a" / "ease.html"}).exit_code,
            1);
  EXPECT_EQ(read_text(scratch / "a" / "ease.html"), "a page");
}

/// Names may hold what HTML and addresses do not.
TEST_F(Compare, ThePageIsWholeAndItsLinksLead) {
  write_fit("runs/a b & <c>", "shirt_<36>", "anna's", {{"bust", {4, 0.5}}});
  fs::create_directories(scratch / "pages");
  const fs::path page = scratch / "pages" / "table.html";
  const pipeline::Run done =
      run("toile", {"compare", scratch / "runs" / "a b & <c>", "-o", page, "-q"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const std::string text = read_text(page);
  EXPECT_NE(text.find("<a href=\"./../runs/a%20b%20%26%20%3Cc%3E/ease.html\">"), std::string::npos);
  EXPECT_NE(text.find("shirt_&lt;36&gt;"), std::string::npos);
  EXPECT_NE(text.find("Content-Security-Policy"), std::string::npos);
  for (const char* fetched : {"src=", "<script", "http:", "https:"}) {
    EXPECT_EQ(text.find(fetched), std::string::npos) << fetched;
  }
  EXPECT_NE(text.find("A size counts if it ended well"), std::string::npos);
}

/// Real runs: three sizes of a band by a batch, and one by a fit; and a line that failed.
TEST(CompareRuns, ReadsBatchesAndFits) {
  const ScratchFolder folder;
  ASSERT_EQ(
      run("make-mannequin", {"-o", folder / "anna.obj", "--edge-length", "14mm", "-q"}).exit_code,
      0);
  const Json sample =
      Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json"));
  std::string manifest = "pattern,size,season\n";
  for (const auto& [size, factor] :
       std::map<std::string, double>{{"S", 0.8}, {"M", 1}, {"L", 1.1}}) {
    Json pattern = sample;
    for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
      for (Json& vertex : panel["vertices"]) vertex[0] = factor * vertex[0].get<double>();
    }
    write_text(folder / ("tee " + size + ".json"), pattern.dump());
    manifest += "tee " + size + ".json," + size + ",summer\n";
  }
  write_text(folder / "broken.json", "{");
  write_text(folder / "all.csv", manifest + "broken.json,XL,summer\n");
  const pipeline::Run batch = run(
      "toile", {"batch", "--body", folder / "anna.obj", folder / "all.csv", "-o", folder / "batch",
                "--edge-length", "35mm", "--options", "--quality draft", "-q"});
  EXPECT_EQ(batch.exit_code, 1) << batch.err;
  const pipeline::Run fit =
      run("toile", {"fit", "--body", folder / "anna.obj", folder / "tee M.json", "-o",
                    folder / "fit", "--edge-length", "35mm", "--quality", "draft", "-q"});
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  const pipeline::Run done =
      run("toile", {"compare", folder / "batch", folder / "fit", folder / "fit" / "dressed.json",
                    folder / "fit" / "ease.json", "-o", folder / "table.html", "--report",
                    folder / "table.json", "-q"});
  EXPECT_NE(done.exit_code, 1) << done.err;
  const Json report = Json::parse(read_text(folder / "table.json"));
  ASSERT_EQ(report["runs"].size(), 7U);
  std::map<std::string, int> sizes;
  for (const Json& one : report["runs"]) {
    ++sizes[one["size"]];
    EXPECT_EQ(one["body"], "anna") << one;
    if (one["size"] == "XL") {
      EXPECT_EQ(one["verdict"], "error");
      EXPECT_NE(one["why"].get<std::string>().find("broken.json"), std::string::npos) << one;
      EXPECT_FALSE(one.contains("worst"));
      continue;
    }
    EXPECT_EQ(one["garment"], "tee") << one;
    EXPECT_EQ(one["fabric"], "default") << one;
    EXPECT_TRUE(fs::exists(one["page"].get<std::string>())) << one;
    // The least ease by its own reading.
    const fs::path ease = fs::path(one["page"].get<std::string>()).replace_extension("json");
    double least = std::numeric_limits<double>::max();
    const Json eases = Json::parse(read_text(ease));
    for (const Json& girth : eases["girths"]) {
      if (girth.contains("level") && girth.contains("as_cut_ease_cm")) {
        least = std::min(least, girth["as_cut_ease_cm"].get<double>());
      }
    }
    for (const Json& edge : eases["garment_levels"]) {
      if (edge["name"] == "neckline") continue;
      const char* key = edge.contains("drafted_ease_cm") ? "drafted_ease_cm" : "as_cut_ease_cm";
      if (edge.contains(key)) least = std::min(least, edge[key].get<double>());
    }
    EXPECT_NEAR(one["worst"]["ease_cm"], least, 1e-9) << one;
  }
  EXPECT_EQ(sizes, (std::map<std::string, int>{{"S", 1}, {"M", 4}, {"L", 1}, {"XL", 1}}));
  EXPECT_NE(read_text(folder / "table.html").find("<th>size S</th><th>size M</th><th>size L</th>"),
            std::string::npos);
}

}  // namespace compare_test
}  // namespace toile::pipeline
