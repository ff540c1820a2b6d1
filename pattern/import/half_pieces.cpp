#include "pattern/import/half_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/text.h"
#include "pattern/classify/name_words.h"
#include "pattern/seams/panel_words.h"

namespace toile {

namespace {

/// Metres: a shorter edge is no fold that is worth a note.
constexpr double shortest_fold = 0.02;

/// Sine of the angle between a fold and the grain at most: half a degree.
constexpr double most_off_grain = 0.0087;

/// Metres: how straight a fold is, and how near a whole piece is to its mirror image.
constexpr double straight_within = 1e-3;
constexpr double mirrored_within = 2e-3;

/// The edge's ends, if it is straight.
std::optional<PieceLine> straight_line(const EdgedOutline& outline, const OutlineEdge& edge) {
  const PieceLine line{outline.vertices[static_cast<std::size_t>(edge.from)],
                       outline.vertices[static_cast<std::size_t>(edge.to)]};
  if ((line.to - line.from).norm() < straight_within) return std::nullopt;
  for (const FittedCurve& curve : edge.curves) {
    for (const Vec2& point : curve.points) {
      if (distance_to_segment(point, line.from, line.to) > straight_within) return std::nullopt;
    }
  }
  return line;
}

}  // namespace

bool is_mirror_image(const std::vector<Vec2>& outline, const Vec2& across) {
  double low = outline.front().dot(across);
  double high = low;
  for (const Vec2& point : outline) {
    low = std::min(low, point.dot(across));
    high = std::max(high, point.dot(across));
  }
  return std::all_of(outline.begin(), outline.end(), [&](const Vec2& point) {
    const Vec2 mirrored = point + (low + high - 2 * point.dot(across)) * across;
    return nearest_place(outline, mirrored).distance <= mirrored_within;
  });
}

bool lies_across_the_middle(const std::string& name) {
  PatternPanel panel;
  panel.name = name;
  const PanelRole role = words_of(panel).role;
  return any_fits(words_in(name), {"stand"}) || role == PanelRole::collar ||
         role == PanelRole::yoke || role == PanelRole::hood;
}

std::optional<int> likely_fold(const PieceShape& shape, const EdgedOutline& outline) {
  Vec2 warp = Vec2::UnitY();
  if (shape.grain && (shape.grain->to - shape.grain->from).norm() > 0) {
    warp = (shape.grain->to - shape.grain->from).normalized();
  }
  const Vec2 across(-warp.y(), warp.x());
  std::optional<int> best;
  double longest = shortest_fold;
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    const auto line = straight_line(outline, outline.edges[i]);
    if (!line) continue;
    const Vec2 along = line->to - line->from;
    if (along.norm() < longest || std::abs(along.dot(across)) > most_off_grain * along.norm()) {
      continue;
    }
    // The outline is counter-clockwise: all of a piece that is folded here lies to the left.
    const Vec2 left = Vec2(-along.y(), along.x()).normalized();
    const bool one_side = std::all_of(
        shape.outline.begin(), shape.outline.end(),
        [&](const Vec2& point) { return (point - line->from).dot(left) > -straight_within; });
    if (!one_side) continue;
    longest = along.norm();
    best = static_cast<int>(i);
  }
  if (best && is_mirror_image(shape.outline, across)) return std::nullopt;
  return best;
}

PieceLine fold_along(const EdgedOutline& outline, int edge, const std::string& place) {
  if (edge < 0 || static_cast<std::size_t>(edge) >= outline.edges.size()) {
    throw Error(place,
                "has no edge " + std::to_string(edge) + ", but edges 0 to " +
                    std::to_string(outline.edges.size() - 1),
                "count them in the pattern that is written without --unfold");
  }
  const auto line = straight_line(outline, outline.edges[static_cast<std::size_t>(edge)]);
  if (!line) {
    throw Error(place, "edge " + std::to_string(edge) + " is curved; a fold is straight",
                "name the edge that lies on the fold");
  }
  return *line;
}

NamedPiece named_piece(const std::string& text, const std::vector<std::string>& names,
                       const std::string& place) {
  const auto find = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  NamedPiece named;
  named.piece = find(text);
  if (named.piece < names.size()) return named;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string::npos) {
    const std::string number = text.substr(colon + 1);
    named.piece = find(text.substr(0, colon));
    const bool digits = !number.empty() && number.size() < 7 &&
                        number.find_first_not_of("0123456789") == std::string::npos;
    if (named.piece < names.size() && digits) {
      named.edge = std::stoi(number);
      return named;
    }
  }
  std::string list;
  constexpr std::size_t most_listed = 20;
  for (std::size_t i = 0; i < names.size() && i < most_listed; ++i) {
    list += (i == 0 ? "" : ", ") + shown_text(names[i]);
  }
  if (names.size() > most_listed) list += " and others";
  throw Error(place, "names no piece of the drawing", "its pieces are " + list);
}

std::string shell_word(const std::string& word) {
  std::string plain = shown_text(word);
  if (plain.find_first_of(" '\"$`&|;<>()*?![]{}~#") == std::string::npos) return plain;
  return std::string(1, '"').append(plain).append(1, '"');
}

}  // namespace toile
