// DXF, from the bytes to the pattern.
#include <nlohmann/json.hpp>

#include "pattern/file/pattern_file.h"
#include "pattern/import/dxf_pieces.h"
#include "pattern/import/imported_pattern.h"
#include "tests/fuzz/fuzz.h"

int main(int argc, char** argv) {
  using namespace toile;
  std::vector<std::filesystem::path> seeds;
  for (const char* name : {"r12.dxf", "r2000.dxf", "r2007.dxf", "r2013.dxf", "sheet.dxf"}) {
    seeds.push_back(std::filesystem::path(TOILE_SOURCE_DIR) / "tests/io/drawings" / name);
  }
  const std::vector<std::string> words = {"0",
                                          "1",
                                          "6",
                                          "14",
                                          "10",
                                          "20",
                                          "42",
                                          "70",
                                          "-1",
                                          "1e300",
                                          "nan",
                                          "300.0",
                                          "0.0",
                                          "1e-9",
                                          "999999",
                                          "4294967296",
                                          "LINE",
                                          "SPLINE",
                                          "INSERT",
                                          "VERTEX",
                                          "SEQEND",
                                          "ENDBLK",
                                          "BLOCK",
                                          "ENDSEC",
                                          "EOF",
                                          "FRONT",
                                          "ELLIPSE",
                                          "ARC",
                                          "CIRCLE",
                                          "POLYLINE",
                                          "LWPOLYLINE",
                                          "MTEXT",
                                          "ATTRIB",
                                          "8\n6",
                                          "0\nINSERT\n2\nFRONT\n41\n-1",
                                          "Quantity: 1,1",
                                          "Size: XL",
                                          "\\U+0041",
                                          "{\\f;",
                                          "\xff\xfe"};
  return fuzz::run(argc, argv, seeds, words, [](const std::string& text) {
    std::vector<Remark> remarks;
    ImportOptions options;
    if (text.size() % 2 == 0) options.seam_allowance = 0.008;
    const PieceDrawing drawing = dxf_pieces(parse_dxf(text, "a.dxf"), "a.dxf", {});
    const ImportedPattern made = import_pieces(drawing, options, remarks);
    parse_pattern(readable_json(pattern_json(made)), "a.json", remarks);
  });
}
