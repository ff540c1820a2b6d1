#include "pattern/import/dxf_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "geometry/polygon.h"
#include "io/output_file.h"
#include "pattern/import/join_paths.h"
#include "tests/pattern/import/dxf_samples.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace dxf_pieces_test {

using namespace samples;

PieceDrawing pieces_of(const std::string& text, const DrawingOptions& options = {}) {
  return dxf_pieces(parse_dxf(text, "a.dxf"), "a.dxf", options);
}

std::string pieces_error(const std::string& text, const DrawingOptions& options = {}) {
  return error_of([&] { pieces_of(text, options); });
}

double area(const Piece& piece) { return std::abs(signed_area(loop_points(piece.outline, 1e-6))); }

std::string all_remarks(const PieceDrawing& drawing) {
  std::string all;
  for (const Remark& remark : drawing.remarks) all += remark.text + "\n";
  return all;
}

const std::string square = dxf_polyline("1", rectangle(0, 0, 300, 400));

TEST(DxfPieces, LayersSayWhatIsWhat) {
  const PieceDrawing read = pieces_of(dxf_file(
      dxf_block("FRONT",
                square + dxf_point("2", {300, 0}) + dxf_point("3", {150, 0}) +
                    dxf_point("4", {300, 200}, "50\n180\n") + dxf_point("81", {0, 100}) +
                    dxf_segment("6", {0, 0}, {0, 400}) + dxf_segment("7", {100, 100}, {100, 300}) +
                    dxf_segment("8", {10, 10}, {50, 50}) +
                    dxf_polyline("11", rectangle(200, 200, 20, 20)) + dxf_point("13", {150, 150}) +
                    dxf_segment("77", {0, 0}, {1, 1}) + dxf_label("Piece Name: Front left") +
                    dxf_label("Quantity: 1,1") + dxf_label("SIZE: 38") +
                    dxf_label("Material: Denim") + dxf_label("hello")),
      dxf_label("Sample Size: 40")));
  ASSERT_EQ(read.pieces.size(), 1u);
  const Piece& piece = read.pieces[0];
  EXPECT_EQ(piece.name, "Front left");
  EXPECT_EQ(piece.size, "38");
  EXPECT_EQ(piece.material, "Denim");
  EXPECT_EQ(piece.quantity, 2);
  EXPECT_TRUE(piece.pair);
  EXPECT_TRUE(piece.is_cut_line);
  EXPECT_NEAR(area(piece), 0.12, 1e-12);
  EXPECT_EQ(piece.corners.size(), 1u);
  ASSERT_EQ(piece.notches.size(), 2u);
  EXPECT_NEAR(std::abs(piece.notches[0].angle.value()), 3.14159265, 1e-6);
  EXPECT_FALSE(piece.notches[1].angle);
  ASSERT_TRUE(piece.fold && piece.grain);
  EXPECT_TRUE(piece.grain->to.isApprox(Vec2(0.1, 0.3)));
  EXPECT_EQ(piece.internal_lines.size(), 1u);
  EXPECT_EQ(piece.cut_outs.size(), 1u);
  EXPECT_EQ(piece.drill_holes.size(), 1u);
  EXPECT_EQ(read.base_size, "40");
  EXPECT_EQ(read.ignored.at("LINE on layer '77'"), 1);
  EXPECT_EQ(read.ignored.at("texts without a known key"), 1);
}

TEST(DxfPieces, TheSewLineIsPreferred) {
  const std::string block =
      dxf_block("P", square + dxf_polyline("14", rectangle(10, 10, 280, 380)));
  const PieceDrawing sewn = pieces_of(dxf_file(block, ""));
  EXPECT_FALSE(sewn.pieces[0].is_cut_line);
  EXPECT_NEAR(area(sewn.pieces[0]), 0.28 * 0.38, 1e-12);
  DrawingOptions cut;
  cut.cut_line = true;
  EXPECT_NEAR(area(pieces_of(dxf_file(block, ""), cut).pieces[0]), 0.12, 1e-12);
}

