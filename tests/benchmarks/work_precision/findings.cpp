#include "tests/benchmarks/work_precision/findings.h"

#include <algorithm>
#include <set>

#include "cloth/dressing/quality.h"
#include "io/text.h"

namespace toile::precision {

namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// On one scene: how many times as long, and from which distance on never. Empty: nowhere.
std::string slower_on(const Results& results, const MeshedScene& scene, const std::string& loser,
                      const std::string& winner) {
  double least = 0, most = 0;
  std::optional<double> never;
  for (const double distance : asked_distances) {
    const auto mine = seconds_within(results.rows, scene, loser, distance);
    const auto other = seconds_within(results.rows, scene, winner, distance);
    if (!other || (mine && *mine <= *other)) continue;
    if (!mine) {
      never = never.value_or(distance);
      continue;
    }
    const double times = *mine / *other;
    least = most > 0 ? std::min(least, times) : times;
    most = std::max(most, times);
  }
  std::string text;
  if (most > 0)
    text = number(least, 2) + (least < most ? " to " + number(most, 2) : "") + " times as long";
  if (never) text += (text.empty() ? "" : ", ") + ("never within " + mm(*never, 1) + " mm");
  return text.empty() ? "" : scene.name + " (" + text + ")";
}

/// Where `loser` needs longer than `winner` for the same distance, or never comes as near.
std::string slower(const Results& results, const std::string& loser, const std::string& winner) {
  std::vector<std::string> places;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    // What was not run has not lost.
    if (rows_of(results.rows, scene, loser).empty()) continue;
    const std::string place = slower_on(results, scene, loser, winner);
    if (!place.empty()) places.push_back(place);
  }
  const std::string start = "To come as near to its own rest, in processor time, the " + loser;
  if (places.empty()) return start + " method is behind the " + winner + " on no scene here.";
  return start + " method is behind the " + winner + " on: " + join(places) + ".";
}

/// Whether its runs end within a millimetre of its rest at all.
std::string never_near(const Results& results, const std::string& method) {
  constexpr double near = 0.001;
  std::vector<std::string> places;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    const auto rows = rows_of(results.rows, scene, method);
    if (rows.empty() || seconds_within(results.rows, scene, method, near)) continue;
    const Row* best = *std::min_element(rows.begin(), rows.end(), [](const Row* a, const Row* b) {
      return a->error.rms < b->error.rms;
    });
    places.push_back(scene.name + " (" + mm(best->error.rms) + " mm at best, after " +
                     number(best->outcome.processor, 3) + " s)");
  }
  if (places.empty()) return "";
  return "No setting of the " + method +
         " method ends within 1 mm of its own rest: " + join(places) + ".";
}

/// What the paper's three passes a step leave of the strain limit, which its references hold.
std::string passes(const Results& results) {
  std::vector<std::string> places;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    const Row* usual = find_row(results.rows, scene, "paper", "default", "");
    const Row* exact = find_row(results.rows, scene, "paper", "exact limit", "");
    if (usual == nullptr || exact == nullptr) continue;
    places.push_back(scene.name + " " + mm(usual->error.rms) + " mm, and " + mm(exact->error.rms) +
                     " mm with the limit held");
  }
  if (places.empty()) return "";
  return "The paper's method holds its strain limit by three passes a step, its references hold "
         "it exactly. Stopped at the same residual, it is from rest: " +
         join(places) + ".";
}

std::string no_rest(const Results& results) {
  std::vector<std::string> places;
  for (const Row& row : results.rows) {
    if (row.knob != "reference" || row.outcome.converged) continue;
    places.push_back(row.scene + ", " + number(row.edge_mm) + " mm, " + row.method + " (" +
                     end_of(row.outcome) + ", residual " + number(row.outcome.residual.median, 2) +
                     ")");
  }
  if (places.empty()) return "";
  return "References that did not come to the rest asked for, so that errors against them are "
         "themselves uncertain: " +
         join(places) + ".";
}

/// The relaxation's own weak side: a rms that hides single nodes.
std::string single_nodes(const Results& results) {
  const Row* worst = nullptr;
  for (const Row& row : results.rows) {
    if (row.knob != "quality" || row.value != standard_quality.name) continue;
    if (worst == nullptr || row.error.max > worst->error.max) worst = &row;
  }
  if (worst == nullptr) return "";
  return "The relaxation's standard preset leaves single nodes farther off than its rms says: " +
         mm(worst->error.max, 1) + " mm against " + mm(worst->error.rms) + " mm rms on the " +
         worst->scene + " at " + number(worst->edge_mm) + " mm edges.";
}

