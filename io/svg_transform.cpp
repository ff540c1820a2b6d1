#include "io/svg_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "io/svg_scanner.h"
#include "io/text.h"

namespace toile {

namespace {

PlaneTransform matrix(const std::array<double, 6>& columns) {
  PlaneTransform transform;
  transform.matrix() << columns[0], columns[2], columns[4], columns[1], columns[3], columns[5];
  return transform;
}

PlaneTransform translation(double x, double y) { return matrix({1, 0, 0, 1, x, y}); }

PlaneTransform one_transform(std::string_view name, const std::vector<double>& given,
                             const SvgScanner& scanner) {
  const std::size_t count = given.size();
  const auto value = [&](std::size_t i, double otherwise) {
    return i < count ? given[i] : otherwise;
  };
  if (name == "matrix" && count == 6) {
    return matrix({given[0], given[1], given[2], given[3], given[4], given[5]});
  }
  if (name == "translate" && (count == 1 || count == 2)) return translation(given[0], value(1, 0));
  if (name == "scale" && (count == 1 || count == 2)) {
    return matrix({given[0], 0, 0, value(1, given[0]), 0, 0});
  }
  if (name == "rotate" && (count == 1 || count == 3)) {
    const double c = std::cos(given[0] * radians_per_degree);
    const double s = std::sin(given[0] * radians_per_degree);
    return translation(value(1, 0), value(2, 0)) * matrix({c, s, -s, c, 0, 0}) *
           translation(-value(1, 0), -value(2, 0));
  }
  if (name == "skewX" && count == 1) {
    return matrix({1, 0, std::tan(given[0] * radians_per_degree), 1, 0, 0});
  }
  if (name == "skewY" && count == 1) {
    return matrix({1, std::tan(given[0] * radians_per_degree), 0, 1, 0, 0});
  }
  scanner.fail("the transform '" + shown_text(name) + "' with " + std::to_string(count) +
               " numbers is unknown");
}

}  // namespace

PlaneTransform svg_transform(std::string_view text, const std::string& place) {
  SvgScanner scanner(text, place);
  PlaneTransform whole = PlaneTransform::Identity();
  while (!scanner.at_end()) {
    const std::string_view name = scanner.word();
    if (name == "none" && scanner.at_end()) break;
    if (name.empty() || scanner.letter() != '(') scanner.fail("a transform can't be read");
    std::vector<double> given;
    while (scanner.at_number() && given.size() < 7) given.push_back(scanner.number());
    if (scanner.letter() != ')') scanner.fail("a transform has no ')'");
    whole = whole * one_transform(name, given, scanner);
  }
  return whole;
}

PlaneTransform svg_view_transform(const Vec2& corner, const Vec2& size, const Vec2& frame,
                                  std::string_view aspect, const std::string& place) {
  SvgScanner scanner(aspect, place);
  std::string_view align = scanner.word();
  if (align == "defer") align = scanner.word();
  if (align.empty()) align = "xMidYMid";
  Vec2 scale = frame.cwiseQuotient(size);
  if (align != "none") {
    const bool slice = scanner.word() == "slice";
    scale.setConstant(slice ? scale.maxCoeff() : scale.minCoeff());
  }
  const auto share = [&](std::string_view part) {
    if (part == "Min") return 0.0;
    if (part == "Mid") return 0.5;
    if (part == "Max") return 1.0;
    scanner.fail("preserveAspectRatio has no value '" + shown_text(aspect) + "'");
  };
  Vec2 shift = Vec2::Zero();
  if (align != "none") {
    if (align.size() != 8 || align[0] != 'x' || align[4] != 'Y') share("");
    shift = (frame - scale.cwiseProduct(size))
                .cwiseProduct(Vec2(share(align.substr(1, 3)), share(align.substr(5, 3))));
  }
  shift -= scale.cwiseProduct(corner);
  return matrix({scale.x(), 0, 0, scale.y(), shift.x(), shift.y()});
}

DrawnPath transformed(const DrawnPath& path, const PlaneTransform& transform) {
  DrawnPath moved;
  moved.start = transform * path.start;
  moved.closed = path.closed;
  moved.segments.reserve(path.segments.size());
  for (const DrawnSegment& segment : path.segments) {
    moved.segments.push_back({segment.curved, transform * segment.control1,
                              transform * segment.control2, transform * segment.end});
  }
  return moved;
}

}  // namespace toile
