#include "tools/find_seams/run.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/error.h"
#include "io/json_words.h"
#include "io/output_file.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/find_seams.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/shell_panels.h"
#include "pattern/seams/spare_panels.h"
#include "pattern/seams/split_search.h"
#include "tools/find_seams/report.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

/// Characters of the line that tells how far the search is.
constexpr int progress_width = 60;

/// One side of a seam as --sew names it.
struct NamedSide {
  std::string panel;
  int edge = 0;
};

/// "panel:edge", of the seam that is named `seam`.
NamedSide side_of(const std::string& text, const std::string& seam) {
  const std::size_t colon = text.rfind(':');
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (number.empty() || number.size() > 6 ||
      number.find_first_not_of("0123456789") != std::string::npos) {
    throw Error("--sew " + in_quotes(seam), "names no panel and edge",
                "write it as \"front:3 back:1\"");
  }
  return {text.substr(0, colon), std::stoi(number)};
}

/// The two sides end with a number each, so names may hold spaces.
std::array<NamedSide, 2> sides_of(const std::string& seam) {
  for (std::size_t at = seam.find(' '); at != std::string::npos; at = seam.find(' ', at + 1)) {
    const std::size_t colon = seam.rfind(':', at);
    if (colon == std::string::npos || colon + 1 == at) continue;
    if (seam.find_first_not_of("0123456789", colon + 1) != at) continue;
    return {side_of(seam.substr(0, at), seam), side_of(seam.substr(at + 1), seam)};
  }
  throw Error("--sew " + in_quotes(seam), "names no two edges", "write it as \"front:3 back:1\"");
}

int panel_of(const Pattern& pattern, const std::string& option, const std::string& name) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (pattern.panels[p].name == name) return static_cast<int>(p);
  }
  throw Error(option + " " + in_quotes(name), "names no panel of the pattern", "correct the name");
}

int panel_of(const Pattern& pattern, const NamedSide& side, const std::string& seam) {
  const auto found = std::ranges::find(pattern.panels, side.panel, &PatternPanel::name);
  if (found != pattern.panels.end()) return static_cast<int>(found - pattern.panels.begin());
  throw Error("--sew " + in_quotes(seam),
              "names panel " + in_quotes(side.panel) + ", which the pattern does not have",
              "correct the name");
}

EdgeRef edge_of(const Pattern& pattern, const NamedSide& side, const std::string& seam) {
  const EdgeRef ref{panel_of(pattern, side, seam), side.edge};
  const std::size_t edges = pattern.panels[ref.panel].edges.size();
  if (static_cast<std::size_t>(ref.edge) < edges) return ref;
  throw Error("--sew " + in_quotes(seam),
              "names edge " + std::to_string(side.edge) + " of panel " + in_quotes(side.panel) +
                  ", which has edges 0 to " + std::to_string(edges - 1),
              "edges count from 0");
}

Stitch stitch_of(const Pattern& pattern, const std::string& seam) {
  const auto [a, b] = sides_of(seam);
  Stitch stitch;
  stitch.a = edge_of(pattern, a, seam);
  stitch.b = edge_of(pattern, b, seam);
  if (stitch.a.panel == stitch.b.panel && stitch.a.edge == stitch.b.edge) {
    throw Error("--sew " + in_quotes(seam), "sews an edge to itself", "name two edges");
  }
  return stitch;
}

bool is_same(const EdgeRef& a, const EdgeRef& b) { return a.panel == b.panel && a.edge == b.edge; }

/// Whether a stitch is one of the seams that were found, and its edge a part of a drawn one.
bool is_listed_part(const SplitSeams& split, const Stitch& stitch) {
  const bool is_listed = std::ranges::any_of(split.found.seams, [&](const FoundSeam& seam) {
    return (is_same(seam.a, stitch.a) && is_same(seam.b, stitch.b)) ||
           (is_same(seam.a, stitch.b) && is_same(seam.b, stitch.a));
  });
  return is_listed && std::ranges::any_of(split.splits, [&](const EdgeSplit& cut) {
           const EdgeRef rest{cut.edge.panel, cut.rest};
           return is_same(cut.edge, stitch.a) || is_same(cut.edge, stitch.b) ||
                  is_same(rest, stitch.a) || is_same(rest, stitch.b);
         });
}