TEST(DxfPieces, ASewLineAcrossAPieceIsNotTaken) {
  // Most of the piece lies beyond the line; a mark in a small piece; a line that leaves the piece.
  const std::vector<std::string> wrong = {
      square + dxf_polyline("14", rectangle(10, 10, 90, 380)),
      dxf_polyline("1", rectangle(0, 0, 160, 160)) + dxf_polyline("14", rectangle(70, 70, 20, 20)),
      square + dxf_polyline("14", rectangle(-10, 10, 300, 380))};
  for (const std::string& piece : wrong) {
    const PieceDrawing read = pieces_of(dxf_file(dxf_block("P", piece), ""));
    EXPECT_TRUE(read.pieces[0].is_cut_line);
    ASSERT_EQ(read.remarks.size(), 1u);
    EXPECT_TRUE(read.remarks[0].warning);
    EXPECT_NE(read.remarks[0].text.find("a.dxf: piece 'P': its line on layer 14"),
              std::string::npos);
  }
  // A hem, and a spike of the boundary where an allowance failed.
  std::vector<Vec2> spike = rectangle(0, 0, 300, 400);
  spike.insert(spike.begin() + 1, {{296, 0}, {300, -150}});
  const PieceDrawing hem = pieces_of(dxf_file(
      dxf_block("P", dxf_polyline("1", spike) + dxf_polyline("14", rectangle(7, 45, 286, 345))),
      ""));
  EXPECT_FALSE(hem.pieces[0].is_cut_line);
  EXPECT_TRUE(hem.remarks.empty());
}

TEST(DxfPieces, AnInternalLineAlongTheBoundaryIsASewLine) {
  const PieceDrawing read = pieces_of(
      dxf_file(dxf_block("P", square + dxf_polyline("8", rectangle(0, 10, 290, 380))) +
                   dxf_block("POCKET", square + dxf_polyline("8", rectangle(50, 100, 200, 280))),
               ""));
  EXPECT_FALSE(read.pieces[0].is_cut_line);
  EXPECT_TRUE(read.pieces[0].internal_lines.empty());
  EXPECT_TRUE(read.pieces[1].is_cut_line);
  EXPECT_EQ(read.pieces[1].internal_lines.size(), 1u);
  EXPECT_HOLDS(all_remarks(read), "is its sew line");
}

TEST(DxfPieces, BlocksArePiecesInsertedOrNotAndNested) {
  const std::string blocks =
      dxf_block("A", square) + dxf_block("MARK", dxf_point("4", {0, 0})) +
      dxf_block("B", square + dxf_insert("MARK", {300, 200})) +
      dxf_block("SHEET", dxf_insert("B", {1000, 0}, "50\n90\n") + dxf_insert("C", {0, 0})) +
      dxf_block("C", dxf_polyline("1", rectangle(0, 0, 100, 100)));
  const PieceDrawing read = pieces_of(dxf_file(blocks, dxf_insert("SHEET", {0, 500})));
  ASSERT_EQ(read.pieces.size(), 3u);
  EXPECT_EQ(read.pieces[0].name, "A");
  EXPECT_EQ(read.pieces[1].name, "B");
  EXPECT_EQ(read.pieces[2].name, "C");
  // The notch stands at (300, 200) of B, which is turned by 90 degrees and moved twice.
  ASSERT_EQ(read.pieces[1].notches.size(), 1u);
  EXPECT_TRUE(read.pieces[1].notches[0].at.isApprox(Vec2(1.0 - 0.2, 0.5 + 0.3), 1e-9));
  EXPECT_TRUE(read.pieces[0].notches.empty());
}

TEST(DxfPieces, AMirroredInsertMakesAPair) {
  const PieceDrawing read = pieces_of(
      dxf_file(dxf_block("SLEEVE", square),
               dxf_insert("SLEEVE", {0, 0}) + dxf_insert("SLEEVE", {900, 0}, "41\n-1\n")));
  ASSERT_EQ(read.pieces.size(), 1u);
  EXPECT_TRUE(read.pieces[0].pair);
  EXPECT_EQ(read.pieces[0].quantity, 2);
}

