#include "tools/find_seams/run.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/json_words.h"
#include "io/output_file.h"
#include "pattern/pattern_file.h"
#include "pattern/seams/find_seams.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/split_search.h"
#include "tools/find_seams/report.h"
#include "tools/remarks.h"

namespace toile {

namespace {

/// One side of a seam as "panel:edge".
EdgeRef side_of(const Pattern& pattern, const std::string& text, const std::string& seam) {
  const std::string place = "--sew " + in_quotes(seam);
  const std::size_t colon = text.rfind(':');
  const std::string name = text.substr(0, colon);
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (number.empty() || number.size() > 6 ||
      number.find_first_not_of("0123456789") != std::string::npos) {
    throw Error(place, "names no panel and edge", "write it as \"front:3 back:1\"");
  }
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (pattern.panels[p].name != name) continue;
    const EdgeRef ref{static_cast<int>(p), std::stoi(number)};
    const std::size_t edges = pattern.panels[p].edges.size();
    if (static_cast<std::size_t>(ref.edge) < edges) return ref;
    throw Error(place,
                "names edge " + number + " of panel " + in_quotes(name) +
                    ", which has edges 0 to " + std::to_string(edges - 1),
                "edges count from 0");
  }
  throw Error(place, "names panel " + in_quotes(name) + ", which the pattern does not have",
              "correct the name");
}

/// The two sides end with a number each, so names may hold spaces.
Stitch stitch_of(const Pattern& pattern, const std::string& text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const std::size_t colon = text.rfind(':', at);
    if (colon == std::string::npos || colon + 1 == at) continue;
    if (text.find_first_not_of("0123456789", colon + 1) != at) continue;
    Stitch stitch;
    stitch.a = side_of(pattern, text.substr(0, at), text);
    stitch.b = side_of(pattern, text.substr(at + 1), text);
    if (stitch.a.panel == stitch.b.panel && stitch.a.edge == stitch.b.edge) {
      throw Error("--sew " + in_quotes(text), "sews an edge to itself", "name two edges");
    }
    return stitch;
  }
  throw Error("--sew " + in_quotes(text), "names no two edges", "write it as \"front:3 back:1\"");
}

}  // namespace

int run_find_seams(const FindSeamsSettings& settings, const CommonSettings& common) {
  const auto start = std::chrono::steady_clock::now();
  const std::string drawn_text = read_file(settings.pattern);
  const std::string name = settings.pattern.string();
  std::vector<Remark> remarks;
  const Pattern drawn = parse_drawn_pattern(drawn_text, name, remarks);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(drawn_text, name);
  options.by_place = settings.by_place;
  if (settings.keep) options.given = drawn.stitches;
  for (const std::string& seam : settings.sewn) {
    options.given.push_back(stitch_of(drawn, seam));
  }
  if (!settings.keep && !drawn.stitches.empty()) {
    remarks.push_back({false, name + ": its " + std::to_string(drawn.stitches.size()) +
                                  " stitches are replaced; --keep keeps them"});
  }
  const SplitSeams split = find_split_seams(drawn_text, name, drawn, options);
  const Pattern& pattern = split.pattern;
  const FoundSeams& found = split.found;
  if (!found.settled) {
    remarks.push_back(
        {true, name + ": searches for seams disagree about the best garment; look at all "
                      "of them, or sew some by --sew and keep what is right"});
  }
  say_remarks(remarks, common);
  std::vector<FoundSeam> decided;
  int undecided = 0;
  for (const FoundSeam& seam : found.seams) {
    const bool sure = seam.confidence >= settings.min_confidence;
    if (sure) decided.push_back(seam);
    if (!sure) ++undecided;
    char line[512];
    std::snprintf(line, sizeof line, "  %-10s %4.2f  %-32s %-32s %6.2f cm to %6.2f cm",
                  seam.given ? "given"
                  : sure     ? "sewn"
                             : "undecided",
                  seam.confidence, side_name(pattern, seam.a).c_str(),
                  side_name(pattern, seam.b).c_str(), seam.length_a * 100, seam.length_b * 100);
    common.say(line);
  }
  for (const EdgeSplit& cut : split.splits) {
    common.say("  split      " + side_name(pattern, cut.edge) + ", its rest is " +
               side_name(pattern, {cut.edge.panel, cut.rest}));
  }
  common.say(std::to_string(decided.size()) + " seams sewn, " + std::to_string(undecided) +
             " undecided");
  std::string open;
  for (const EdgeRef& edge : open_edges(pattern, found))
    open.append(" ").append(side_name(pattern, edge));
  if (!open.empty()) common.say("left open:" + open);
  OutputFiles files;
  write_file(files.at(common.output),
             with_stitches(split.text, pattern, decided, options.drawn_walk));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (common.report) {
    write_file(
        files.at(*common.report),
        find_seams_json(name, split, settings.min_confidence, remarks, seconds.count()).dump(2) +
            "\n");
  }
  files.commit();
  return undecided == 0 ? exit_done : exit_negative;
}

}  // namespace toile
