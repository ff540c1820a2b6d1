#include "pattern/import/dxf_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/text.h"
#include "pattern/import/drawing_unit.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_text.h"

namespace toile {

namespace {

/// Inserts within inserts.
constexpr int max_insert_depth = 16;

/// Entities of all pieces, nested inserts included.
constexpr std::size_t max_piece_entities = 500'000;

/// Metres: a seam allowance is between these.
constexpr double min_allowance = 1e-3;
constexpr double max_allowance = 0.06;

/// Metres: chords that are good enough to compare outlines.
constexpr double rough = 1e-4;

constexpr int boundary_layer = 1;
constexpr int turn_layer = 2;
constexpr int mirror_layer = 6;
constexpr int grain_layer = 7;
constexpr int internal_layer = 8;
constexpr int cut_out_layer = 11;
constexpr int drill_layer = 13;
constexpr int sew_layer = 14;
constexpr int any_layer = -1;

/// The number that names a layer; any_layer: it has another name.
int layer_number(const DxfEntity& entity) {
  const std::string& name = entity.layer;
  if (name.empty() || name.size() > 3) return any_layer;
  int number = 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return any_layer;
    number = number * 10 + (c - '0');
  }
  return number;
}

bool is_notch_layer(int layer) { return layer == 4 || (layer >= 80 && layer <= 83); }

/// Layers of ASTM D6673 that nothing here is made of.
std::string unused_layer(int layer) {
  switch (layer) {
    case 3:
      return "curve points (layer 3)";
    case 5:
      return "grade reference lines (layer 5)";
    case 9:
      return "stripe lines (layer 9)";
    case 10:
      return "plaid lines (layer 10)";
    case 15:
      return "annotations (layer 15)";
    default:
      return layer >= 84 && layer <= 87 ? "curves to check by (layer " + std::to_string(layer) + ")"
                                        : "";
  }
}

/// The entities of one piece, in the drawing's unit.
struct Drawn {
  std::string name;
  std::vector<DxfEntity> entities;
  bool mirrored_twin = false;  ///< the block is inserted as drawn and mirrored
};

struct Box {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = Vec2::Constant(std::numeric_limits<double>::lowest());
  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  double size() const { return low.x() > high.x() ? 0 : (high - low).maxCoeff(); }
};

/// Finds the pieces among blocks and inserts.
class Collector {
 public:
  Collector(const DxfDrawing& drawing, const std::string& source, PieceDrawing& result)
      : drawing_(drawing), source_(source), result_(result) {
    const auto on_outline_layer = [](const std::vector<DxfEntity>& list) {
      return std::any_of(list.begin(), list.end(), [](const DxfEntity& entity) {
        const int layer = layer_number(entity);
        return entity.kind == DxfEntity::Kind::curves &&
               (layer == boundary_layer || layer == sew_layer);
      });
    };
    layered_ = on_outline_layer(drawing.entities);
    for (const DxfBlock& block : drawing.blocks) {
      layered_ = layered_ || on_outline_layer(block.entities);
    }
    carried_.assign(drawing.blocks.size(), unknown);
    for (std::size_t i = 0; i < drawing.blocks.size(); ++i) carried(static_cast<int>(i), 0);
    uses_.resize(drawing.blocks.size());
  }

  /// Whether outlines have layers of their own.
  bool layered() const { return layered_; }

  bool is_outline(const DxfEntity& entity) const {
    if (entity.kind != DxfEntity::Kind::curves) return false;
    const int layer = layer_number(entity);
    return !layered_ || layer == boundary_layer || layer == sew_layer;
  }

