#include "pattern/file/edge_json.h"

#include <algorithm>
#include <array>
#include <map>

#include "geometry/error.h"
#include "io/json_words.h"
#include "io/limits.h"
#include "pattern/constants.h"

namespace toile {

namespace {

Elastic read_elastic(const JsonValue& value, std::vector<Remark>& remarks) {
  note_unread(value, {"ratio", "stiffness_N"}, remarks);
  Elastic elastic;
  const JsonValue ratio = value.get("ratio");
  elastic.ratio = ratio.number();
  if (!(elastic.ratio >= 0.1 && elastic.ratio <= 1)) {
    ratio.fail("is not between 0.1 and 1", "it is the elastic's length at rest over the edge's");
  }
  const auto stiffness = value.find("stiffness_N");
  elastic.stiffness = stiffness ? stiffness->number() : usual_elastic_stiffness;
  if (!(elastic.stiffness > 0 && elastic.stiffness <= 1e4)) {
    stiffness->fail("is not between 0 and 10,000 N", "a waistband's is some 20");
  }
  return elastic;
}

/// Walks the edges from the first one into one closed loop.
std::vector<OutlineStep> closed_loop(const std::string& place,
                                     const std::vector<std::array<int, 2>>& ends) {
  std::map<int, std::vector<int>> at_vertex;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    for (const int vertex : ends[e]) at_vertex[vertex].push_back(static_cast<int>(e));
  }
  for (const auto& [vertex, meeting] : at_vertex) {
    if (meeting.size() == 2) continue;
    throw Error(place + ", edge " + std::to_string(meeting.front()),
                "edges at vertex " + std::to_string(vertex) + ": " +
                    std::to_string(meeting.size()) + ", not 2",
                "an outline is one closed loop, two edges at each of its vertices");
  }
  std::vector<OutlineStep> steps;
  int edge = 0;
  int vertex = ends[0][0];
  do {
    const auto& pair = ends[static_cast<std::size_t>(edge)];
    const bool forward = pair[0] == vertex;
    steps.push_back({edge, forward});
    vertex = forward ? pair[1] : pair[0];
    const auto& meeting = at_vertex[vertex];
    edge = meeting[0] == edge ? meeting[1] : meeting[0];
  } while (edge != 0 && steps.size() <= ends.size());
  if (steps.size() != ends.size()) {
    std::vector<bool> walked(ends.size(), false);
    for (const OutlineStep& step : steps) walked[static_cast<std::size_t>(step.edge)] = true;
    const auto missed = std::find(walked.begin(), walked.end(), false) - walked.begin();
    throw Error(place + ", edge " + std::to_string(missed), "belongs to a second loop",
                "a panel has one outline; holes are not read");
  }
  return steps;
}

/// A control point of an edge, in metres.
Vec2 read_control(const JsonValue& value, const Vec2& start, const Vec2& end,
                  const DrawingFrame& frame) {
  if (frame.absolute_controls) return read_point(value, frame.unit) - frame.origin;
  const Vec2 relative = read_pair(value);
  const Vec2 run = end - start;
  Vec2 point = start + relative.x() * run + relative.y() * Vec2(-run.y(), run.x());
  if (!(point.cwiseAbs().maxCoeff() <= max_metres)) {
    value.fail("lies more than a kilometre away", "correct the curve's points");
  }
  return point;
}

/// Cubic curves that follow each other: two control points of each, and the joints between.
EdgeCurve read_chain(const JsonValue& params, const Vec2& start, const Vec2& end,
                     const DrawingFrame& frame) {
  const std::size_t count = params.size(2, 3 * static_cast<std::size_t>(max_chain_curves) - 1);
  if (count % 3 != 2) {
    params.fail("has " + std::to_string(count) + " points instead of 2, 5, 8 and so on",
                "give two control points for each curve, and the joints between");
  }
  const auto control = [&](const JsonValue& value) {
    return read_control(value, start, end, frame);
  };
  std::vector<EdgeCurve> parts;
  for (std::size_t i = 0; i < count; i += 3) {
    const Vec2 from = parts.empty() ? start : parts.back().end();
    const Vec2 to = i + 2 < count ? control(params.item(i + 2)) : end;
    if (from == to) params.fail("has a curve that ends where it starts", "remove it");
    parts.push_back(
        EdgeCurve::cubic(from, control(params.item(i)), control(params.item(i + 1)), to));
  }
  return EdgeCurve::chain(std::move(parts));
}

EdgeCurve read_curve(const JsonValue& edge, const Vec2& start, const Vec2& end,
                     const DrawingFrame& frame, std::vector<Remark>& remarks) {
  const auto curvature = edge.find("curvature");
  if (!curvature) return EdgeCurve::line(start, end);
  const auto control = [&](const JsonValue& value) {
    return read_control(value, start, end, frame);
  };
  // The first generation of the format knew one kind of curve: a lone quadratic control point.
  if (curvature->is_array()) return EdgeCurve::quadratic(start, control(*curvature), end);
  note_unread(*curvature, {"type", "params"}, remarks);
  const JsonValue type = curvature->get("type");
  const std::string kind = type.text();
  const JsonValue params = curvature->get("params");
  if (kind == "quadratic") {
    params.size(1, 1);
    return EdgeCurve::quadratic(start, control(params.item(0)), end);
  }
  if (kind == "cubic") {
    params.size(2, 2);
    return EdgeCurve::cubic(start, control(params.item(0)), control(params.item(1)), end);
  }
  if (kind == "cubics") return read_chain(params, start, end, frame);
  if (kind != "circle") {
    type.fail(in_quotes(kind) + " is unknown", "use quadratic, cubic, cubics or circle");
  }
  params.size(3, 3);
  const double radius = params.item(0).number() * frame.unit;
  if (!(radius > 0) || radius > 1e6) params.item(0).fail("is no radius");
  const double half = (end - start).norm() / 2;
  if (radius < half * (1 - radius_note_threshold)) {
    remarks.push_back(
        {false,
         edge.place() + ": the circle's radius is too short to reach; half the chord is taken"});
  }
  return EdgeCurve::arc(start, end, radius, params.item(1).flag(), params.item(2).flag());
}

}  // namespace