/// As find_split_seams(), with the seams of --sew. A listed seam may name a part of an edge, that
/// only the search before has cut: then this one begins with its cuts. Else edges are the drawn
/// ones.
SplitSeams find_with(const std::vector<std::string>& sewn, const std::string& text,
                     const std::string& name, const Pattern& drawn, FindSeamsOptions options) {
  if (sewn.empty()) return find_split_seams(text, name, drawn, options);
  SplitSeams before = find_split_seams(text, name, drawn, options);
  bool names_part = false;
  for (const std::string& seam : sewn) {
    const Stitch stitch = stitch_of(before.pattern, seam);
    const auto is_new = [&](const EdgeRef& side) {
      return static_cast<std::size_t>(side.edge) >= drawn.panels[side.panel].edges.size();
    };
    names_part =
        names_part || is_new(stitch.a) || is_new(stitch.b) || is_listed_part(before, stitch);
  }
  const Pattern& pattern = names_part ? before.pattern : drawn;
  options.given.reserve(options.given.size() + sewn.size());
  for (const std::string& seam : sewn) options.given.push_back(stitch_of(pattern, seam));
  SplitSeams found = find_split_seams(names_part ? before.text : text, name, pattern, options);
  if (names_part) {
    found.splits.insert(found.splits.begin(), before.splits.begin(), before.splits.end());
  }
  return found;
}

/// The panels that are left out, by name. Panels of seams that are given stay.
std::vector<LeftOut> left_out(const Pattern& pattern, const FindSeamsSettings& settings) {
  std::set<int> held;
  if (settings.keep) {
    for (const Stitch& stitch : pattern.stitches) {
      const auto is_marked = [&](int panel) { return !pattern.panels[panel].left_out.empty(); };
      if (is_marked(stitch.a.panel) || is_marked(stitch.b.panel)) continue;
      held.insert({stitch.a.panel, stitch.b.panel});
    }
  }
  for (const std::string& seam : settings.sewn) {
    for (const NamedSide& side : sides_of(seam)) {
      held.insert(panel_of(pattern, side, seam));
    }
  }
  std::set<int> taken = held;
  bool all = false;
  for (const std::string& name : settings.with) {
    all = all || name == "all";
    if (name != "all") taken.insert(panel_of(pattern, "--with", name));
  }
  std::map<int, std::string> out;
  for (const auto& [panel, kind] : panels_beside_shell(pattern)) {
    if (!all && !taken.contains(panel)) out[panel] = kind;
  }
  for (const std::string& name : settings.without) {
    const int panel = panel_of(pattern, "--without", name);
    if (taken.contains(panel)) {
      throw Error("--without " + in_quotes(name),
                  "names a panel that --with, --sew or --keep needs", "remove one of the two");
    }
    out[panel] = "asked for";
  }
  if (out.size() == pattern.panels.size()) {
    throw Error(pattern.source, "keeps no panel", "take panels in by --with");
  }
  std::vector<LeftOut> named;
  named.reserve(out.size());
  for (const auto& [panel, kind] : out) named.push_back({pattern.panels[panel].name, kind});
  return named;
}

/// Marks the panels whose place another one has, and drops what was found of them.
std::vector<LeftOut> leave_out_spare(const FindSeamsSettings& settings,
                                     const FindSeamsOptions& options, SplitSeams& split) {
  std::vector<LeftOut> out;
  for (const int spare : spare_panels(split.pattern, options, split.found)) {
    PatternPanel& panel = split.pattern.panels[spare];
    const auto is_kept = [&](const std::string& with) {
      return with == "all" || with == panel.name;
    };
    if (std::ranges::any_of(settings.with, is_kept)) continue;
    panel.left_out = "another panel has its place";
    out.push_back({panel.name, panel.left_out});
    std::erase_if(split.found.seams, [&](const FoundSeam& seam) {
      return seam.a.panel == spare || seam.b.panel == spare;
    });
  }
  return out;
}

/// Says which panels would fall off: no seam holds them that is sewn.
void warn_of_loose(const Pattern& pattern, const std::vector<FoundSeam>& sewn,
                   std::vector<Remark>& remarks) {
  std::set<int> held;
  for (const FoundSeam& seam : sewn) held.insert({seam.a.panel, seam.b.panel});
  if (pattern.panels.size() < 2) return;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (held.contains(static_cast<int>(p)) || !pattern.panels[p].left_out.empty()) continue;
    const std::string& name = pattern.panels[p].name;
    remarks.push_back({true, pattern.source + ": no seam holds panel " + in_quotes(name) +
                                 "; sew it by --sew, or leave it out by --without"});
  }
}

}  // namespace