  std::vector<Drawn> pieces() {
    visit_inserts(drawing_.entities, Eigen::Affine2d::Identity(), 0);
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      const std::string& name = drawing_.blocks[i].name;
      // Without layers, arrow heads and dimensions look like pieces.
      const bool helper = !layered_ && !name.empty() && (name[0] == '*' || name[0] == '_');
      if (!uses_[i].used && !uses_[i].part && !helper && is_piece(static_cast<int>(i))) {
        visit(static_cast<int>(i), Eigen::Affine2d::Identity(), 0);
      }
    }
    std::vector<Drawn> pieces;
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      if (!uses_[i].used || !is_piece(static_cast<int>(i))) continue;
      Drawn drawn;
      drawn.name = drawing_.blocks[i].name;
      drawn.mirrored_twin = uses_[i].mirrored_twin;
      gather(static_cast<int>(i), uses_[i].placed, 0, drawn);
      if (uses_[i].more > 0 && !uses_[i].mirrored_twin) {
        result_.remarks.push_back({false, source_ + ": block " + in_quotes(drawn.name) +
                                              " is inserted " + std::to_string(uses_[i].more + 1) +
                                              " times; it is one piece"});
      }
      pieces.push_back(std::move(drawn));
    }
    return pieces;
  }

 private:
  static constexpr int unknown = -1;
  static constexpr int several = 2;

  /// How a block is used.
  struct Use {
    bool used = false;
    bool part = false;  ///< of another piece
    int more = 0;       ///< inserts after the first
    bool mirrored_twin = false;
    Eigen::Affine2d placed = Eigen::Affine2d::Identity();
  };

  const DxfBlock& block(int index) const {
    return drawing_.blocks[static_cast<std::size_t>(index)];
  }

  [[noreturn]] void too_deep(int index) const {
    throw Error(source_ + ":" + std::to_string(block(index).line),
                "block " + in_quotes(block(index).name) +
                    " inserts itself, or blocks are nested deeper than " +
                    std::to_string(max_insert_depth),
                "explode the inserts in the CAD program");
  }

  /// Outlines in a block: 0, 1 or several. An outline of its own hides those of its inserts.
  int carried(int index, int depth) {
    int& known = carried_[static_cast<std::size_t>(index)];
    if (known != unknown) return known;
    if (depth > max_insert_depth) too_deep(index);
    int count = 0;
    bool own = false;
    for (const DxfEntity& entity : block(index).entities) {
      own = own || is_outline(entity);
      if (entity.kind == DxfEntity::Kind::insert) count += carried(entity.block, depth + 1);
      count = std::min(count, several);
    }
    return carried_[static_cast<std::size_t>(index)] = own ? 1 : count;
  }

  bool is_piece(int index) const { return carried_[static_cast<std::size_t>(index)] == 1; }

  bool own_outline(int index) const {
    const auto& entities = block(index).entities;
    return std::any_of(entities.begin(), entities.end(),
                       [&](const DxfEntity& entity) { return is_outline(entity); });
  }

  void visit_inserts(const std::vector<DxfEntity>& list, const Eigen::Affine2d& placed, int depth) {
    for (const DxfEntity& entity : list) {
      if (entity.kind != DxfEntity::Kind::insert) continue;
      if (carried_[static_cast<std::size_t>(entity.block)] == 0) continue;
      visit(entity.block, placed * entity.placed, depth + 1);
    }
  }

  void visit(int index, const Eigen::Affine2d& placed, int depth) {
    if (depth > max_insert_depth) too_deep(index);
    if (++visits_ > max_piece_entities) {
      throw Error(source_, "has more than " + std::to_string(max_piece_entities) + " inserts",
                  "is it really a pattern? keep the layers of the pieces only");
    }
    if (!placed.matrix().allFinite()) {
      throw Error(source_, "block " + in_quotes(block(index).name) + " is inserted too far away",
                  "");
    }
    if (!is_piece(index)) {
      visit_inserts(block(index).entities, placed, depth);
      return;
    }
    Use& use = uses_[static_cast<std::size_t>(index)];
    if (use.used) {
      ++use.more;
      const bool turned =
          (use.placed.linear().determinant() < 0) != (placed.linear().determinant() < 0);
      use.mirrored_twin = use.mirrored_twin || turned;
      return;
    }
    use.used = true;
    use.placed = placed;
    if (own_outline(index))
      visit_inserts(block(index).entities, placed, depth);
    else
      mark_parts(index);
  }

  /// What a block without an outline of its own inserts is part of it.
  void mark_parts(int index) {
    for (const DxfEntity& entity : block(index).entities) {
      if (entity.kind != DxfEntity::Kind::insert) continue;
      Use& use = uses_[static_cast<std::size_t>(entity.block)];
      if (use.part || carried_[static_cast<std::size_t>(entity.block)] == 0) continue;
      use.part = true;
      mark_parts(entity.block);
    }
  }

  void gather(int index, const Eigen::Affine2d& placed, int depth, Drawn& drawn) {
    if (depth > max_insert_depth) too_deep(index);
    const bool own = own_outline(index);
    for (const DxfEntity& entity : block(index).entities) {
      if (entity.kind == DxfEntity::Kind::insert) {
        // An inserted outline is a piece of its own, beside one of this block.
        const bool apart = own && carried_[static_cast<std::size_t>(entity.block)] > 0;
        if (!apart) gather(entity.block, placed * entity.placed, depth + 1, drawn);
        continue;
      }
      if (++gathered_ > max_piece_entities) {
        throw Error(source_,
                    "its pieces have more than " + std::to_string(max_piece_entities) +
                        " entities, inserts included",
                    "is it really a pattern? keep the layers of the pieces only");
      }
      drawn.entities.push_back(transformed(entity, placed));
    }
  }

  const DxfDrawing& drawing_;
  const std::string& source_;
  PieceDrawing& result_;
  bool layered_ = false;
  std::vector<int> carried_;
  std::vector<Use> uses_;
  std::size_t gathered_ = 0;
  std::size_t visits_ = 0;
};

