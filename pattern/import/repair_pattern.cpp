#include "pattern/import/repair_pattern.h"

#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/error.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "io/text.h"
#include "pattern/file/edge_json.h"
#include "pattern/seams/sewn_file.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Metres: wider gaps of an outline are not closed, longer edges are no points.
constexpr double widest_gap = 5e-3;
constexpr double no_length = 1e-5;

class PatternRepair {
 public:
  PatternRepair(const std::string& text, const std::string& name, std::vector<Remark>& remarks)
      : file_(parse_json(text, name)), name_(name), remarks_(remarks) {
    const auto properties = file_.find("properties");
    if (properties != file_.end()) unit_ = 1 / properties->value("units_in_meter", 100.0);
  }

  /// Whether anything was repaired.
  bool run() {
    Json& pattern = file_.at("pattern");
    check_stitches(pattern);
    for (auto& [name, panel] : pattern.at("panels").items()) {
      place_ = name_ + ": panel " + in_quotes(name);
      close_gaps(panel);
      drop_points(name, panel);
    }
    if (pattern.contains("stitches")) repair_stitches(pattern["stitches"]);
    return repairs_ > 0;
  }

  const Json& file() const { return file_; }

 private:
  /// Throws Error for a stitch to an edge that its panel does not have. Repairs give edges other
  /// numbers, so this comes before them.
  void check_stitches(const Json& pattern) const {
    if (!pattern.contains("stitches")) return;
    const Json& panels = pattern.at("panels");
    const Json& stitches = pattern.at("stitches");
    for (std::size_t s = 0; s < stitches.size(); ++s) {
      const JsonValue stitch(stitches.at(s), name_ + ": stitch " + std::to_string(s));
      for (std::size_t i = 0; i < 2; ++i) {
        const auto panel = panels.find(stitches.at(s).at(i).at("panel").get<std::string>());
        if (panel == panels.end() || panel->at("edges").empty()) continue;
        read_sewn_edge(stitch, i, panel.key(), panel->at("edges").size());
      }
    }
  }

  void say(const std::string& what) {
    remarks_.push_back({true, what});
    ++repairs_;
  }

  double distance(const Json& panel, int a, int b) const {
    const auto at = [&](int vertex, int axis) {
      return panel.at("vertices").at(vertex).at(axis).get<double>();
    };
    return Vec2(at(a, 0) - at(b, 0), at(a, 1) - at(b, 1)).norm() * unit_;
  }

  static int vertex_of(const Json& number) {
    const double vertex = number.get<double>();
    if (!number.is_number_integer() || !(vertex >= 0 && vertex < std::numeric_limits<int>::max())) {
      throw std::out_of_range("vertex");
    }
    return number.get<int>();
  }

  static std::array<int, 2> ends(const Json& edge) {
    return {vertex_of(edge.at("endpoints").at(0)), vertex_of(edge.at("endpoints").at(1))};
  }

  static void merge(Json& panel, int kept, int gone) {
    for (Json& edge : panel.at("edges")) {
      for (Json& vertex : edge.at("endpoints")) {
        if (vertex == gone) vertex = kept;
      }
    }
    if (!panel.contains("notches")) return;
    for (Json& notch : panel["notches"]) {
      if (notch.at("vertex") == gone) notch["vertex"] = kept;
    }
  }

  void close_gaps(Json& panel) {
    std::map<int, std::vector<std::size_t>> edges_at;
    const Json& edges = panel.at("edges");
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (const int vertex : ends(edges[e])) edges_at[vertex].push_back(e);
    }
    std::vector<int> loose;
    for (const auto& [vertex, at] : edges_at) {
      if (at.size() == 1) loose.push_back(vertex);
    }
    while (loose.size() > 1) {
      const int vertex = loose.front();
      loose.erase(loose.begin());
      auto nearest = loose.end();
      double gap = widest_gap;
      for (auto other = loose.begin(); other != loose.end(); ++other) {
        const double apart = distance(panel, vertex, *other);
        if (apart > gap || edges_at[vertex] == edges_at[*other]) continue;
        gap = apart;
        nearest = other;
      }
      if (nearest == loose.end()) continue;
      say(place_ + ", edge " + std::to_string(edges_at[*nearest].front()) + ": a gap of " +
          number_text(gap * 1000, 2) + " mm to edge " + std::to_string(edges_at[vertex].front()) +
          " is closed");
      merge(panel, vertex, *nearest);
      loose.erase(nearest);
    }
  }

  void drop_points(const std::string& name, Json& panel) {
    Json& edges = panel.at("edges");
    // Attachments name edges by their numbers: such a panel is not renumbered.
    if (panel.contains("attach")) return;
    std::vector<int> number(edges.size());
    std::vector<std::size_t> points;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      number[e] = static_cast<int>(e - points.size());
      const auto [from, to] = ends(edges[e]);
      if (edges[e].contains("curvature")) continue;
      if (from != to && distance(panel, from, to) > no_length) continue;
      if (edges.size() - points.size() <= 3) continue;
      say(place_ + ", edge " + std::to_string(e) + ": has no length; it is left out");
      merge(panel, from, to);
      number[e] = -1;
      points.push_back(e);
    }
    if (points.empty()) return;
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(*point));
    }
    numbers_[name] = std::move(number);
  }

  /// The side's new number; -1: its edge was left out.
  int renumbered(const Json& side) const {
    const int edge = side.at("edge").get<int>();
    const auto panel = numbers_.find(side.at("panel").get<std::string>());
    if (panel == numbers_.end()) return edge;
    return panel->second.at(static_cast<std::size_t>(edge));
  }

  void repair_stitches(Json& stitches) {
    using Side = std::pair<std::string, int>;
    std::map<std::set<Side>, std::size_t> sewn;
    Json kept = Json::array();
    for (std::size_t s = 0; s < stitches.size(); ++s) {
      Json& stitch = stitches[s];
      const std::string place = name_ + ": stitch " + std::to_string(s);
      std::set<Side> sides;
      bool gone = false;
      for (int i = 0; i < 2; ++i) {
        Json& side = stitch.at(i);
        const int edge = renumbered(side);
        gone = gone || edge < 0;
        side["edge"] = edge;
        sides.emplace(side.at("panel").get<std::string>(), edge);
      }
      const auto known = sewn.emplace(sides, s);
      if (gone) {
        say(place + ": sews an edge without length; it is left out");
      } else if (!known.second) {
        say(place + ": sews the same edges as stitch " + std::to_string(known.first->second) +
            "; it is left out");
      } else {
        kept.push_back(std::move(stitch));
      }
    }
    stitches = std::move(kept);
  }

  Json file_;
  const std::string& name_;
  std::vector<Remark>& remarks_;
  double unit_ = 0.01;
  std::string place_;
  int repairs_ = 0;
  std::map<std::string, std::vector<int>> numbers_;  // new ones, per panel that lost edges
};

}  // namespace

std::string repaired_pattern(const std::string& text, const std::string& name,
                             std::vector<Remark>& remarks) {
  const std::size_t before = remarks.size();
  try {
    PatternRepair repair(text, name, remarks);
    if (!repair.run()) return text;
    return repair.file().dump(indent_of(text)) + "\n";
  } catch (const nlohmann::json::exception&) {
    // What has another form is for the reader to refuse, with the place.
  } catch (const std::out_of_range&) {
  }
  remarks.resize(before);
  return text;
}

}  // namespace toile
