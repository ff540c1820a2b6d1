#include "pattern/import/svg_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/output_file.h"
#include "pattern/import/join_paths.h"
#include "tests/support/run_program.h"

namespace toile {
namespace svg_pieces_test {

/// A drawing in millimetres.
std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
         attributes + " width=\"1000mm\" height=\"1000mm\" viewBox=\"0 0 1000 1000\">" + content +
         "</svg>";
}
const std::string freesewing = "xmlns:freesewing=\"http://freesewing.org/namespaces/freesewing\"";

PieceDrawing read(const std::string& content, const std::string& attributes = "",
                  const DrawingOptions& options = {}) {
  return svg_pieces(svg(content, attributes), "x.svg", options);
}

std::string message_of(const std::string& content) {
  try {
    read(content);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

double area_cm2(const PiecePath& path) {
  return std::abs(signed_area(loop_points(path, 1e-6))) * 1e4;
}

std::vector<std::string> names(const PieceDrawing& drawing) {
  std::vector<std::string> all;
  for (const Piece& piece : drawing.pieces) all.push_back(piece.name);
  return all;
}

std::string all_remarks(const PieceDrawing& drawing) {
  std::string all;
  for (const Remark& remark : drawing.remarks) all += remark.text + "\n";
  return all;
}

TEST(SvgPieces, OnlyOutlinesHaveToBeReadable) {
  const auto drawing = [](const std::string& broken_class) {
    return "<path class=\"fabric\" d=\"M 100,100 h 200 v 300 h -200 z\"/>"
           "<path class=\"" +
           broken_class + "\" d=\"M 0,NaN L 0,375\"/>";
  };
  const PieceDrawing drawn = read(drawing("mark dotted"), freesewing);
  EXPECT_EQ(drawn.pieces.size(), 1u);
  EXPECT_EQ(drawn.ignored.at("line that can't be read"), 1);
  EXPECT_NE(all_remarks(drawn).find("x.svg:1: path: a number is missing at character 5"),
            std::string::npos);
  EXPECT_TRUE(drawn.left_out.empty());
  for (const std::string may_be_outline : {"fabric", "various", ""}) {
    const PieceDrawing other = read(drawing(may_be_outline), freesewing);
    EXPECT_EQ(other.pieces.size(), 1u);
    EXPECT_EQ(other.left_out.size(), 1u) << may_be_outline;
  }
  EXPECT_EQ(read(drawing("mark dotted")).left_out.size(), 1u);
  EXPECT_THROW(read(drawing("fabric sa"), freesewing), Error);
}

TEST(SvgPieces, SeamLinesAreFoundInAllowancesWhoseClassesDiffer) {
  const std::string seam = " d=\"M 100,100 h 200 v 300 h -200 z\"/>";
  // The allowance crosses itself at a corner, as offset ones do.
  const std::string cut = " d=\"M 90,90 H 310 V 410 H 85 V 400 H 95 V 420 H 90 z\"/>";
  const auto piece = [&](const std::string& seam_class, const std::string& cut_class) {
    return read("<g id=\"fs-stack-a-part-a.back\"><path" + seam_class + seam + "<path class=\"" +
                    cut_class + "\"" + cut + "</g>" +
                    "<g id=\"fs-stack-a-part-a.front\"><path class=\"fabric\" "
                    "d=\"M 500,0 h 100 v 100 h -100 z\"/></g>",
                freesewing);
  };
  for (const auto& drawing : {piece("", "fabric sa"), piece(" class=\"fabric\"", "sa"),
                              piece(" class=\"canvas\"", "fabric sa")}) {
    ASSERT_EQ(drawing.pieces.size(), 2u);
    EXPECT_FALSE(drawing.pieces[0].is_cut_line);
    EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 600, 1e-6);
    EXPECT_NE(drawing.pieces[0].material, "");
  }
}

TEST(SvgPieces, PartsWithoutAMaterialAreTheirLargestOutline) {
  const PieceDrawing drawing = read(
      "<g id=\"fs-stack-a-part-a.back\"><path class=\"fabric\" "
      "d=\"M 100,100 h 200 v 300 h -200 z\"/></g>"
      "<g id=\"fs-stack-a-part-a.cuff\"><path d=\"M 510,10 h 50 v 50 h -50 z\"/>"
      "<path class=\"ribbing\" d=\"M 500,0 h 100 v 100 h -100 z\"/></g>",
      freesewing);
  EXPECT_EQ(names(drawing), (std::vector<std::string>{"back", "cuff"}));
  ASSERT_EQ(drawing.pieces.size(), 2u);
  EXPECT_NEAR(area_cm2(drawing.pieces[1].outline), 100, 1e-6);
}

TEST(SvgPieces, MarksOfMeasuresAreNoOutlinesWithGaps) {
  const PieceDrawing drawing = read(
      "<g id=\"fs-stack-a-part-a.collar\"><path class=\"fabric\" "
      "d=\"M 100,100 h 200 v 300 h -200 z\"/>"
      // Lines from both ends of a measure to where its number stands, and one across.
      "<path class=\"mark dotted\" d=\"M 300,100 h 230\"/>"
      "<path class=\"mark dotted\" d=\"M 300,140 h 230\"/>"
      "<path class=\"mark dotted\" d=\"M 530,100 v 40\"/></g>",
      freesewing);
  ASSERT_EQ(drawing.pieces.size(), 1u);
  EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 600, 1e-6);
}

TEST(SvgPieces, FreeSewingsTshirt) {
  TOILE_REAL_DATA(path, "patterns/freesewing/teagan_tshirt.svg");
  const PieceDrawing drawing = svg_pieces(read_file(path), "teagan.svg", {});
  EXPECT_EQ(names(drawing), (std::vector<std::string>{"front", "back", "sleeve"}));
  ASSERT_EQ(drawing.pieces.size(), 3u);
  const Piece& front = drawing.pieces[0];
  const Piece& back = drawing.pieces[1];
  const Piece& sleeve = drawing.pieces[2];
  // The file's paths, each curve cut into 20,000 chords by a script apart from this code.
  EXPECT_NEAR(area_cm2(front.outline), 1472.41516, 0.01);
  EXPECT_NEAR(area_cm2(back.outline), 1525.27999, 0.01);
  EXPECT_NEAR(area_cm2(sleeve.outline), 545.86090, 0.01);
  for (const Piece* half : {&front, &back}) {
    ASSERT_TRUE(half->fold);
    // Cut on the fold, along the middle: upright, and 475 mm long.
    EXPECT_NEAR(half->fold->from.x(), half->fold->to.x(), 1e-9);
    EXPECT_NEAR((half->fold->to - half->fold->from).norm(), 0.47475, 1e-9);
    ASSERT_TRUE(half->grain);
    EXPECT_NEAR(half->grain->from.x(), half->grain->to.x(), 1e-9);
    EXPECT_EQ(half->quantity, 1);
    EXPECT_FALSE(half->pair);
    EXPECT_EQ(half->notches.size(), 1u);
  }
  EXPECT_FALSE(sleeve.fold);
  ASSERT_TRUE(sleeve.grain);
  EXPECT_NEAR((sleeve.grain->to - sleeve.grain->from).norm(), 0.19423, 1e-9);
  EXPECT_EQ(sleeve.quantity, 2);
  EXPECT_TRUE(sleeve.pair);
  // Its front half, with one notch, is drawn on the right.
  EXPECT_TRUE(sleeve.is_right_one);
  EXPECT_EQ(sleeve.notches.size(), 2u);
  for (const Piece& piece : drawing.pieces) {
    EXPECT_EQ(piece.material, "fabric");
    EXPECT_FALSE(piece.is_cut_line);
    EXPECT_TRUE(piece.internal_lines.empty());
    for (const PieceNotch& notch : piece.notches) {
      const auto outline = loop_points(piece.outline, 1e-6);
      double nearest = 1;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        nearest = std::min(
            nearest, distance_to_segment(notch.at, outline[i], outline[(i + 1) % outline.size()]));
      }
      EXPECT_LT(nearest, 1e-4) << piece.name;
    }
  }
  EXPECT_EQ(drawing.ignored.at("help line"), 4);
  EXPECT_EQ(drawing.ignored.at("scale box"), 2);
}