PiecePath path_of(const DxfEntity& entity, double unit) {
  PiecePath path;
  for (const DxfCurve& curve : entity.curves) {
    const auto& p = curve.points;
    path.push_back(curve.straight
                       ? EdgeCurve::line(p[0] * unit, p[3] * unit)
                       : EdgeCurve::cubic(p[0] * unit, p[1] * unit, p[2] * unit, p[3] * unit));
  }
  return path;
}

double path_length(const PiecePath& path) {
  double length = 0;
  for (const EdgeCurve& curve : path) length += curve.length();
  return length;
}

double distance_to_loop(const std::vector<Vec2>& loop, const Vec2& point) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    least = std::min(least, distance_to_segment(point, loop[i], loop[(i + 1) % loop.size()]));
  }
  return least;
}

/// At most some hundred of the points: comparisons take time with their square.
std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  constexpr std::size_t max_points = 400;
  const std::size_t step = points.size() / max_points + 1;
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); i += step) kept.push_back(points[i]);
  return kept;
}

/// Whether the closed path runs within the boundary, along all of it, as a seam line does.
bool runs_along(const std::vector<Vec2>& boundary, const PiecePath& path) {
  const std::vector<Vec2> inner = loop_points(path, rough);
  if (inner.size() < 3 || std::abs(signed_area(inner)) < std::abs(signed_area(boundary)) / 5) {
    return false;
  }
  for (const Vec2& point : thinned(inner)) {
    if (!inside(boundary, point) || distance_to_loop(boundary, point) < min_allowance) return false;
  }
  const std::vector<Vec2> outer = thinned(boundary);
  return std::all_of(outer.begin(), outer.end(), [&](const Vec2& point) {
    return distance_to_loop(inner, point) <= max_allowance;
  });
}

/// Makes pieces of what was drawn.
class Builder {
 public:
  Builder(const std::string& source, double unit, bool layered, bool cut_line, PieceDrawing& result)
      : source_(source), unit_(unit), layered_(layered), cut_line_(cut_line), result_(result) {}

