// How many seams of patterns that have them find-seams finds again, as a table. By hand:
//
//   cmake --build build/release --target bench_seams_found
//   build/release/tests/bench_seams_found samples ../shared/data/patterns/garmentcode
//
// Each argument is a row: a folder of pattern files, or a file. `--part fit` takes the
// three fifths of a folder whose names have the lower SHA-256, `--part held` the others. Weights
// were fitted to the first and to the samples; the others were kept aside.
//
// Seams, translations, rotations, placements and labels are taken out of each pattern first. Names
// stay in one row and become piece1, piece2 and so on in the next. A seam is right where it joins
// the same two edges in the same direction. Panels that coincide count as one another where names
// are gone; with names, a panel that is its own mirror image may be turned over.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "geometry/error.h"
#include "io/checksum.h"
#include "io/output_file.h"
#include "pattern/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "tests/support/seam_figures.h"

namespace {

using namespace toile;

struct Row {
  int garments = 0;
  int whole = 0;
  int stated = 0;
  int found = 0;
  int right = 0;
  double seconds = 0;
};

void add(Row& row, const std::filesystem::path& file, bool names) {
  const std::string text = read_file(file);
  std::vector<Remark> remarks;
  const Pattern pattern = parse_drawn_pattern(text, file.string(), remarks);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, file.string());
  const auto start = std::chrono::steady_clock::now();
  const FoundSeams found = find_seams(stripped(pattern, names, false), options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::set<SeamPair> decided;
  for (const FoundSeam& seam : found.seams) {
    if (seam.confidence < decided_confidence) continue;
    decided.insert(seam_pair(seam.a, seam.b, seam.reversed));
  }
  SeamComparison comparison(pattern, options.drawn_walk, !names);
  const SeamFigures figures = comparison.compare(stated_seams(pattern), decided);
  ++row.garments;
  row.whole += figures.whole() ? 1 : 0;
  row.stated += figures.stated;
  row.found += figures.found;
  row.right += figures.right;
  row.seconds += seconds.count();
}

/// The files that weights were fitted to, or the others, by the checksums of their names.
std::vector<std::filesystem::path> part_of(std::vector<std::filesystem::path> files,
                                           const std::string& part) {
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return sha256(a.filename().string()) < sha256(b.filename().string());
  });
  const auto border = files.begin() + static_cast<std::ptrdiff_t>(files.size() * 3 / 5);
  if (part == "fit") files.erase(border, files.end());
  if (part == "held") files.erase(files.begin(), border);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  std::string part;
  std::printf(
      "| patterns | names | garments | wholly right | precision | recall | seconds each |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument == "--part" && i + 1 < argc) {
        part = argv[++i];
        continue;
      }
      std::vector<std::filesystem::path> files;
      if (std::filesystem::is_directory(argument)) {
        for (const auto& entry : std::filesystem::directory_iterator(argument)) {
          if (entry.path().extension() == ".json") files.push_back(entry.path());
        }
        files = part_of(std::move(files), part);
      } else {
        files.push_back(argument);
      }
      for (const bool names : {true, false}) {
        Row row;
        for (const auto& file : files) add(row, file, names);
        std::printf("| %s | %s | %d | %.0f %% | %.3f | %.3f | %.1f |\n",
                    std::filesystem::path(argument).filename().string().c_str(),
                    names ? "kept" : "gone", row.garments,
                    100.0 * row.whole / std::max(1, row.garments),
                    row.right / std::max(1.0, static_cast<double>(row.found)),
                    row.right / std::max(1.0, static_cast<double>(row.stated)),
                    row.seconds / std::max(1, row.garments));
        std::fflush(stdout);
      }
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
