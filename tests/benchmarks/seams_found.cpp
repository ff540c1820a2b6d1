// How many seams of patterns that have them find-seams finds again, as a table. By hand:
//
//   cmake --build build/release --target bench_seams_found
//   build/release/tests/bench_seams_found samples ../shared/data/patterns/garmentcode
//
// Each argument is a row: a folder of pattern files, or a file.
//
// With `--features FILE` a line is written for each seam: file, names kept, whether it is right,
// its confidence, and what that is told from. fit_seam_certainty.py reads it.
//
// With names, panels that are no pieces of the shell are left out, as find-seams does. Their seams
// count as missed.
//
// `--names kept` or `--names gone` leaves the other rows out.
//
// `--mistakes` prints the wrong and the missed seams of each garment to standard error.
//
// Seams, translations, rotations, placements and labels are taken out of each pattern first. Names
// stay in one row and become piece1, piece2 and so on in the next. A seam is right where it joins
// the same two edges in the same direction. Panels that coincide count as one another where names
// are gone; with names, a panel that is its own mirror image may be turned over.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/shell_panels.h"
#include "tests/support/seam_comparison.h"

namespace {

using namespace toile;

/// Lower ends of the ranges of confidence whose seams are counted.
constexpr std::array bin_starts = {0.0, 0.5, 0.7, 0.8, decided_confidence, 0.95};
constexpr std::size_t bins = bin_starts.size();

struct Row {
  int garments = 0;
  int whole = 0;
  int stated = 0;
  int found = 0;
  int right = 0;
  int listed = 0;        // seams sewn or undecided
  int listed_right = 0;  // of these
  std::vector<double> seconds;
  std::array<std::array<int, 2>, bins> bin{};  // of confidence: seams, and right ones
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// What is written besides the table.
struct Output {
  std::FILE* features = nullptr;
  bool mistakes = false;
};

void add(Row& row, const std::filesystem::path& file, bool names, const Output& output) {
  const std::string text = read_file(file);
  std::vector<Remark> remarks;
  Pattern pattern = parse_drawn_pattern(text, file.string(), remarks);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, file.string());
  if (names) {
    for (const auto& [panel, kind] : panels_beside_shell(pattern)) {
      pattern.panels[panel].left_out = kind;
    }
  }
  const std::size_t all_stated = pattern.stitches.size();
  pattern = without_left_out(std::move(pattern), remarks);
  const int lost = static_cast<int>(all_stated - pattern.stitches.size());
  const auto start = std::chrono::steady_clock::now();
  const FoundSeams found = find_seams(stripped(pattern, names, false), options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::set<SeamPair> decided;
  std::set<SeamPair> listed;
  for (const FoundSeam& seam : found.seams) {
    listed.insert(seam_pair(seam.a, seam.b, seam.reversed));
    if (seam.confidence < decided_confidence) continue;
    decided.insert(seam_pair(seam.a, seam.b, seam.reversed));
  }
  SeamComparison comparison(pattern, options.drawn_walk, !names);
  const std::set<SeamPair> stated = stated_seams(pattern);
  const SeamMatches figures = comparison.compare(stated, decided);
  row.listed_right += comparison.compare(stated, listed).right;
  row.listed += static_cast<int>(listed.size());
  for (const FoundSeam& seam : found.seams) {
    const bool right = comparison.right(seam_pair(seam.a, seam.b, seam.reversed));
    std::size_t bin = bins - 1;
    while (seam.confidence < bin_starts[bin]) --bin;
    ++row.bin[bin][0];
    row.bin[bin][1] += right ? 1 : 0;
    if (output.features == nullptr) continue;
    std::fprintf(output.features, "%s %d %d %.4f", file.filename().c_str(), names ? 1 : 0,
                 right ? 1 : 0, seam.confidence);
    for (const double feature : seam.features) std::fprintf(output.features, " %.5f", feature);
    std::fprintf(output.features, "\n");
  }
  if (output.mistakes) {
    std::fprintf(stderr, "%s%s\n", file.filename().c_str(), names ? "" : " nameless");
    for (const std::string& line : comparison.mistakes(pattern)) {
      std::fprintf(stderr, "  %s\n", line.c_str());
    }
  }
  ++row.garments;
  row.whole += figures.whole() && lost == 0 ? 1 : 0;
  row.stated += figures.stated + lost;
  row.found += figures.found;
  row.right += figures.right;
  row.seconds.push_back(seconds.count());
}

}  // namespace

int main(int argc, char** argv) {
  std::string names_wanted;
  Output output;
  std::vector<std::string> ranges;
  std::printf(
      "| patterns | names | garments | wholly right | precision | recall | of all listed | ");
  std::printf("median seconds |\n|---|---|---|---|---|---|---|---|\n");
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument == "--features" && i + 1 < argc) {
        output.features = std::fopen(argv[++i], "w");
        continue;
      }
      if (argument == "--names" && i + 1 < argc) {
        names_wanted = argv[++i];
        continue;
      }
      if (argument == "--mistakes") {
        output.mistakes = true;
        continue;
      }
      std::vector<std::filesystem::path> files;
      if (std::filesystem::is_directory(argument)) {
        for (const auto& entry : std::filesystem::directory_iterator(argument)) {
          if (entry.path().extension() == ".json") files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
      } else {
        files.push_back(argument);
      }
      for (const bool names : {true, false}) {
        if (!names_wanted.empty() && names_wanted != (names ? "kept" : "gone")) continue;
        Row row;
        for (const auto& file : files) add(row, file, names, output);
        std::printf(
            "| %s | %s | %d | %.0f %% | %.3f | %.3f | %.3f, %.3f | %.1f |\n",
            std::filesystem::path(argument).filename().string().c_str(), names ? "kept" : "gone",
            row.garments, 100.0 * row.whole / std::max(1, row.garments),
            row.right / std::max(1.0, static_cast<double>(row.found)),
            row.right / std::max(1.0, static_cast<double>(row.stated)),
            row.listed_right / std::max(1.0, static_cast<double>(row.listed)),
            row.listed_right / std::max(1.0, static_cast<double>(row.stated)), median(row.seconds));
        std::string range = names ? "| kept |" : "| gone |";
        for (const auto& [seams, right] : row.bin) {
          char cell[64];
          std::snprintf(cell, sizeof cell, " %.3f of %d |", right / std::max(1.0, seams * 1.0),
                        seams);
          range += cell;
        }
        ranges.push_back(range);
        std::fflush(stdout);
      }
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::printf("\nShare of right seams, by confidence:\n\n| names |");
  for (const double start : bin_starts) std::printf(" from %.2f |", start);
  std::printf("\n|---|---|---|---|---|---|---|\n");
  for (const std::string& range : ranges) std::printf("%s\n", range.c_str());
  if (output.features != nullptr) std::fclose(output.features);
  return 0;
}