  void add(const Drawn& drawn) {
    Piece piece;
    PieceTexts texts;
    sort(drawn, piece, texts);
    piece.name = texts.value("piece name");
    if (piece.name.empty()) piece.name = texts.spelling_of(drawn.name);
    if (piece.name.empty()) piece.name = drawn.name;
    piece.size = texts.value("size");
    piece.material = texts.material();
    if (const auto quantity = texts.quantity()) {
      piece.quantity = quantity->count;
      piece.pair = quantity->pair;
    } else if (drawn.mirrored_twin) {
      piece.quantity = 2;
    }
    piece.pair = piece.pair || (drawn.mirrored_twin && piece.quantity > 1);
    if (texts.others() > 0) result_.ignored["texts without a known key"] += texts.others();
    place_ = source_ + ": piece " + in_quotes(piece.name.empty() ? drawn.name : piece.name);
    outline(piece);
    result_.pieces.push_back(std::move(piece));
  }

 private:
  void ignore(const std::string& what) { ++result_.ignored[what]; }

  void sort(const Drawn& drawn, Piece& piece, PieceTexts& texts) {
    boundary_.clear();
    sew_.clear();
    internal_.clear();
    cut_outs_.clear();
    for (const DxfEntity& entity : drawn.entities) {
      const int layer = layered_ ? layer_number(entity) : any_layer;
      if (entity.kind == DxfEntity::Kind::text) {
        texts.add(entity.text);
      } else if (entity.kind == DxfEntity::Kind::point) {
        point(entity, layer, piece);
      } else {
        curve(entity, layer, piece);
      }
    }
  }

  void point(const DxfEntity& entity, int layer, Piece& piece) {
    const Vec2 at = entity.at * unit_;
    if (layer == turn_layer) {
      piece.corners.push_back(at);
    } else if (is_notch_layer(layer)) {
      PieceNotch notch{at, std::nullopt};
      if (entity.has_angle) notch.angle = entity.angle;
      piece.notches.push_back(notch);
    } else if (layer == drill_layer) {
      piece.drill_holes.push_back(at);
    } else {
      ignore_layer(entity, layer);
    }
  }

  void ignore_layer(const DxfEntity& entity, int layer) {
    const std::string known = unused_layer(layer);
    ignore(known.empty() ? entity.type + " on layer " + in_quotes(entity.layer) : known);
  }

  void curve(const DxfEntity& entity, int layer, Piece& piece) {
    const bool line_layer = layer == mirror_layer || layer == grain_layer;
    if (layer == boundary_layer || layer == any_layer) {
      if (layered_ && layer == any_layer) {
        ignore_layer(entity, layer);
        return;
      }
      boundary_.push_back(path_of(entity, unit_));
    } else if (layer == sew_layer) {
      sew_.push_back(path_of(entity, unit_));
    } else if (layer == internal_layer) {
      internal_.push_back(path_of(entity, unit_));
    } else if (layer == cut_out_layer) {
      cut_outs_.push_back(path_of(entity, unit_));
    } else if (layer == drill_layer && entity.type == "CIRCLE") {
      piece.drill_holes.push_back(entity.at * unit_);
    } else if (line_layer) {
      auto& line = layer == mirror_layer ? piece.fold : piece.grain;
      const PieceLine longest = longest_line(entity);
      // An arrow is drawn of several lines.
      if (!line || (longest.to - longest.from).norm() > (line->to - line->from).norm()) {
        line = longest;
      }
    } else if (is_notch_layer(layer)) {
      const PieceLine mark = longest_line(entity);
      const Vec2 along = mark.to - mark.from;
      piece.notches.push_back({mark.from, std::atan2(along.y(), along.x())});
    } else {
      ignore_layer(entity, layer);
    }
  }

  PieceLine longest_line(const DxfEntity& entity) const {
    PieceLine longest;
    for (const DxfCurve& curve : entity.curves) {
      const PieceLine line{curve.points[0] * unit_, curve.points[3] * unit_};
      if ((line.to - line.from).norm() > (longest.to - longest.from).norm()) longest = line;
    }
    return longest;
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(place_, problem, remedy);
  }