const std::string part_start = "<g id='fs-stack-d.yoke-part-d.yoke' transform='translate(10 20)'>";

TEST(SvgPieces, SeamLinesAreTakenBeforeCutLines) {
  const std::string cut = "<path class='fabric sa' d='M0 0h220v120h-220z'/>";
  const std::string seam = "<path class='fabric' d='M10 10h200v100h-200z'/>";
  for (const std::string& both : {cut + seam, seam + cut}) {
    const PieceDrawing drawing = read(part_start + both + "</g>", freesewing);
    EXPECT_EQ(names(drawing), std::vector<std::string>{"yoke"});
    EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 200, 1e-9);
    EXPECT_FALSE(drawing.pieces[0].is_cut_line);
    DrawingOptions options;
    options.cut_line = true;
    const PieceDrawing as_cut =
        svg_pieces(svg(part_start + both + "</g>", freesewing), "x", options);
    ASSERT_EQ(as_cut.pieces.size(), 1u);
    EXPECT_NEAR(area_cm2(as_cut.pieces[0].outline), 264, 1e-9);
  }
  const PieceDrawing alone = read(part_start + cut + "</g>", freesewing);
  ASSERT_EQ(alone.pieces.size(), 1u);
  EXPECT_TRUE(alone.pieces[0].is_cut_line);
  EXPECT_NEAR(area_cm2(alone.pieces[0].outline), 264, 1e-9);
}

