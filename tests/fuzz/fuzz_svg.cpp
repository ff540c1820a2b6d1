// SVG, from the bytes to the pattern.
#include <nlohmann/json.hpp>

#include "pattern/file/pattern_file.h"
#include "pattern/import/imported_pattern.h"
#include "pattern/import/svg_pieces.h"
#include "tests/fuzz/fuzz.h"

int main(int argc, char** argv) {
  using namespace toile;
  std::vector<std::filesystem::path> seeds;
  for (const char* name : {"classes.svg", "plain.svg"}) {
    seeds.push_back(std::filesystem::path(TOILE_SOURCE_DIR) / "tests/fuzz/svg" / name);
  }
  const std::vector<std::string> words = {"0",
                                          "-1",
                                          "1e300",
                                          "nan",
                                          "1e-9",
                                          "4294967296",
                                          "%",
                                          "px",
                                          "M 0,0",
                                          "z",
                                          "a 1 1 0 0 1 2,0",
                                          "a 1 0 0 1 1 -5,0",
                                          "C",
                                          "Q",
                                          "T",
                                          "S",
                                          "h",
                                          "V 1e9",
                                          "scale(0)",
                                          "scale(-1, 1)",
                                          "skewX(90)",
                                          "matrix(0 0 0 0 0 0)",
                                          "rotate(45, 1, 1)",
                                          "<g>",
                                          "</g>",
                                          "<path d=\"",
                                          "<use href=\"#notch\"/>",
                                          "<use href=\"#fs-container\"/>",
                                          "id=\"notch\"",
                                          "class=\"fabric\"",
                                          "class=\"sa\"",
                                          "class=\"cutonfold\"",
                                          "class=\"grainline\"",
                                          "display:none",
                                          "viewBox=\"0 0 0 0\"",
                                          "viewBox=\"0 0 1 1e-300\"",
                                          "<!DOCTYPE a [<!ENTITY b \"c\">]>",
                                          "&b;",
                                          "&#0;",
                                          "<![CDATA[",
                                          "<script>",
                                          "fold",
                                          "cut 2",
                                          "\xff\xfe"};
  return fuzz::run(argc, argv, seeds, words, [](const std::string& text) {
    std::vector<Remark> remarks;
    ImportOptions options;
    if (text.size() % 2 == 0) options.seam_allowance = 0.008;
    const ImportedPattern made = import_pieces(svg_pieces(text, "a.svg", {}), options, remarks);
    parse_pattern(readable_json(pattern_json(made)), "a.json", remarks);
  });
}