  /// The closed paths of a line of the piece, the largest first, each once.
  std::vector<PiecePath> loops(const std::vector<PiecePath>& paths, const std::string& what) {
    const JoinedPaths joined = join_paths(paths);
    std::vector<PiecePath> closed;
    std::vector<double> areas;
    for (const PiecePath& path : joined.closed) {
      const std::vector<Vec2> points = loop_points(path, rough);
      const double area = points.size() < 3 ? 0 : std::abs(signed_area(points));
      if (area < 1e-6) continue;
      const bool twin = std::any_of(closed.begin(), closed.end(), [&](const PiecePath& other) {
        const std::vector<Vec2> others = loop_points(other, rough);
        return std::abs(std::abs(signed_area(others)) - area) < 1e-6 * area &&
               distance_to_loop(others, points.front()) < max_outline_gap &&
               distance_to_loop(points, others.front()) < max_outline_gap;
      });
      if (twin) {
        ignore("outlines that are drawn twice");
        continue;
      }
      const auto after = std::upper_bound(areas.begin(), areas.end(), area, std::greater<>());
      closed.insert(closed.begin() + (after - areas.begin()), path);
      areas.insert(after, area);
    }
    double longest_open = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i < joined.open.size(); ++i) {
      const double length = path_length(joined.open[i]);
      if (length > longest_open) {
        longest_open = length;
        open = i;
      }
    }
    if (longest_open > 0 && (closed.empty() || longest_open > path_length(closed.front()))) {
      const PathGap gap = joined.gaps[std::min(open, joined.gaps.size() - 1)];
      fail("its " + what + " is open: a gap of " + number_text(gap.size * 1000) + " mm at " +
               millimetres_text(gap.at),
           "close it in the CAD program; gaps up to 0.5 mm are closed here");
    }
    for (std::size_t i = 0; i < joined.open.size(); ++i)
      ignore("open lines on the layer of a " + what);
    if (joined.widest_closed_gap > 1e-5) {
      result_.remarks.push_back({false, place_ + ": a gap of " +
                                            number_text(joined.widest_closed_gap * 1000, 2) +
                                            " mm in its " + what + " is closed"});
    }
    return closed;
  }

  void outline(Piece& piece) {
    std::vector<PiecePath> boundaries = loops(boundary_, "boundary");
    std::vector<PiecePath> sewn = loops(sew_, "sew line");
    const JoinedPaths internal = join_paths(internal_);
    std::vector<PiecePath> inner_lines = internal.open;
    inner_lines.insert(inner_lines.end(), internal.closed.begin(), internal.closed.end());
    if (boundaries.empty() && sewn.empty()) {
      fail("has no closed outline", "draw its boundary on layer 1");
    }
    std::vector<Vec2> boundary;
    if (!boundaries.empty()) {
      boundary = loop_points(boundaries.front(), rough);
      piece.outline = boundaries.front();
      piece.is_cut_line = true;
    }
    for (std::size_t i = 1; i < boundaries.size(); ++i) {
      const std::vector<Vec2> points = loop_points(boundaries[i], rough);
      if (!inside(boundary, points.front())) {
        fail(
            "has two outlines beside each other, the second at " + millimetres_text(points.front()),
            "give each piece a block of its own");
      }
      if (!layered_) {
        inner_lines.push_back(boundaries[i]);
      } else if (sewn.empty() && runs_along(boundary, boundaries[i])) {
        sewn.push_back(boundaries[i]);
      } else {
        result_.remarks.push_back({true, place_ + ": an outline within its boundary, at " +
                                             millimetres_text(points.front()) +
                                             ", is taken as a cut-out"});
        piece.cut_outs.push_back(boundaries[i]);
      }
    }
    if (sewn.size() > 1) {
      fail("has two closed sew lines", "give each piece a block of its own");
    }
    if (sewn.empty() && !boundary.empty()) find_sew_line(boundary, inner_lines, sewn);
    if (!sewn.empty() && !(cut_line_ && !boundaries.empty())) {
      piece.outline = sewn.front();
      piece.is_cut_line = false;
    }
    piece.internal_lines = std::move(inner_lines);
    for (PiecePath& path : loops(cut_outs_, "cut-out")) piece.cut_outs.push_back(std::move(path));
    move_notches_out(piece);
  }

  /// Takes the sew line from among the internal lines, if it is there.
  void find_sew_line(const std::vector<Vec2>& boundary, std::vector<PiecePath>& lines,
                     std::vector<PiecePath>& sewn) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const PiecePath& path) {
      return (path.front().start() - path.back().end()).norm() <= max_outline_gap &&
             runs_along(boundary, path);
    });
    if (found == lines.end()) return;
    sewn.push_back(*found);
    lines.erase(found);
    ++sew_lines_found_;
    if (sew_lines_found_ == 1) {
      result_.remarks.push_back(
          {false, place_ +
                      ": the internal line that runs along its boundary is its sew line; so it "
                      "is with other pieces"});
    }
  }

  /// A notch that is drawn as a line begins where the line is nearest to the outline.
  void move_notches_out(Piece& piece) const {
    if (piece.notches.empty()) return;
    for (std::size_t i = 0; i < piece.notches.size(); ++i) {
      const PieceNotch& notch = piece.notches[i];
      if (!notch.at.allFinite())
        piece.notches.erase(piece.notches.begin() + static_cast<long>(i--));
    }
  }

  const std::string& source_;
  double unit_;
  bool layered_;
  bool cut_line_;
  PieceDrawing& result_;
  std::string place_;
  std::vector<PiecePath> boundary_;
  std::vector<PiecePath> sew_;
  std::vector<PiecePath> internal_;
  std::vector<PiecePath> cut_outs_;
  int sew_lines_found_ = 0;
};

