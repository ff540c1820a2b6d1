#include "pattern/seams/edge_split.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/json_value.h"
#include "pattern/seams/sewn_file.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;
using Cubic = std::array<Vec2, 4>;

/// From a panel's drawing to the coordinates of its file.
class FilePlace {
 public:
  FilePlace(const EdgeCurve& curve, const Json& start, const Json& end)
      : origin_(curve.start()),
        run_(curve.end() - curve.start()),
        file_origin_(start[0].get<double>(), start[1].get<double>()),
        file_run_(Vec2(end[0].get<double>(), end[1].get<double>()) - file_origin_) {}

  Vec2 in_file(const Vec2& point) const {
    const Vec2 place = in_frame(point, origin_, run_);
    return file_origin_ + place.x() * file_run_ + place.y() * Vec2(-file_run_.y(), file_run_.x());
  }

  /// In the frame of an edge that starts at `start` and runs along `run`.
  static Vec2 in_frame(const Vec2& point, const Vec2& start, const Vec2& run) {
    const Vec2 arm = point - start;
    return Vec2(arm.dot(run), arm.dot(Vec2(-run.y(), run.x()))) / run.squaredNorm();
  }

 private:
  Vec2 origin_;
  Vec2 run_;
  Vec2 file_origin_;
  Vec2 file_run_;
};

Json as_json(const Vec2& point) { return {point.x(), point.y()}; }

/// What stands for curves that follow each other in a file.
Json curvature_of(const std::vector<Cubic>& curves, bool absolute, const FilePlace& place) {
  const Vec2 start = curves.front()[0];
  const Vec2 run = curves.back()[3] - start;
  Json params = Json::array();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t k = i == 0 ? 1 : 0; k < 3; ++k) {
      params.push_back(as_json(absolute ? place.in_file(curves[i][k])
                                        : FilePlace::in_frame(curves[i][k], start, run)));
    }
  }
  return {{"type", curves.size() == 1 ? "cubic" : "cubics"}, {"params", std::move(params)}};
}

bool has_absolute_curves(const Json& file) {
  const auto properties = file.find("properties");
  return properties != file.end() && properties->value("curvature_coords", "") == "absolute";
}

}  // namespace

std::string with_split_edge(const std::string& text, const Pattern& pattern,
                            const EdgeSplit& split) {
  Json file = parse_json(text, pattern.source);
  const bool absolute = has_absolute_curves(file);
  const PatternPanel& panel = pattern.panels[split.edge.panel];
  const EdgeCurve& curve = panel.edges[split.edge.edge].curve;
  Json& drawn = file["pattern"]["panels"][panel.name];
  Json& edge = drawn["edges"][split.edge.edge];
  const int from = edge["endpoints"][0].get<int>();
  const int to = edge["endpoints"][1].get<int>();
  const FilePlace place(curve, drawn["vertices"][from], drawn["vertices"][to]);
  const int middle = static_cast<int>(drawn["vertices"].size());
  drawn["vertices"].push_back(as_json(place.in_file(curve.at(split.share))));
  Json rest = edge;
  rest["endpoints"] = {middle, to};
  edge["endpoints"] = {from, middle};
  const auto curvature = edge.find("curvature");
  if (curvature != edge.end() && curvature->is_object() && (*curvature)["type"] == "circle") {
    // The sweep is the length over the radius, which need not be in the file's unit for that.
    const double sweep = std::abs(curve.turning());
    edge["curvature"]["params"][1] = split.share * sweep > std::numbers::pi ? 1 : 0;
    rest["curvature"]["params"][1] = (1 - split.share) * sweep > std::numbers::pi ? 1 : 0;
  } else if (!curve.straight()) {
    const auto [first, second] = curve.cut_at(split.share);
    edge["curvature"] = curvature_of(first.cubics(), absolute, place);
    rest["curvature"] = curvature_of(second.cubics(), absolute, place);
  }
  drawn["edges"].push_back(std::move(rest));
  return file.dump(indent_of(text)) + "\n";
}

}  // namespace toile