TEST(DxfPieces, OutlinesInModelSpaceArePieces) {
  // The first is drawn of four lines, one run the wrong way, with a gap of 0.3 mm.
  const std::string entities =
      dxf_segment("1", {0, 0}, {300, 0}) + dxf_segment("1", {300, 400}, {300, 0.3}) +
      dxf_segment("1", {300, 400}, {0, 400}) + dxf_segment("1", {0, 400}, {0, 0}) +
      dxf_segment("7", {50, 50}, {50, 300}) + dxf_label("Piece Name: BACK", {100, 100}) +
      dxf_polyline("1", rectangle(500, 0, 100, 100)) + dxf_segment("8", {900, 900}, {901, 901});
  const PieceDrawing read = pieces_of(dxf_file("", entities));
  ASSERT_EQ(read.pieces.size(), 2u);
  EXPECT_EQ(read.pieces[0].name, "BACK");
  EXPECT_TRUE(read.pieces[0].grain.has_value());
  EXPECT_NEAR(area(read.pieces[0]), 0.12, 1e-4);
  EXPECT_FALSE(read.pieces[1].grain.has_value());
  EXPECT_EQ(read.ignored.at("LINE outside of all pieces"), 1);
  EXPECT_HOLDS(all_remarks(read), "a gap of 0.3 mm");
}

TEST(DxfPieces, WithoutTheLayersAnyClosedLineBoundsAPiece) {
  const PieceDrawing read =
      pieces_of(dxf_file(dxf_block("P", dxf_polyline("CUT", rectangle(0, 0, 300, 400)) +
                                            dxf_polyline("MARKS", rectangle(100, 100, 50, 50))),
                         ""));
  ASSERT_EQ(read.pieces.size(), 1u);
  EXPECT_NEAR(area(read.pieces[0]), 0.12, 1e-12);
  EXPECT_EQ(read.pieces[0].internal_lines.size(), 1u);
}

TEST(DxfPieces, NamesTheGapWithItsSizeAndPlace) {
  const std::string open =
      dxf_polyline("1", {{0, 0}, {300, 0}, {300, 400}, {0, 400}, {0, 12}}, false);
  const std::string message = pieces_error(dxf_file(dxf_block("FRONT", open), ""));
  EXPECT_HOLDS(message,
               "a.dxf: piece 'FRONT': its boundary is open: a gap of 12 mm at (0.0, 6.0) mm");
  EXPECT_HOLDS(pieces_error(dxf_file("", open)), "a gap of 12 mm at (0.0, 6.0) mm");
}

TEST(DxfPieces, TwoOutlinesInABlockAreRefusedACutOutIsNot) {
  EXPECT_HOLDS(pieces_error(dxf_file(
                   dxf_block("TWO", square + dxf_polyline("1", rectangle(400, 0, 100, 100))), "")),
               "has two outlines beside each other");
  const PieceDrawing within = pieces_of(
      dxf_file(dxf_block("ONE", square + dxf_polyline("1", rectangle(100, 100, 50, 50))), ""));
  EXPECT_EQ(within.pieces[0].cut_outs.size(), 1u);
  EXPECT_HOLDS(all_remarks(within), "is taken as a cut-out");
  // The same outline drawn twice is one.
  const PieceDrawing twice = pieces_of(dxf_file(dxf_block("ONE", square + square), ""));
  EXPECT_TRUE(twice.pieces[0].cut_outs.empty());
}