TEST(SvgPieces, LiningsAndInterfacingsAreCutApart) {
  const PieceDrawing drawing =
      read(part_start +
               "<path class='fabric' d='M0 0h200v100h-200z'/>"
               "<path class='interfacing' d='M0 0h200v30h-200z'/>"
               "<path class='note dashed' d='M20 50h100'/><path class='note' d='M20 60h9v9h-9z'/>"
               "<text x='5' y='50'><tspan>Cut 2 mirrored from main fabric</tspan></text>"
               "<text x='5' y='55'>Cut 1 on the fold from interfacing</text></g>",
           freesewing);
  EXPECT_EQ(names(drawing), (std::vector<std::string>{"yoke", "yoke_interfacing"}));
  EXPECT_EQ(drawing.pieces[0].quantity, 2);
  EXPECT_TRUE(drawing.pieces[0].pair);
  EXPECT_EQ(drawing.pieces[1].quantity, 1);
  EXPECT_EQ(drawing.pieces[1].material, "interfacing");
  EXPECT_EQ(drawing.pieces[0].internal_lines.size(), 1u);
  EXPECT_EQ(drawing.ignored.at("small closed path"), 1);
}

TEST(SvgPieces, OneTextMaySayAllThatIsCut) {
  const std::string key = "plugin-annotations:";
  const auto said = [](const std::string& text) {
    return read(part_start + "<path class='fabric' d='M0 0h200v100h-200z'/><text x='5' y='50'>" +
                    text + "</text></g>",
                freesewing)
        .pieces.at(0);
  };
  const std::string fabric = key + "cut,2," + key + "mirrored," + key + "from," + key + "fabric,";
  const std::string canvas = key + "cut,1," + key + "from," + key + "canvas,";
  for (const std::string& text :
       {fabric + "," + canvas, canvas + "," + fabric,
        std::string("Cut 2 mirrored from main fabric Cut 1 from canvas")}) {
    const Piece piece = said(text);
    EXPECT_EQ(piece.quantity, 2) << text;
    EXPECT_TRUE(piece.pair) << text;
    EXPECT_EQ(piece.material, "fabric") << text;
  }
}

TEST(SvgPieces, APocketInAnAllowanceIsNoSeamLine) {
  const std::string cut = "<path class='fabric sa' d='M-10 -10h220v320h-220z'/>";
  const std::string pocket = "<path class='fabric' d='M50 50h40v40h-40z'/>";
  const PieceDrawing without = read(part_start + cut + pocket + "</g>", freesewing);
  ASSERT_EQ(without.pieces.size(), 1u);
  EXPECT_TRUE(without.pieces[0].is_cut_line);
  EXPECT_NEAR(area_cm2(without.pieces[0].outline), 22 * 32, 1e-6);
  const std::string seam = "<path d='M0 0h200v300h-200z'/>";
  const PieceDrawing with = read(part_start + cut + seam + pocket + "</g>", freesewing);
  ASSERT_EQ(with.pieces.size(), 1u);
  EXPECT_FALSE(with.pieces[0].is_cut_line);
}

TEST(SvgPieces, PlainDrawingsHaveOnePieceForEachOutermostPath) {
  const PieceDrawing drawing = read(
      "<g inkscape:label='Sleeves'>"
      "<path id='path12' inkscape:label='upper sleeve' d='M0 0h100v200h-100zM20 20h40v40h-40z'/>"
      "<path id='under_sleeve' d='M120 0h100v200h-100z'/></g>"
      "<rect id='rect7' x='300' width='100' height='100'/><text x='320' y='40'>3</text>"
      "<text x='320' y='50'>Pocket</text>"
      "<g id='collar'><polygon points='500,0 700,0 700,80 500,80'/>"
      "<line id='grainline' x1='520' y1='40' x2='680' y2='40'/>"
      "<line x1='510' y1='0' x2='510' y2='6' id='notch-1'/>"
      "<path d='M550 10v60'/><circle cx='600' cy='20' r='2'/>"
      "<rect x='610' y='20' width='40' height='40'/>"
      "<rect id='cutout' x='655' y='20' width='20' height='40'/></g>"
      "<path d='M800 900h50'/>");
  EXPECT_EQ(names(drawing),
            (std::vector<std::string>{"upper sleeve", "under_sleeve", "Pocket", "collar"}));
  EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 200, 1e-9);
  EXPECT_EQ(drawing.pieces[0].cut_outs.size(), 1u);
  const Piece& collar = drawing.pieces[3];
  EXPECT_EQ(collar.internal_lines.size(), 2u);
  EXPECT_EQ(collar.cut_outs.size(), 1u);
  ASSERT_EQ(collar.drill_holes.size(), 1u);
  EXPECT_TRUE(collar.drill_holes[0].isApprox(Vec2(0.6, -0.02)));
  ASSERT_TRUE(collar.grain);
  EXPECT_NEAR(collar.grain->from.y(), collar.grain->to.y(), 1e-12);
  ASSERT_EQ(collar.notches.size(), 1u);
  EXPECT_EQ(drawing.ignored.at("line outside of the pieces"), 1);
}

