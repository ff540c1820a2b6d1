#include "pattern/measure/measuring_rule.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "geometry/error.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr const char* rules =
    "write along EDGE..., between, drop or level POINT POINT, down POINT or around POINT, where an "
    "edge is panel.0 and a point panel.0:start";

/// Reads one rule, word by word.
class RuleReader {
 public:
  RuleReader(const SewnPanels& panels, const std::string& rule)
      : panels_(panels), rule_(rule), words_(rule) {}

  double value() {
    std::string verb = word();
    const double share = verb == "half" ? 0.5 : verb == "twice" ? 2 : 1;
    if (share != 1) verb = word();
    const double value = share * value_of(verb);
    if (!at_end()) fail("'" + shown_text(word()) + "' is too much");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& remedy = rules) const {
    throw Error("rule '" + shown_text(rule_) + "'", what, remedy);
  }

  bool at_end() { return (words_ >> std::ws).eof(); }

  std::string word() {
    if (at_end()) fail("ends too early");
    std::string text;
    words_ >> text;
    return text;
  }

  double value_of(const std::string& verb) {
    if (verb == "along") {
      double sum = 0;
      do {
        sum += panels_.length(edge());
      } while (!at_end());
      return sum;
    }
    if (verb == "between" || verb == "drop" || verb == "level") {
      const EdgePoint a = point();
      const EdgePoint b = point();
      if (a.edge.panel != b.edge.panel) {
        fail("its points are of two panels", "name two points of one panel");
      }
      const Vec2 way = panels_.at(a) - panels_.at(b);
      const double drop = way.dot(panels_.up(a.edge.panel));
      if (verb == "drop") return drop;
      return verb == "between" ? way.norm() : (way - drop * panels_.up(a.edge.panel)).norm();
    }
    if (verb == "down") return panels_.length_down(point());
    if (verb == "around") {
      const EdgePoint from = point();
      return panels_.level_line(at_end() ? from : below(from)).length;
    }
    fail("'" + shown_text(verb) + "' is no way to measure");
  }

  /// What "2.5cm below" makes of a point.
  EdgePoint below(const EdgePoint& from) {
    const std::string drop = word();
    const std::optional<double> centimetres =
        drop.ends_with("cm") ? parse_number(drop.substr(0, drop.size() - 2)) : std::nullopt;
    if (!centimetres || !(*centimetres >= 0) || !(*centimetres < 1000) || word() != "below") {
      fail("'" + shown_text(drop) + "' is no way down", "write 2.5cm below, say");
    }
    if (from.fraction != 0 && from.fraction != 1) {
      fail("its point is not the end of an edge", "write panel.0:start or panel.0:end");
    }
    return panels_.below({from.edge, from.fraction == 1}, *centimetres / 100);
  }

  EdgePoint point() {
    EdgePoint point{edge(), 0};
    std::string place;
    if (words_.peek() == ':') {
      words_.get();
      place = word();
    }
    if (place == "end") {
      point.fraction = 1;
    } else if (place != "start") {
      const std::optional<double> fraction = parse_number(place);
      if (!fraction || !(*fraction >= 0 && *fraction <= 1)) {
        fail("'" + shown_text(place) + "' is no place on an edge",
             "write :start, :end or a number from 0 to 1 behind the edge");
      }
      point.fraction = *fraction;
    }
    return point;
  }

  EdgeRef edge() {
    if (at_end()) fail("ends too early");
    std::string panel;
    std::string number;
    if (words_.peek() == '"') {
      words_ >> std::quoted(panel);
      if (words_.get() != '.') fail("'" + shown_text(panel) + "' has no edge behind it");
      while (std::isdigit(words_.peek()) != 0) number += static_cast<char>(words_.get());
    } else {
      std::string name;
      while (!at_blank() && words_.peek() != ':') name += static_cast<char>(words_.get());
      const std::size_t dot = name.rfind('.');
      if (dot == std::string::npos) fail("'" + shown_text(name) + "' has no edge behind it");
      panel = name.substr(0, dot);
      number = name.substr(dot + 1);
    }
    const auto& all = panels_.pattern().panels;
    const auto found = std::ranges::find(all, panel, &PatternPanel::name);
    if (found == all.end()) {
      fail("there is no panel '" + shown_text(panel) + "'", "use a name of the pattern");
    }
    const int index = static_cast<int>(found - all.begin());
    for (const EdgeRef& edge : panels_.edges_of(index)) {
      if (std::to_string(edge.edge) == number) return edge;
    }
    fail("panel '" + shown_text(panel) + "' has no edge '" + shown_text(number) + "'",
         "use a number of one of its edges");
  }

  bool at_blank() {
    const int next = words_.peek();
    return next == std::char_traits<char>::eof() || std::isspace(next) != 0;
  }

  const SewnPanels& panels_;
  const std::string& rule_;
  std::istringstream words_;
};

}  // namespace

std::string rule_text(const Pattern& pattern, const EdgeRef& edge) {
  const std::string& name = pattern.panels[edge.panel].name;
  std::ostringstream text;
  if (name.find_first_of(" \t\n\v\f\r\":\\") == std::string::npos) {
    text << name;
  } else {
    text << std::quoted(name);
  }
  text << '.' << edge.edge;
  return text.str();
}

std::string rule_text(const Pattern& pattern, const EdgePoint& point) {
  std::string text = rule_text(pattern, point.edge) + ":";
  if (point.fraction == 0) return text + "start";
  if (point.fraction == 1) return text + "end";
  append_number(text, point.fraction);
  return text;
}

std::string rule_along(const Pattern& pattern, const std::vector<EdgeRef>& edges) {
  std::string text = "along";
  for (const EdgeRef& edge : edges) text.append(" ").append(rule_text(pattern, edge));
  return text;
}

double measure_by_rule(const SewnPanels& panels, const std::string& rule) {
  return RuleReader(panels, rule).value();
}

}  // namespace toile