TEST(DxfPieces, TheUnitIsTheUsersTheFilesOrTold) {
  const std::string block = dxf_block("P", dxf_polyline("1", rectangle(0, 0, 20, 30)));
  const auto height = [&](const std::string& header, const std::string& text,
                          const DrawingOptions& options) {
    const Piece piece = pieces_of(dxf_file(block, text, header), options).pieces.at(0);
    return std::sqrt(area(piece) * 30 / 20);
  };
  EXPECT_NEAR(height("", "", {}), 0.30, 1e-9);                           // centimetres, told
  EXPECT_NEAR(height("9\n$MEASUREMENT\n70\n0\n", "", {}), 0.762, 1e-9);  // inches, told
  EXPECT_NEAR(height("9\n$INSUNITS\n70\n1\n", "", {}), 0.762, 1e-9);
  EXPECT_NEAR(height("9\n$INSUNITS\n70\n4\n", dxf_label("Units: ENGLISH"), {}), 0.762, 1e-9);
  DrawingOptions asked;
  asked.unit = 1e-3;
  EXPECT_NEAR(height("9\n$INSUNITS\n70\n1\n", "", asked), 0.03, 1e-9);
  EXPECT_HOLDS(pieces_error(dxf_file(dxf_block("P", square), "", "9\n$INSUNITS\n70\n6\n")),
               "would be 40000.0 cm long in metres, by $INSUNITS; say the unit: --unit");
}

TEST(DxfPieces, AUnitThatMakesNoGarmentIsQuestioned) {
  struct Read {
    double height;  // metres
    std::string unit;
    std::string remarks;
  };
  const auto read = [&](double height, const std::string& units, int insunits = 0) {
    const std::string piece = dxf_polyline("1", rectangle(0, 0, height / 2, height));
    const std::string header = "9\n$INSUNITS\n70\n" + std::to_string(insunits) + "\n";
    const PieceDrawing drawing = pieces_of(
        dxf_file(dxf_block("P", piece), dxf_label("Units: " + units), insunits > 0 ? header : ""));
    return Read{std::sqrt(2 * area(drawing.pieces.at(0))), drawing.unit, all_remarks(drawing)};
  };
  constexpr int inches = 1;
  constexpr int millimetres = 4;
  constexpr int centimetres = 5;
  const Read small = read(60, "METRIC");
  EXPECT_NEAR(small.height, 0.6, 1e-9);
  EXPECT_EQ(small.unit, "centimetres, by the size of the largest piece");
  EXPECT_HOLDS(small.remarks,
               "the largest piece is 6.0 cm long in millimetres, by 'Units: metric'; centimetres "
               "are taken, which makes it 60.0 cm; it would be 152.4 cm with --unit inch");
  EXPECT_NEAR(read(60, "METRIC", centimetres).height, 0.6, 1e-9);
  EXPECT_NEAR(read(60, "METRIC", inches).height, 0.6, 1e-9);
  EXPECT_EQ(read(60, "MM", centimetres).unit, "centimetres, by $INSUNITS");
  // Two statements of millimetres, and one that is no other unit.
  for (const Read& stays :
       {read(60, "METRIC", millimetres), read(60, "MM"), read(60, "METRIC (mm)")}) {
    EXPECT_NEAR(stays.height, 0.06, 1e-9);
    EXPECT_HOLDS(stays.remarks, "it would be 60.0 cm with --unit cm");
  }
  EXPECT_HOLDS(read(4500, "METRIC").remarks, "the largest piece is 450.0 cm long in millimetres");
  const Read both = read(600, "METRIC", centimetres);
  EXPECT_NEAR(both.height, 0.6, 1e-9);
  EXPECT_HOLDS(both.remarks, "by 'Units: metric', though $INSUNITS says centimetres");
  EXPECT_EQ(read(600, "METRIC", millimetres).remarks, "");
}

TEST(DxfPieces, OpenSewLinesAreClosedAlongTheBoundary) {
  const auto sewn = [&](const std::string& lines) {
    return area(pieces_of(dxf_file(dxf_block("P", square + lines), "")).pieces.at(0));
  };
  const std::vector<Vec2> fold = {{0, 10}, {290, 10}, {290, 390}, {0, 390}};
  EXPECT_NEAR(sewn(dxf_polyline("14", fold, false)), 0.29 * 0.38, 1e-9);
  // It ends at a corner of the boundary, too, and runs the other way.
  const std::vector<Vec2> side = {{0, 400}, {290, 400}, {290, 0}};
  EXPECT_NEAR(sewn(dxf_polyline("14", side, false)), 0.29 * 0.4, 1e-9);
  // No allowance at the hem and at the upper end.
  EXPECT_NEAR(sewn(dxf_segment("14", {10, 0}, {10, 400}) + dxf_segment("14", {280, 0}, {280, 400})),
              0.27 * 0.4, 1e-9);
  const std::string open = dxf_polyline("14", {{0, 10}, {290, 10}, {290, 390}, {50, 390}}, false);
  EXPECT_HOLDS(pieces_error(dxf_file(dxf_block("P", square + open), "")), "its sew line is open");
  DrawingOptions cut;
  cut.cut_line = true;
  const PieceDrawing whole = pieces_of(dxf_file(dxf_block("P", square + open), ""), cut);
  EXPECT_NEAR(area(whole.pieces.at(0)), 0.12, 1e-9);
}