/// Presets that are farther from rest than the next coarser one, and those that sheets get.
std::string out_of_order(const Results& results) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i + 1 < results.rows.size(); ++i) {
    const Row& a = results.rows[i];
    const Row& b = results.rows[i + 1];
    const bool pair = a.knob == "quality" && b.knob == "quality" && a.scene == b.scene;
    if (!pair || b.error.rms <= a.error.rms) continue;
    places.push_back(a.scene + " at " + number(a.edge_mm) + " mm: " + b.value + " " +
                     mm(b.error.rms) + " mm, " + a.value + " " + mm(a.error.rms) + " mm");
  }
  if (places.empty()) return "";
  return "The relaxation's residual bounds forces, not distances. A finer preset ended farther "
         "from rest than a coarser one: " +
         join(places) + ".";
}

std::string models(const Results& results) {
  std::vector<std::string> places;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    const Row* row = find_row(results.rows, scene, "relaxation", "reference", "");
    if (row == nullptr || !row->models_apart) continue;
    places.push_back(scene.name + " " + mm(*row->models_apart, 1) + " mm");
  }
  if (places.empty()) return "";
  return "Both at rest on the same mesh, the two models are apart by (rms): " + join(places) +
         ". No time spent on either makes that less: springs are no continuum, and what friction "
         "holds depends on the way there.";
}

}  // namespace

std::vector<MeshedScene> meshed_scenes(const std::vector<Row>& rows) {
  std::vector<MeshedScene> all;
  std::vector<std::size_t> counts;
  for (const Row& row : rows) {
    const MeshedScene at{row.scene, row.edge_mm};
    const auto count =
        static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const Row& other) {
          return other.scene == at.name && other.edge_mm == at.edge_mm;
        }));
    if (all.empty() || all.back().name != at.name) {
      all.push_back(at);
      counts.push_back(count);
    } else if (count > counts.back()) {
      all.back() = at;
      counts.back() = count;
    }
  }
  return all;
}

std::vector<const Row*> rows_of(const std::vector<Row>& rows, const MeshedScene& scene,
                                const std::string& method) {
  std::vector<const Row*> found;
  for (const Row& row : rows) {
    if (row.scene != scene.name || row.edge_mm != scene.edge_mm) continue;
    if (row.knob == "reference" || (!method.empty() && row.method != method)) continue;
    found.push_back(&row);
  }
  return found;
}

const Row* find_row(const std::vector<Row>& rows, const MeshedScene& scene,
                    const std::string& method, const std::string& knob, const std::string& value) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.scene == scene.name && row.edge_mm == scene.edge_mm && row.method == method &&
           row.knob == knob && row.value == value;
  });
  return found == rows.end() ? nullptr : &*found;
}

std::optional<double> seconds_within(const std::vector<Row>& rows, const MeshedScene& scene,
                                     const std::string& method, double distance) {
  std::optional<double> least;
  for (const Row* row : rows_of(rows, scene, method)) {
    // What is not sewn ends near to what is not sewn either: that is no rest.
    if (!row->outcome.sewn || row->error.rms > distance) continue;
    least = std::min(least.value_or(row->outcome.processor), row->outcome.processor);
  }
  return least;
}

std::vector<std::string> losses(const Results& results) {
  std::vector<std::string> all = {slower(results, "relaxation", "paper"),
                                  slower(results, "paper", "relaxation"),
                                  never_near(results, "relaxation"),
                                  never_near(results, "paper"),
                                  passes(results),
                                  single_nodes(results),
                                  out_of_order(results),
                                  models(results),
                                  no_rest(results)};
  std::erase(all, "");
  return all;
}

std::vector<Preset> presets(const Results& results) {
  std::vector<Preset> all;
  std::set<std::string> seen;
  for (const Row& row : results.rows) {
    if (row.edge_mm != results.presets_mm || !row.error.ease) continue;
    if (!seen.insert(row.scene).second) continue;
    const MeshedScene at{row.scene, row.edge_mm};
    const Row* standard =
        find_row(results.rows, at, "relaxation", "quality", standard_quality.name);
    for (const Quality& quality : qualities) {
      const Row* preset = find_row(results.rows, at, "relaxation", "quality", quality.name);
      if (preset == nullptr || standard == nullptr) continue;
      all.push_back({preset, preset->outcome.processor / standard->outcome.processor});
    }
  }
  return all;
}

std::string mm(double metres, int digits) { return fixed_number(1000 * metres, digits); }

}  // namespace toile::precision