SewnPattern sew_pattern(std::string drawn_text, const std::string& name,
                        const FindSeamsSettings& settings, const CommonSettings& common) {
  SewnPattern sewn;
  std::vector<Remark>& remarks = sewn.remarks;
  Pattern drawn = parse_drawn_pattern(drawn_text, name, remarks);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(drawn_text, name);
  const std::size_t stated = drawn.stitches.size();
  std::vector<LeftOut> out = left_out(drawn, settings);
  std::map<std::string, std::string> kinds;
  for (const LeftOut& panel : out) kinds[panel.name] = panel.kind;
  drawn_text = with_left_out(drawn_text, name, kinds);
  remarks.clear();
  std::vector<Remark> told_below;
  drawn = without_left_out(parse_drawn_pattern(drawn_text, name, remarks), told_below);
  options.by_place = settings.by_place;
  if (settings.keep) options.given = drawn.stitches;
  if (!settings.keep && stated > 0) {
    remarks.push_back({false, name + ": its " + std::to_string(stated) +
                                  " stitches are replaced; --keep keeps them"});
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  if (settings.time_limit > 0) {
    options.is_over = [begin, limit = settings.time_limit] {
      return std::chrono::duration<double>(Clock::now() - begin).count() > limit;
    };
  }
  const bool shows_progress = !common.quiet && isatty(STDERR_FILENO) != 0;
  if (shows_progress) {
    options.heard = [](std::size_t seams, std::size_t cuts) {
      std::fprintf(stderr, "\r%zu seams, %zu edges cut, searching on ...", seams, cuts);
    };
  }
  sewn.found = find_with(settings.sewn, drawn_text, name, drawn, options);
  if (settings.sewn.empty() && options.given.empty()) {
    for (const LeftOut& panel : leave_out_spare(settings, options, sewn.found)) {
      kinds[panel.name] = panel.kind;
      out.push_back(panel);
    }
    sewn.found.text = with_left_out(sewn.found.text, name, kinds);
  }
  const SplitSeams& split = sewn.found;
  const Pattern& pattern = split.pattern;
  const FoundSeams& found = split.found;
  if (shows_progress) std::fprintf(stderr, "\r%*s\r", progress_width, "");
  const bool is_early = options.is_over && options.is_over();
  if (is_early) {
    remarks.push_back({true, name + ": the time limit ended the search; seams are the best found "
                                    "so far, and less certain"});
  }
  if (!found.settled && !is_early) {
    remarks.push_back(
        {true, name + ": searches for seams disagree about the best garment; look at all "
                      "of them, or sew some by --sew and keep what is right"});
  }
  std::vector<FoundSeam> decided;
  for (const FoundSeam& seam : found.seams) {
    if (seam.confidence >= settings.min_confidence) {
      decided.push_back(seam);
    } else {
      sewn.end.undecided.push_back(
          {side_name(pattern, seam.a) + " " + side_name(pattern, seam.b), seam.confidence});
    }
  }
  warn_of_loose(pattern, decided, remarks);
  sewn.text = with_stitches(split.text, pattern, decided, options.drawn_walk);
  warn_of_outlines(parse_pattern(sewn.text, name, told_below), remarks);
  sewn.end.left_out = out;
  return sewn;
}

FindSeamsEnd run_find_seams(const FindSeamsSettings& settings, const CommonSettings& common) {
  const std::string name = settings.pattern.string();
  const auto [text, split, remarks, end] =
      sew_pattern(read_file(settings.pattern), name, settings, common);
  const Pattern& pattern = split.pattern;
  const FoundSeams& found = split.found;
  say_remarks(remarks, common);
  for (const FoundSeam& seam : found.seams) {
    const bool sure = seam.confidence >= settings.min_confidence;
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
  common.say(std::to_string(found.seams.size() - end.undecided.size()) + " seams sewn, " +
             std::to_string(end.undecided.size()) + " undecided");
  std::string beside;
  for (const LeftOut& panel : end.left_out) {
    beside += (beside.empty() ? " " : ", ") + panel.name + " (" + panel.kind + ")";
  }
  if (!beside.empty()) common.say("left out:" + beside + "; --with takes a panel in");
  std::string open;
  for (const EdgeRef& edge : open_edges(pattern, found))
    open.append(" ").append(side_name(pattern, edge));
  if (!open.empty()) common.say("left open:" + open);
  OutputFiles files;
  write_file(files.at(common.output), text);
  write_report(files, common,
               find_seams_json(name, split, end.left_out, settings.min_confidence, remarks));
  files.commit();
  return end;
}

}  // namespace toile