Box box_of(const std::vector<DxfEntity>& entities, const Collector& collector) {
  Box box;
  for (const DxfEntity& entity : entities) {
    if (!collector.is_outline(entity)) continue;
    for (const DxfCurve& curve : entity.curves) {
      box.add(curve.points[0]);
      box.add(curve.points[3]);
    }
  }
  return box;
}

/// The pieces that are drawn in model space: an outline, and what lies within.
std::vector<Drawn> loose_pieces(const DxfDrawing& drawing, const Collector& collector, double unit,
                                const std::string& source, PieceDrawing& result) {
  // Which entities each closed outline is made of is found again by where they lie.
  std::vector<PiecePath> paths;
  const auto is_boundary = [&](const DxfEntity& entity) {
    return collector.is_outline(entity) &&
           (!collector.layered() || layer_number(entity) == boundary_layer);
  };
  for (const DxfEntity& entity : drawing.entities) {
    if (is_boundary(entity)) paths.push_back(path_of(entity, unit));
  }
  if (paths.empty()) return {};
  const JoinedPaths joined = join_paths(paths);
  std::vector<std::vector<Vec2>> outlines;
  for (const PiecePath& path : joined.closed) {
    std::vector<Vec2> points = loop_points(path, rough);
    if (points.size() >= 3 && std::abs(signed_area(points)) > 1e-6) {
      outlines.push_back(std::move(points));
    }
  }
  double longest_loop = 0;
  for (const PiecePath& path : joined.closed)
    longest_loop = std::max(longest_loop, path_length(path));
  for (std::size_t i = 0; i < joined.open.size() && i < joined.gaps.size(); ++i) {
    if (path_length(joined.open[i]) < longest_loop / 4) continue;
    throw Error(source + ": model space",
                "an outline is open: a gap of " + number_text(joined.gaps[i].size * 1000) +
                    " mm at " + millimetres_text(joined.gaps[i].at),
                "close it in the CAD program; gaps up to 0.5 mm are closed here");
  }
  std::sort(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
    return std::abs(signed_area(a)) > std::abs(signed_area(b));
  });
  std::vector<std::vector<Vec2>> outer;
  for (auto& outline : outlines) {
    const bool within = std::any_of(outer.begin(), outer.end(), [&](const auto& other) {
      return inside(other, outline.front());
    });
    if (!within) outer.push_back(std::move(outline));
    if (outer.size() > 2000) {
      throw Error(source, "has more than 2,000 outlines in model space", "is it really a pattern?");
    }
  }
  std::vector<Drawn> pieces(outer.size());
  for (const DxfEntity& entity : drawing.entities) {
    if (entity.kind == DxfEntity::Kind::insert) continue;
    // The middle of the first curve: its ends may be shared with a neighbour.
    Vec2 point = entity.at;
    if (!entity.curves.empty()) {
      const auto& p = entity.curves.front().points;
      point = (p[0] + 3 * p[1] + 3 * p[2] + p[3]) / 8;
    }
    point *= unit;
    std::size_t owner = outer.size();
    double least = 2e-3;  // metres: notches stand on the outline, or a little outside
    for (std::size_t i = 0; i < outer.size(); ++i) {
      if (inside(outer[i], point)) {
        owner = i;
        break;
      }
      const double distance = distance_to_loop(outer[i], point);
      if (distance < least) {
        least = distance;
        owner = i;
      }
    }
    if (owner < outer.size()) {
      pieces[owner].entities.push_back(entity);
    } else if (entity.kind != DxfEntity::Kind::text) {
      ++result.ignored[entity.type + " outside of all pieces"];
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].name = "piece" + std::to_string(i + 1);
  return pieces;
}

}  // namespace

