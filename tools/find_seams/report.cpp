#include "tools/find_seams/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/remarks.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

Json side_json(const Pattern& pattern, const EdgeRef& side) {
  return {{"panel", pattern.panels[side.panel].name}, {"edge", side.edge}};
}

/// How the fullness of a seam is called.
std::string kind_of(const FoundSeam& seam) {
  const double fullness = std::max(seam.length_a, seam.length_b) /
                          std::max(1e-9, std::min(seam.length_a, seam.length_b));
  if (fullness < 1.002) return "plain";
  return fullness < 1.2 ? "eased" : "gathered";
}

Json seam_json(const Pattern& pattern, const FoundSeam& seam) {
  Json entry;
  entry["a"] = side_json(pattern, seam.a);
  entry["b"] = side_json(pattern, seam.b);
  entry["reversed"] = seam.reversed;
  entry["length_a_cm"] = 100 * seam.length_a;
  entry["length_b_cm"] = 100 * seam.length_b;
  entry["kind"] = kind_of(seam);
  entry["given"] = seam.given;
  entry["confidence"] = seam.confidence;
  entry["evidence"] = Json::object();
  for (int i = 0; i < seam_features && !seam.given; ++i) {
    entry["evidence"][name_of(static_cast<SeamFeature>(i))] = seam.features[i];
  }
  if (seam.alternative) {
    entry["alternative"] = {{"a", side_json(pattern, (*seam.alternative)[0])},
                            {"b", side_json(pattern, (*seam.alternative)[1])}};
  } else {
    entry["alternative"] = nullptr;
  }
  return entry;
}

}  // namespace

std::string side_name(const Pattern& pattern, const EdgeRef& side) {
  return pattern.panels[side.panel].name + ":" + std::to_string(side.edge);
}

std::vector<EdgeRef> open_edges(const Pattern& pattern, const FoundSeams& found) {
  std::set<std::array<int, 2>> used;
  for (const FoundSeam& seam : found.seams) {
    for (const EdgeRef& side : {seam.a, seam.b}) used.insert({side.panel, side.edge});
  }
  std::vector<EdgeRef> open;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    if (!pattern.panels[p].left_out.empty()) continue;
    for (int e = 0; e < static_cast<int>(pattern.panels[p].edges.size()); ++e) {
      if (!used.contains({p, e})) open.push_back({p, e});
    }
  }
  return open;
}

Json find_seams_json(const std::string& file, const SplitSeams& split,
                     const std::vector<LeftOut>& left_out, double min_confidence,
                     const std::vector<Remark>& remarks) {
  const Pattern& pattern = split.pattern;
  const FoundSeams& found = split.found;
  Json report;
  report["pattern"] = file;
  report["min_confidence"] = min_confidence;
  report["settled"] = found.settled;
  report["seams"] = Json::array();
  report["undecided"] = Json::array();
  for (const FoundSeam& seam : found.seams) {
    report[seam.confidence >= min_confidence ? "seams" : "undecided"].push_back(
        seam_json(pattern, seam));
  }
  report["splits"] = Json::array();
  for (const EdgeSplit& cut : split.splits) {
    Json entry = side_json(pattern, cut.edge);
    entry["share"] = cut.share;
    entry["rest"] = cut.rest;
    report["splits"].push_back(std::move(entry));
  }
  report["edges_open"] = Json::array();
  for (const EdgeRef& edge : open_edges(pattern, found)) {
    report["edges_open"].push_back(side_json(pattern, edge));
  }
  report["left_out"] = Json::array();
  for (const LeftOut& panel : left_out) {
    report["left_out"].push_back({{"panel", panel.name}, {"kind", panel.kind}});
  }
  add_remarks(remarks, report);
  return report;
}

}  // namespace toile
