// Measures as people have them: JSON, CSV, .vit, FreeSewing's and GarmentCode's files, from the
// bytes to all the measures of a mannequin.
#include "geometry/body/body_proportions.h"
#include "geometry/body/measure_checks.h"
#include "geometry/error.h"
#include "io/measures_file.h"
#include "tests/fuzz/fuzz.h"

int main(int argc, char** argv) {
  using namespace toile;
  const std::filesystem::path folder =
      std::filesystem::path(TOILE_SOURCE_DIR) / "tests/fuzz/measures";
  std::vector<std::filesystem::path> seeds;
  for (const char* name :
       {"measures.json", "measures.csv", "seamly.vit", "freesewing.json", "garmentcode.yaml"}) {
    seeds.push_back(folder / name);
  }
  const std::vector<std::string> words = {"height",
                                          "bust",
                                          "\"hip\": 98,",
                                          "left_wrist",
                                          "nan",
                                          "-1",
                                          "0",
                                          "1e308",
                                          "1e-300",
                                          "null",
                                          "\"unit\": \"inch\",",
                                          "\"units\": \"imperial\",",
                                          "{",
                                          "[",
                                          "]",
                                          "}",
                                          "\"measures\": {",
                                          "\"measurements\": 3",
                                          "<m name=\"bust_circ\" value=\"94\" />",
                                          "<m name=\"height\" value=\"(#waist_circ*2)\" />",
                                          "<unit>mm</unit>",
                                          "</vit>",
                                          "<!DOCTYPE a [<!ENTITY b \"cc\">]>",
                                          "&b;",
                                          "<![CDATA[",
                                          "bust,94,parsec",
                                          "name,value,unit",
                                          "\"a \"\"b\"\" c\",1",
                                          ",,,,",
                                          "body:",
                                          "  bust: 94",
                                          "\t- a",
                                          "\\u0000",
                                          "\\ud800",
                                          "\xff\xfe"};
  const std::string program = argv[0];
  return fuzz::run(argc, argv, seeds, words, [&](const std::string& text) {
    std::string end = ".csv";
    if (text.starts_with("{")) end = ".json";
    if (text.starts_with("<")) end = ".vit";
    if (text.starts_with("body")) end = ".yaml";
    const fuzz::ScratchFile file(program + end, text);
    MeasureSet set = read_measures(file.path);
    contradictions(set.values);
    // What follows may refuse what was read.
    try {
      add_measure(text.substr(0, text.find('\n')), 0.01, set);
    } catch (const Error&) {
    }
    try {
      filled_measures(set.values, FigureType::woman);
    } catch (const Error&) {
    }
  });
}
