#include "tools/edit_seams/proposals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/json_value.h"
#include "io/output_file.h"

namespace toile {

namespace {

/// Of the lengths of one edge, in the pattern and in the report. Mending moves edges a little.
constexpr double relative_tolerance = 0.02;
constexpr double tolerance = 0.5;  // centimetres

class Check {
 public:
  explicit Check(const Pattern& drawn) : drawn_(drawn) {}

  void seam(const JsonValue& seam) const {
    for (const std::string side : {"a", "b"}) {
      const double length = this->side(seam.get(side));
      const auto stated = seam.find("length_" + side + "_cm");
      if (!stated) continue;
      const double off = std::abs(stated->number() - length);
      if (off <= std::max(tolerance, relative_tolerance * length)) continue;
      char text[96];
      std::snprintf(text, sizeof text, "%.1f cm, which the pattern has %.1f cm long",
                    stated->number(), length);
      fail(seam.get(side), std::string("is an edge of ") + text);
    }
    seam.get("confidence").number();
    if (const auto reversed = seam.find("reversed")) reversed->flag();
    if (const auto other = seam.find("alternative")) {
      for (const char* side : {"a", "b"}) this->side(other->get(side));
    }
  }

 private:
  [[noreturn]] void fail(const JsonValue& where, const std::string& problem) const {
    where.fail(problem, "these are proposals for another pattern than " + drawn_.source +
                            "; give the one that find-seams wrote with them");
  }

  /// The length of the edge in centimetres.
  double side(const JsonValue& side) const {
    const std::string name = side.get("panel").text();
    const int edge = side.get("edge").index();
    const auto panel = std::ranges::find(drawn_.panels, name, &PatternPanel::name);
    if (panel == drawn_.panels.end()) {
      fail(side, "names panel '" + name + "', which the pattern lacks");
    }
    if (edge >= static_cast<int>(panel->edges.size())) {
      fail(side, "names edge " + std::to_string(edge) + " of panel '" + name + "', which has " +
                     std::to_string(panel->edges.size()));
    }
    return 100 * panel->edges[static_cast<std::size_t>(edge)].curve.length();
  }

  const Pattern& drawn_;
};

}  // namespace

std::string read_proposals(const std::filesystem::path& path, const Pattern& drawn) {
  std::string text = read_file(path);
  const JsonDocument document(text, path.string());
  const Check check(drawn);
  const JsonValue seams = document.root().get("seams");
  for (std::size_t i = 0; i < seams.size(); ++i) check.seam(seams.item(i));
  // A report without it holds what is certain only.
  if (const auto undecided = document.root().find("undecided")) {
    for (std::size_t i = 0; i < undecided->size(); ++i) check.seam(undecided->item(i));
  }
  return text;
}

}  // namespace toile
