// toile try: from a drawing to the ease map, and what it took for granted.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace try_test {

using Json = nlohmann::json;

/// What the six lines are about, as they begin.
constexpr std::array<const char*, 6> subjects = {
    "unit: ", "grain: ", "halves: ", "pairs: ", "spare pieces: ", "undecided seams: "};

/// The sample T-shirt as a drawing: no seam is in it.
class ToileTry : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new ScratchFolder;
    succeed("make-mannequin", {"-o", *made_ / "mannequin.obj", "--edge-length", "14mm", "-q"});
    succeed("export-pattern", {sample("tshirt"), "-o", *made_ / "tshirt.svg", "-q"});
  }
  static void TearDownTestSuite() { delete made_; }

  pipeline::Run try_it(const std::vector<std::string>& options = {}) {
    std::vector<std::string> words = {"try",           drawing, "-o",        out,
                                      "--edge-length", "35mm",  "--quality", "draft"};
    words.insert(words.end(), options.begin(), options.end());
    return run("toile", words);
  }
  pipeline::Run try_on_body(const std::vector<std::string>& options = {}) {
    std::vector<std::string> words = {"--body", *made_ / "mannequin.obj"};
    words.insert(words.end(), options.begin(), options.end());
    return try_it(words);
  }
  Json report() const { return Json::parse(read_text(out / "report.json")); }

  /// A second drawing, with these shapes more.
  void add_to_drawing(const std::string& shapes) {
    std::string text = read_text(*made_ / "tshirt.svg");
    text.insert(text.rfind("</svg>"), shapes);
    drawing = folder / "more.svg";
    write_text(drawing, text);
  }

  static void expect_six_lines(const std::string& said) {
    std::istringstream lines(said);
    std::string line;
    for (const char* subject : subjects) {
      ASSERT_TRUE(std::getline(lines, line));
      EXPECT_TRUE(line.starts_with(subject)) << line;
      EXPECT_NE(line.find("; to change: "), std::string::npos) << line;
    }
  }

  ScratchFolder folder;
  fs::path drawing = *made_ / "tshirt.svg";
  fs::path out = folder / "out";

 private:
  static ScratchFolder* made_;
};
ScratchFolder* ToileTry::made_ = nullptr;

TEST_F(ToileTry, GoesFromTheDrawingToTheEaseMap) {
  const pipeline::Run done = try_on_body();
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
  for (const char* file :
       {"pattern.json", "import.json", "sewn.json", "seams.json", "body.ply", "garment.obj",
        "garment.garment.json", "dressed.obj", "dressed.json", "ease.html", "report.json"}) {
    EXPECT_TRUE(fs::exists(out / file)) << file;
  }
  EXPECT_FALSE(fs::exists(out / "mannequin.ply"));
  expect_six_lines(done.out);
  EXPECT_EQ(std::ranges::count(done.out, '\n'), 7) << done.out;
  EXPECT_NE(done.out.find("sewn: see "), std::string::npos) << done.out;
  EXPECT_EQ(report()["verdict"], "sewn");
  EXPECT_TRUE(report()["reason"].empty()) << report();
  const fs::path source = TOILE_SOURCE_DIR;
  const pipeline::Run valid =
      run(source / "tests" / "support" / "validate_report",
          {source / "docs" / "report.schema.json", "try", out / "report.json"});
  EXPECT_EQ(valid.exit_code, 0) << valid.err;
}

TEST_F(ToileTry, APointOfMeasureOutOfItsSpecIsAReasonForThree) {
  write_text(folder / "spec.csv", "name,spec_cm,tolerance_cm\nhalf chest,40,0.5\n");
  EXPECT_EQ(try_on_body({"--pom", folder / "spec.csv"}).exit_code, 3);
  EXPECT_EQ(report()["reason"], Json::array({"out_of_spec"}));
  EXPECT_EQ(report()["verdict"], "sewn");
  EXPECT_NE(read_text(out / "pom.csv").find(",40.00,"), std::string::npos);
}

TEST_F(ToileTry, APieceThatIsNoPanelIsAReasonForThree) {
  add_to_drawing(
      "<path class='fabric' id='bow' d='M900 900L1100 1300L1100 900L900 1100z' fill='none'/>");
  const pipeline::Run done = try_on_body();
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_NE(done.out.find("bow can't be panels"), std::string::npos) << done.out;
  EXPECT_EQ(report()["verdict"], "sewn");
  EXPECT_EQ(report()["reason"], Json({"left_out_pieces"}));
}

TEST_F(ToileTry, UndecidedSeamsAreAReasonForThree) {
  const Json first = [&] {
    EXPECT_EQ(try_on_body().exit_code, 0);
    return Json::parse(read_text(out / "seams.json"));
  }();
  std::vector<double> sure;
  for (const Json& seam : first["seams"]) sure.push_back(seam["confidence"]);
  std::ranges::sort(sure);
  // Above the least sure seam alone, or all that are as sure.
  const auto more = std::ranges::upper_bound(sure, sure.front());
  ASSERT_NE(more, sure.end());
  const pipeline::Run done = try_on_body({"--min-confidence", std::to_string(*more - 1e-6)});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_NE(done.out.find("; to change: --sew \""), std::string::npos) << done.out;
  EXPECT_NE(done.out.find(" for one, --min-confidence 0."), std::string::npos) << done.out;
  EXPECT_NE(done.out.find(" for all, or toile edit-seams "), std::string::npos) << done.out;
  const Json reasons = report()["reason"];
  EXPECT_NE(std::ranges::find(reasons, "undecided_seams"), reasons.end()) << reasons;
}

