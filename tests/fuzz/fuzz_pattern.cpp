// GarmentCode's JSON, as import-pattern repairs it and as mesh-pattern reads it.
#include "geometry/error.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/repair_pattern.h"
#include "tests/fuzz/fuzz.h"

int main(int argc, char** argv) {
  using namespace toile;
  std::vector<std::filesystem::path> seeds;
  for (const char* name : {"tests/fuzz/pattern/generations.json", "samples/tshirt.json",
                           "samples/elastic_skirt.json"}) {
    seeds.push_back(std::filesystem::path(TOILE_SOURCE_DIR) / name);
  }
  const std::vector<std::string> words = {"0",
                                          "-1",
                                          "1e300",
                                          "1e-300",
                                          "NaN",
                                          "null",
                                          "true",
                                          "[]",
                                          "{}",
                                          "\"\"",
                                          "99999999999",
                                          "[0, 0]",
                                          "[0.5, 1e9]",
                                          "\"cubic\"",
                                          "\"quadratic\"",
                                          "\"circle\"",
                                          "\"params\"",
                                          "\"endpoints\"",
                                          "\"edge\"",
                                          "\"panel\"",
                                          "\"right_wrong\"",
                                          "\"stitches\"",
                                          "\"panel_order\"",
                                          "\"vertices\"",
                                          "\"attachments\"",
                                          "\"elastic\"",
                                          "\"gather\"",
                                          "\"notches\"",
                                          "\"units_in_meter\"",
                                          "\"rotation\"",
                                          "\"translation\"",
                                          "\"label\"",
                                          "\\u0000",
                                          "\\ud800",
                                          "\xff\xfe"};
  return fuzz::run(argc, argv, seeds, words, [](const std::string& text) {
    std::vector<Remark> remarks;
    std::string repaired = text;
    try {
      repaired = repaired_pattern(text, "a.json", remarks);
    } catch (const Error&) {
      // What import-pattern refuses, mesh-pattern may get nevertheless.
    }
    parse_pattern(repaired, "a.json", remarks);
  });
}
