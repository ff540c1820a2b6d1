// The program import-pattern, from the drawing to a pattern that mesh-pattern takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace import_pattern_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;

const std::string source = TOILE_SOURCE_DIR;

TEST(ImportPattern, WhatItWritesIsMeshed) {
  const ScratchFolder folder;
  const std::string pattern = (folder / "p.json").string();
  const auto made =
      run("import-pattern", {source + "/tests/io/drawings/r12.dxf", "-o", pattern}, 60);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out, "");
  const auto meshed =
      run("mesh-pattern", {pattern, "-o", (folder / "garment.obj").string(), "--flat"}, 60);
  EXPECT_EQ(meshed.exit_code, 0) << meshed.err;
  const std::string garment = read_text(folder / "garment.garment.json");
  EXPECT_HOLDS(garment, ".cut_out.0");
  EXPECT_HOLDS(garment, ".drill_hole.0");
}

TEST(ImportPattern, ABadPieceEndsWithThree) {
  const ScratchFolder folder;
  write_text(
      folder / "d.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' width='400mm' height='400mm' viewBox='0 0 400 "
      "400'><path id='good' d='M0 0h200v300h-200z'/>"
      "<path id='bow' d='M210 0L390 390L390 0L210 200z'/></svg>");
  const auto import = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {(folder / "d.svg").string(), "-o",
                                      (folder / "p.json").string(), "--report",
                                      (folder / "r.json").string()};
    words.insert(words.end(), more.begin(), more.end());
    return run("import-pattern", words, 60);
  };
  const auto done = import({});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_HOLDS(done.err, "piece 'bow': its outline crosses or touches itself");
  EXPECT_HOLDS(read_text(folder / "p.json"), "good");
  EXPECT_HOLDS(read_text(folder / "r.json"), "left_out\": [\n    {\n      \"piece\": \"bow\"");
  EXPECT_EQ(import({"--without", "bow"}).exit_code, 0);
  EXPECT_EQ(import({"--without", "good"}).exit_code, 1);
}

TEST(ImportPattern, AllSizesAreNumberedAsTheBaseSize) {
  const ScratchFolder folder;
  const auto group = [](int code, const std::string& value) {
    return std::to_string(code) + "\n" + value + "\n";
  };
  const auto text = [&](const std::string& words) {
    return group(0, "TEXT") + group(8, "1") + group(10, "0") + group(20, "0") + group(1, words);
  };
  const auto point = [&](const std::string& layer, double x, double y) {
    return group(0, "POINT") + group(8, layer) + group(10, std::to_string(x)) +
           group(20, std::to_string(y));
  };
  // The side turns by 11 degrees at half its height; in size 40 by less than 10, and in XL more.
  std::string blocks;
  for (const auto& [size, out] : {std::pair("38", 20.), {"40/1", 12.}, {"XL", 40.}}) {
    const std::string line = group(0, "LWPOLYLINE") + group(8, "1") + group(70, "1");
    std::string piece = line;
    for (const auto& [x, y] :
         {std::pair(0., 0.), {200., 0.}, {200. + out, 200.}, {200., 400.}, {0., 380.}}) {
      piece += group(10, std::to_string(x)) + group(20, std::to_string(y));
    }
    piece += text("Piece Name: side") + text(std::string("Size: ") + size);
    if (std::string(size) == "38") {
      piece += text("Quantity: 2") + point("2", 220, 200) + point("2", 0, 0) + point("2", 200, 0) +
               point("4", 0, 100);
    }
    blocks += group(0, "BLOCK") + group(2, std::string("S") + size) + piece + group(0, "ENDBLK");
  }
  write_text(folder / "d.dxf", group(0, "SECTION") + group(2, "BLOCKS") + blocks +
                                   group(0, "ENDSEC") + group(0, "SECTION") + group(2, "ENTITIES") +
                                   text("Sample Size: 38") + text("Units: METRIC") +
                                   group(0, "ENDSEC") + group(0, "EOF"));
  write_text(folder / "d.rul", "");
  const std::string out = (folder / "sizes").string();
  const auto done = run("import-pattern",
                        {(folder / "d.dxf").string(), "--all-sizes", "-o", out, "--report",
                         (folder / "r.json").string()},
                        60);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_HOLDS(done.err, "d.rul: grading rules beside the drawing are not read");
  EXPECT_EQ(done.err.find("warning"), std::string::npos) << done.err;
  for (const char* size : {"38", "40_1", "XL"}) {
    const auto pattern =
        nlohmann::json::parse(read_text(folder / "sizes" / (std::string(size) + ".json")));
    const auto& panels = pattern["pattern"]["panels"];
    ASSERT_EQ(panels.size(), 2u) << size;
    EXPECT_EQ(panels["left_side"]["edges"].size(), 6u) << size;
    EXPECT_EQ(panels["right_side"]["notches"].size(), 1u) << size;
  }
  EXPECT_EQ(run("import-pattern",
                {(folder / "d.dxf").string(), "--all-sizes", "--size", "38", "-o", out}, 60)
                .exit_code,
            2);
}