TEST(DxfPieces, RefusesWhatHoldsNoPiece) {
  EXPECT_HOLDS(pieces_error(dxf_file("", "")), "holds no outline of a piece");
  EXPECT_HOLDS(
      pieces_error(dxf_file(dxf_block("A", dxf_insert("A", {0, 0})), dxf_insert("A", {0, 0}))),
      "block 'A' inserts itself");
}

/// A piece of Valentina's, as an own small reading of the group codes in Python has it. That took
/// the polylines' vertices as they stand: areas by the shoelace formula, in square millimetres.
struct Reference {
  const char* name;
  double sewn;
  double cut;
};

void expect_pieces(const std::string& file, const std::vector<Reference>& expected) {
  const auto path = real_pattern("../valentina/" + file);
  if (!path) GTEST_SKIP() << file << " is not in ../shared/data or TOILE_DATA";
  const std::string text = read_file(*path);
  const PieceDrawing sewn = pieces_of(text);
  DrawingOptions options;
  options.cut_line = true;
  const PieceDrawing cut = pieces_of(text, options);
  ASSERT_EQ(sewn.pieces.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(sewn.pieces[i].name, expected[i].name);
    EXPECT_NEAR(area(sewn.pieces[i]) * 1e6, expected[i].sewn, expected[i].sewn * 1e-3);
    EXPECT_NEAR(area(cut.pieces[i]) * 1e6, expected[i].cut, expected[i].cut * 1e-3);
    EXPECT_FALSE(sewn.pieces[i].is_cut_line);
    EXPECT_FALSE(sewn.pieces[i].grain) << "the files have no grain lines";
  }
  EXPECT_HOLDS(all_remarks(sewn), "states no unit; lengths are taken as millimetres");
}

TEST(DxfPieces, ReadsValentinasBodice) {
  expect_pieces("bodice_block_aama_r12.dxf",
                {{"BackPanel2", 256559.46, 284878.76}, {"BackPanel1", 255318.34, 282475.52}});
}

TEST(DxfPieces, ReadsValentinasSheet) {
  expect_pieces("tshirt_aama_r12_sheet.dxf", {{"DETAIL", 170156.54, 187137.93},
                                              {"DETAIL", 134233.25, 145542.49},
                                              {"DETAIL", 126039.39, 138254.52},
                                              {"DETAIL", 4704.86, 10813.32},
                                              {"DETAIL", 3637.35, 6754.09}});
}

TEST(DxfPieces, ReadsValentinasDetails) {
  expect_pieces("tshirt_aama_r14_details.dxf", {{"Detail", 170156.54, 187137.93},
                                                {"Detail", 126039.39, 138254.52},
                                                {"Detail", 134233.25, 145542.49},
                                                {"Detail", 3637.35, 6754.09},
                                                {"Detail", 4704.86, 10813.32}});
}

TEST(DxfPieces, ReadsCutTwoOfALabel) {
  const PieceDrawing read = pieces_of(dxf_file(
      dxf_block("BACKPANEL2", square + dxf_label("BackPanel2") + dxf_label("Fabric, Cut 2")), ""));
  EXPECT_EQ(read.pieces[0].name, "BackPanel2");
  EXPECT_EQ(read.pieces[0].quantity, 2);
  EXPECT_EQ(read.pieces[0].material, "Fabric");
  EXPECT_FALSE(read.pieces[0].pair);
}

}  // namespace dxf_pieces_test
}  // namespace toile