PieceDrawing dxf_pieces(const DxfDrawing& drawing, const std::string& source,
                        const DrawingOptions& options) {
  PieceDrawing result;
  result.source = source;
  result.ignored = drawing.ignored;
  Collector collector(drawing, source, result);
  std::vector<Drawn> pieces = collector.pieces();

  PieceTexts style;
  for (const DxfEntity& entity : drawing.entities) {
    if (entity.kind == DxfEntity::Kind::text) style.add(entity.text);
  }
  result.base_size =
      style.value("sample size").empty() ? style.value("base size") : style.value("sample size");

  UnitEvidence evidence;
  evidence.asked = options.unit;
  for (const Drawn& drawn : pieces) {
    evidence.largest = std::max(evidence.largest, box_of(drawn.entities, collector).size());
  }
  if (pieces.empty()) evidence.largest = box_of(drawing.entities, collector).size();
  if (!(evidence.largest > 0)) {
    throw Error(source, "holds no outline of a piece",
                "export the pieces as AAMA or ASTM DXF: outlines on layer 1, a block for each");
  }
  std::string units = style.value("units");
  for (const Drawn& drawn : pieces) {
    PieceTexts texts;
    for (const DxfEntity& entity : drawn.entities) {
      if (entity.kind == DxfEntity::Kind::text) texts.add(entity.text);
    }
    if (units.empty()) units = texts.value("units");
    if (result.base_size.empty()) result.base_size = texts.value("sample size");
  }
  for (char& c : units) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto says = [&](const char* word) { return units.find(word) != std::string::npos; };
  if (says("english") || says("inch") || says("imperial")) {
    evidence.stated = 0.0254;
  } else if (says("centim") || units == "cm") {
    evidence.stated = 1e-2;
  } else if (says("metric") || says("millim") || units == "mm") {
    evidence.stated = 1e-3;
  }
  if (evidence.stated) {
    evidence.stated_by = "'Units: " + shown_text(units) + "'";
  } else if (drawing.unit_metres > 0) {
    evidence.stated = drawing.unit_metres;
    evidence.stated_by = "$INSUNITS";
  }
  evidence.english = drawing.measurement == DxfMeasurement::english;
  const double unit = drawing_unit(evidence, source, result.remarks);

  for (Drawn& drawn : loose_pieces(drawing, collector, unit, source, result)) {
    pieces.push_back(std::move(drawn));
  }
  Builder builder(source, unit, collector.layered(), options.cut_line, result);
  for (const Drawn& drawn : pieces) builder.add(drawn);
  return result;
}

}  // namespace toile
