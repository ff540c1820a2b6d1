#include "tools/compare/comparison.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "cloth/judge/verdict.h"
#include "io/text.h"

namespace toile {

const char* const best_size_rule =
    "A size counts if it ended well (sewn, on a body that can be relied on, within its spec) and "
    "is not too small. Of these, with a target, the best is the one whose farthest level is "
    "nearest to its target. Without a target it is the smallest that surely goes around: the one "
    "with the least worst ease among those whose worst ease is at least its error.";

namespace {

/// Small sizes first: numbers by their value, S, M and L by their X. None: a word that is no size.
std::optional<double> rank_of(const std::string& size) {
  std::size_t used = 0;
  while (used < size.size() && size[used] >= '0' && size[used] <= '9') ++used;
  const double number = used > 0 ? std::stod(size.substr(0, used)) : 0;
  std::string letters = size.substr(used);
  for (char& c : letters) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (!letters.empty() && letters.find_first_not_of('X') == letters.size() - 1) {
    // 2XL is XXL.
    const double times = used > 0 ? number : static_cast<double>(std::ranges::count(letters, 'X'));
    if (letters.back() == 'S') return -1 - times;
    if (letters == "M") return 0;
    if (letters.back() == 'L') return 1 + times;
  }
  return used > 0 ? std::optional(number) : std::nullopt;
}

bool comes_before(const std::string& a, const std::string& b) {
  const auto last = std::numeric_limits<double>::max();
  return rank_of(a).value_or(last) < rank_of(b).value_or(last);
}

/// The run whose farthest level is nearest to its target.
void find_best_by_target(const std::vector<ComparedRun>& runs, const std::vector<std::size_t>& may,
                         ComparedRow& row) {
  for (const std::size_t i : may) {
    const auto off = [&](std::size_t run) { return std::abs(runs[run].farthest_off()->off()); };
    if (!row.best || off(i) < off(*row.best)) row.best = i;
  }
  const TargetFinding& farthest = *runs[*row.best].farthest_off();
  row.why = farthest.off() == 0 ? "within '" + runs[*row.best].target + "' at all levels"
                                : text_of(farthest);
}

/// The smallest that surely goes around.
void find_best_by_ease(const std::vector<ComparedRun>& runs, const std::vector<std::size_t>& may,
                       ComparedRow& row) {
  bool any_measured = false;
  for (const std::size_t i : may) {
    const LevelEase* tightest = runs[i].tightest();
    if (tightest == nullptr) continue;
    any_measured = true;
    if (tightest->ease < tightest->error) continue;
    if (!row.best || tightest->ease < runs[*row.best].tightest()->ease) row.best = i;
  }
  if (row.best) {
    row.why = "worst ease " + text_of(*runs[*row.best].tightest());
  } else {
    row.why = any_measured ? "no size surely goes around: the worst ease is less than its error"
                           : "no ease was measured";
  }
}

void add_to_row(std::size_t i, Comparison& all) {
  const ComparedRun& run = all.runs[i];
  auto row = std::ranges::find_if(all.rows, [&](const ComparedRow& other) {
    return other.garment == run.garment && other.body == run.body &&
           (run.fabric.empty() || other.fabric == run.fabric);
  });
  if (row == all.rows.end()) {
    all.rows.push_back({run.garment, run.body, run.fabric, {}, {}, ""});
    row = all.rows.end() - 1;
  }
  row->runs.push_back(i);
}

void find_best(const std::vector<ComparedRun>& runs, ComparedRow& row) {
  std::vector<std::size_t> may;
  for (const std::size_t i : row.runs) {
    if (may_be_best(runs[i])) may.push_back(i);
  }
  if (may.empty()) {
    row.why = "no size ended well and is large enough";
    return;
  }
  const auto has_same_target = [&](std::size_t i) {
    return !runs[i].targets.empty() && runs[i].target == runs[may.front()].target;
  };
  if (std::ranges::all_of(may, has_same_target)) {
    find_best_by_target(runs, may, row);
  } else {
    find_best_by_ease(runs, may, row);
  }
}

}  // namespace

bool may_be_best(const ComparedRun& run) {
  return run.verdict == to_string(Verdict::sewn) && run.why.empty() && run.fit != "too_small";
}

Comparison compare_runs(std::vector<ComparedRun> runs) {
  Comparison all;
  all.runs = std::move(runs);
  for (const ComparedRun& run : all.runs) {
    if (std::ranges::find(all.sizes, run.size) == all.sizes.end()) all.sizes.push_back(run.size);
  }
  std::ranges::stable_sort(all.sizes, comes_before);
  // Runs that ended early may not tell their fabric: they stand in a row that has one.
  for (const bool tells_fabric : {true, false}) {
    for (std::size_t i = 0; i < all.runs.size(); ++i) {
      if (all.runs[i].fabric.empty() != tells_fabric) add_to_row(i, all);
    }
  }
  for (ComparedRow& row : all.rows) {
    std::ranges::stable_sort(row.runs, [&](std::size_t a, std::size_t b) {
      return comes_before(all.runs[a].size, all.runs[b].size);
    });
    find_best(all.runs, row);
  }
  return all;
}

std::string text_of(const LevelEase& level) {
  return fixed_number(100 * level.ease, 1) + " \xC2\xB1 " + centimetres(level.error, 1) +
         " at the " + level.level;
}

}  // namespace toile