TEST(ImportPattern, APatternIsWrittenAsItIs) {
  const ScratchFolder folder;
  const std::string sample = source + "/samples/tshirt.json";
  const auto done = run("import-pattern", {sample, "-o", (folder / "p.json").string()}, 60);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_HOLDS(done.err, "is a pattern already");
  EXPECT_EQ(read_text(folder / "p.json"), read_text(sample));
}

TEST(ImportPattern, AnOutlineThatNobodyCanMeshIsNamedByAllPatternPrograms) {
  const ScratchFolder folder;
  const std::string bow = (folder / "bow.json").string();
  write_text(folder / "bow.json",
             samples::file(samples::polygon("square", "[0,0],[20,0],[20,20],[0,20]") + "," +
                           samples::polygon("bow", "[0,0],[10,10],[10,0],[0,10]")));
  const std::string words = "panel 'bow', edge 0: crosses or touches edge 2";
  for (const auto& [program, output] : {std::pair("import-pattern", "o.json"),
                                        {"find-seams", "o.json"},
                                        {"export-pattern", "o.svg"}}) {
    const pipeline::Run done = run(program, {bow, "-q", "-o", (folder / output).string()}, 60);
    EXPECT_NE(done.exit_code, 1) << program;
    EXPECT_HOLDS(done.err, "warning: " + bow + ": " + words);
  }
  const pipeline::Run refused = run("mesh-pattern", {bow, "-o", (folder / "o.obj").string()}, 60);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_HOLDS(refused.err, words);
}

TEST(ImportPattern, WhatIsNoPatternIsRefusedInOneLine) {
  const ScratchFolder folder;
  for (const std::string content : {"AutoCAD Binary DXF\r\n\x1a", "%PDF-1.4", "hello", "",
                                    "{\"a\": 1}", "<html></html>", "  0\nSECTION\n  2\nHEADER\n"}) {
    write_text(folder / "d.dxf", content);
    const auto refused = run("import-pattern",
                             {(folder / "d.dxf").string(), "-o", (folder / "p.json").string()}, 60);
    EXPECT_EQ(refused.exit_code, 1) << content;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_HOLDS(refused.err, "d.dxf");
    EXPECT_FALSE(std::filesystem::exists(folder / "p.json"));
  }
}

TEST(ImportPattern, APieceThatIsGivenTwoNamesIsAWrongOption) {
  const ScratchFolder folder;
  const auto named = [&](const std::string& first, const std::string& second) {
    return run("import-pattern",
               {source + "/tests/io/drawings/r12.dxf", "-o", (folder / "p.json").string(), "--name",
                first, "--name", second},
               60);
  };
  const auto refused = named("A=B", "A=C");
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_HOLDS(refused.err, "--name: calls 'A' both 'B' and 'C'");
  EXPECT_FALSE(std::filesystem::exists(folder / "p.json"));
  // One name twice is no contradiction, and no second panel has it.
  const std::string piece = "Vorderteil Größe=front";
  const auto same = named(piece, piece);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  const std::string pattern = read_text(folder / "p.json");
  EXPECT_HOLDS(pattern, "front");
  EXPECT_EQ(pattern.find("front_2"), std::string::npos);
}

}  // namespace import_pattern_test
}  // namespace toile