/// Halves without a mark of their fold, and one sleeve.
const fs::path halves = fs::path(TOILE_SOURCE_DIR) / "tests" / "io" / "drawings" / "halves.dxf";

TEST_F(ToileTry, ADrawingOfHalfAGarmentIsMadeWhole) {
  drawing = halves;
  const pipeline::Run done = try_on_body();
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
  expect_six_lines(done.out);
  EXPECT_NE(done.out.find("halves: Detail_2, Detail_3, Detail_4 unfolded"), std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("--single Detail_2"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("pairs: Detail left and right"), std::string::npos) << done.out;
  EXPECT_EQ(report()["verdict"], "sewn");
  const Json stitches = Json::parse(read_text(out / "sewn.json"))["pattern"]["stitches"];
  EXPECT_EQ(stitches.size(), 15);
}

/// As they are drawn, their seams don't meet.
TEST_F(ToileTry, PanelsThatNoSeamHoldsAreLaidAside) {
  drawing = halves;
  std::vector<std::string> as_drawn;
  for (const char* piece : {"Detail", "Detail_2", "Detail_3", "Detail_4"}) {
    as_drawn.insert(as_drawn.end(), {"--single", piece});
  }
  const pipeline::Run done = try_on_body(as_drawn);
  EXPECT_EQ(done.exit_code, 3) << done.err;
  expect_six_lines(done.out);
  EXPECT_NE(done.out.find("--unfold Detail_2:5 --unfold Detail_3:5"), std::string::npos)
      << done.out;
  const Json reasons = report()["reason"];
  EXPECT_NE(std::ranges::find(reasons, "loose_panels"), reasons.end()) << reasons;
  EXPECT_NE(report()["verdict"], "sewn");
  const Json panels = Json::parse(read_text(out / "sewn.json"))["pattern"]["panels"];
  std::vector<std::string> aside;
  for (const auto& [name, panel] : panels.items()) {
    if (!panel.contains("left_out")) continue;
    EXPECT_EQ(panel["left_out"], "sewn to nothing of the rest");
    aside.push_back(name);
  }
  ASSERT_FALSE(aside.empty());
  EXPECT_LT(aside.size(), panels.size());
  std::string line = "spare pieces: ";
  for (const std::string& name : aside) line += (name == aside.front() ? "" : ", ") + name;
  EXPECT_NE(done.out.find(line + " sewn to nothing of the rest, laid aside"), std::string::npos)
      << done.out;
  // A panel with a place of its own needs no seam.
  as_drawn.insert(as_drawn.end(), {"--place", aside.front() + "=torso:front"});
  const pipeline::Run placed = try_on_body(as_drawn);
  EXPECT_EQ(placed.out.find(line), std::string::npos) << placed.out;
}

TEST_F(ToileTry, AGarmentIsSewnThoughASparePieceIsLeft) {
  add_to_drawing("<path class=\"fabric\" id=\"tab\" d=\"M 3000 0 h 40 v 90 h -40 z\"/>");
  const pipeline::Run done = try_on_body();
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_NE(done.out.find("tab sewn to nothing of the rest"), std::string::npos) << done.out;
  EXPECT_EQ(report()["verdict"], "sewn") << done.out;
  EXPECT_EQ(report()["reason"], Json::array({"loose_panels"}));
}

TEST_F(ToileTry, AStepThatFailsSaysWhatWasTakenAndNoReportIsThere) {
  const pipeline::Run done = try_on_body({"--min-confidence", "1"});
  EXPECT_EQ(done.exit_code, 1) << done.out;
  expect_six_lines(done.out);
  EXPECT_NE(done.err.find("has panels and no seams; draw them: toile edit-seams "),
            std::string::npos)
      << done.err;
  EXPECT_FALSE(fs::exists(out / "report.json"));
  EXPECT_FALSE(fs::exists(out / "dressed.obj"));
}

TEST_F(ToileTry, ADrawingThatCannotBeReadLeavesTheFolderAsItIs) {
  fs::create_directory(out);
  write_text(out / "ease.html", "of an earlier run");
  drawing = folder / "none.svg";
  write_text(drawing, "<svg xmlns='http://www.w3.org/2000/svg'/>");
  const pipeline::Run done = try_on_body();
  EXPECT_EQ(done.exit_code, 1) << done.out;
  EXPECT_NE(done.err.find("none.svg"), std::string::npos) << done.err;
  EXPECT_EQ(read_text(out / "ease.html"), "of an earlier run");
  EXPECT_FALSE(fs::exists(out / "pattern.json"));
}

TEST_F(ToileTry, MakesABodyOfMeasures) {
  EXPECT_EQ(try_it({"--body", "b.ply", "--measures", "bust=94"}).exit_code, 2);
  EXPECT_EQ(try_it().exit_code, 2);
  const fs::path woman = fs::path(TOILE_SOURCE_DIR) / "samples" / "woman.vit";
  const pipeline::Run done = try_it({"--measures", woman});
  EXPECT_TRUE(fs::exists(out / "mannequin.ply")) << done.err;
  EXPECT_EQ(report()["body"], (out / "mannequin.ply").string());
  EXPECT_TRUE(fs::exists(out / "ease.html")) << done.err;
}

/// `toile fit` takes a pattern that is sewn.
TEST_F(ToileTry, FitOfPanelsWithoutSeamsNamesFindSeams) {
  succeed("import-pattern", {drawing, "-o", folder / "p.json", "-q"});
  const pipeline::Run done =
      run("toile", {"fit", "--body", "body.obj", folder / "p.json", "-o", out});
  EXPECT_EQ(done.exit_code, 1) << done.out;
  EXPECT_NE(done.err.find("toile find-seams "), std::string::npos) << done.err;
}

}  // namespace try_test
}  // namespace toile::pipeline