Vec2 read_pair(const JsonValue& value) {
  value.size(2, 2);
  return {value.item(0).number(), value.item(1).number()};
}

Vec2 read_point(const JsonValue& value, double unit) {
  Vec2 point = read_pair(value) * unit;
  if (point.cwiseAbs().maxCoeff() > max_metres) {
    value.fail("lies more than a kilometre away", "check 'units_in_meter'");
  }
  return point;
}

void note_unread(const JsonValue& value, const std::vector<std::string>& known,
                 std::vector<Remark>& remarks) {
  for (const std::string& key : value.keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    remarks.push_back({false, value.place() + ": key " + in_quotes(key) + " is not read"});
  }
}

void refuse_more(const JsonValue& list, std::size_t count, int max, const std::string& what) {
  if (count <= static_cast<std::size_t>(max)) return;
  list.fail("has " + std::to_string(count) + " " + what + ", more than " + std::to_string(max),
            "is it really a garment? split the file, or join short edges to curves");
}

PanelEdges read_edges(const JsonValue& list, const std::vector<Vec2>& vertices,
                      const DrawingFrame& frame, const std::string& place,
                      std::vector<Remark>& remarks) {
  PanelEdges panel;
  const std::size_t count = list.size(2);
  refuse_more(list.called(place), count, max_panel_edges, "edges");
  std::vector<std::array<int, 2>> ends;
  for (std::size_t i = 0; i < count; ++i) {
    const JsonValue edge = list.item(i).called(place + ", edge " + std::to_string(i));
    note_unread(edge, {"endpoints", "curvature", "label", "elastic"}, remarks);
    const JsonValue endpoints = edge.get("endpoints");
    endpoints.size(2, 2);
    std::array<int, 2> pair{};
    for (std::size_t k = 0; k < 2; ++k) {
      pair[k] = endpoints.item(k).index();
      if (pair[k] >= static_cast<int>(vertices.size())) {
        edge.fail("names vertex " + std::to_string(pair[k]) + ", but the panel has " +
                  std::to_string(vertices.size()));
      }
    }
    if (pair[0] == pair[1]) edge.fail("starts and ends at the same vertex", "split it in two");
    ends.push_back(pair);
    PatternEdge read{read_curve(edge, vertices[static_cast<std::size_t>(pair[0])],
                                vertices[static_cast<std::size_t>(pair[1])], frame, remarks),
                     ""};
    if (const auto label = edge.find("label")) read.label = label->text();
    if (const auto given = edge.find("elastic")) read.elastic = read_elastic(*given, remarks);
    panel.edges.push_back(std::move(read));
  }
  panel.outline = closed_loop(place, ends);
  return panel;
}

int read_sewn_edge(const JsonValue& stitch, std::size_t which, const std::string& panel,
                   std::size_t edges) {
  const JsonValue side =
      stitch.item(which).called(stitch.place() + ", side " + std::to_string(which));
  const JsonValue edge = side.get("edge");
  const double number = edge.number();
  if (number < 0 || number >= static_cast<double>(edges)) {
    constexpr int digits = 10;
    stitch.fail("names edge " + number_text(number, digits) + " of panel " + in_quotes(panel) +
                    ", which has edges 0 to " + std::to_string(edges - 1),
                "correct the edge or remove the stitch");
  }
  return edge.index();
}

}  // namespace toile