TEST(SvgPieces, LinesAlongEachOtherAreSeamAndCutLine) {
  const PieceDrawing drawing =
      read("<path d='M0 0h320v220h-320z'/><path id='yoke' d='M10 10h300v200h-300z'/>");
  ASSERT_EQ(drawing.pieces.size(), 1u);
  EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 600, 1e-9);
  EXPECT_NE(all_remarks(drawing).find("seam line"), std::string::npos);
  // A pocket near one corner is none.
  const PieceDrawing pocket =
      read("<path d='M0 0h320v220h-320z'/><path d='M10 10h190v200h-190z'/>");
  EXPECT_NEAR(area_cm2(pocket.pieces[0].outline), 704, 1e-9);
  EXPECT_EQ(pocket.pieces[0].internal_lines.size(), 1u);
}

TEST(SvgPieces, SmallGapsAreClosedAndLargeOnesAreNamed) {
  const auto frame = [](double gap) {
    return "<g><line x1='0' y1='" + std::to_string(gap) +
           "' x2='0' y2='100'/><line x1='0' y1='100' x2='100' y2='100'/>"
           "<path id='side' d='M100 100L100 0L0 0'/></g>";
  };
  const PieceDrawing drawing = read(frame(0.3));
  ASSERT_EQ(drawing.pieces.size(), 1u);
  EXPECT_NEAR(area_cm2(drawing.pieces[0].outline), 100, 0.2);
  EXPECT_NE(all_remarks(drawing).find("0.3 mm"), std::string::npos) << all_remarks(drawing);
  const std::string message = message_of(frame(8));
  EXPECT_NE(message.find("8 mm at (0, 4)"), std::string::npos) << message;
  // An outline beside a sound one goes missing no more than one alone.
  const PieceDrawing beside = read("<rect x='300' width='90' height='90'/>" + frame(8));
  ASSERT_EQ(beside.left_out.size(), 1u);
  const std::string why = beside.left_out[0].error.what();
  EXPECT_NE(why.find("gap of 8 mm at (0, 4)"), std::string::npos) << why;
}

TEST(SvgPieces, UnitsAreTheFilesOrTheUsers) {
  const std::string path = "<path d='M0 0h96v192h-96z'/>";
  const auto in_pixels = [&](const DrawingOptions& options) {
    return svg_pieces("<svg viewBox='0 0 500 500'>" + path + "</svg>", "x.svg", options);
  };
  const PieceDrawing pixels = in_pixels({});
  EXPECT_NEAR(area_cm2(pixels.pieces[0].outline), 2 * 2.54 * 2.54, 1e-9);
  EXPECT_NE(all_remarks(pixels).find("no unit"), std::string::npos);
  DrawingOptions options;
  options.unit = 1e-3;
  const PieceDrawing millimetres = in_pixels(options);
  EXPECT_NEAR(area_cm2(millimetres.pieces[0].outline), 9.6 * 19.2, 1e-9);
  EXPECT_TRUE(all_remarks(millimetres).empty());
  EXPECT_TRUE(all_remarks(read(path)).empty());
}

TEST(SvgPieces, NothingToFindIsAnError) {
  EXPECT_NE(message_of("").find("no closed outline"), std::string::npos);
  EXPECT_NE(message_of("<path d='M0 0h100v100'/>").find("open by 141.4 mm"), std::string::npos)
      << message_of("<path d='M0 0h100v100'/>");
  std::string many;
  for (int i = 0; i < 1100; ++i) {
    many += "<rect x='" + std::to_string(30 * i) + "' width='25' height='25'/>";
  }
  EXPECT_NE(message_of(many).find("more than 1000"), std::string::npos);
}

}  // namespace svg_pieces_test
}  // namespace toile
