#include "pattern/import/imported_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/text.h"
#include "pattern/constants.h"
#include "pattern/import/drawn_seams.h"
#include "pattern/import/graded_pieces.h"
#include "pattern/import/half_pieces.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/pair_pieces.h"
#include "pattern/import/piece_shape.h"
#include "pattern/import/upright.h"
#include "pattern/layout/row_layout.h"
#include "pattern/seams/panel_words.h"

namespace toile {

namespace {

/// Metres between panels that are laid out.
constexpr double layout_gap = 0.02;

/// Metres: rows of the layout are about as wide.
constexpr double layout_width = 2;

/// What dress takes panels of ribbing as: the one knit that it knows by name.
constexpr const char* ribbing_fabric = "jersey";

/// Metres from the outline of what a program wrote as a panel to its edges, at most. With chords as
/// sheet_dxf() draws them, a pattern that is drawn and read again differs by less than 0.01 mm.
/// With half of it curves follow the chords and double at each turn; with double it differs by
/// more.
constexpr double panel_chord_error = 4e-6;

/// Share of the chord error that chords in place of drawn curves may take.
constexpr double sampling_share = 0.1;

bool same_word(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

/// A name that patterns, meshes and file names can have.
std::string panel_name(const std::string& piece) {
  std::string name = valid_utf8(piece);
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\' || c == '/') c = '_';
  }
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) return "piece";
  name = name.substr(first, name.find_last_not_of(' ') - first + 1);
  constexpr std::size_t max_bytes = 80;
  if (name.size() > max_bytes) {
    std::size_t end = max_bytes;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80) --end;
    name = name.substr(0, end);
    while (!name.empty() && name.back() == ' ') name.pop_back();
  }
  return name;
}

struct PanelBox {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = Vec2::Constant(std::numeric_limits<double>::lowest());
};

PanelBox panel_box(const ImportedPanel& panel) {
  PanelBox box;
  for (const OutlineEdge& edge : panel.outline.edges) {
    for (const FittedCurve& curve : edge.curves) {
      for (const Vec2& point : curve.points) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
      }
    }
  }
  return box;
}

void move(ImportedPanel& panel, const Vec2& by) {
  const auto all = [&](std::vector<Vec2>& points) {
    for (Vec2& point : points) point += by;
  };
  all(panel.outline.vertices);
  for (OutlineEdge& edge : panel.outline.edges) {
    for (FittedCurve& curve : edge.curves) {
      for (Vec2& point : curve.points) point += by;
    }
  }
  for (auto& line : panel.internal_lines) all(line);
  for (auto& loop : panel.cut_outs) all(loop);
  all(panel.drill_holes);
  panel.moved += by;
}

/// Lays panels out in rows if any two of them overlap, or all lie too far off.
void lay_out(std::vector<ImportedPanel>& panels) {
  std::vector<PanelBox> boxes;
  boxes.reserve(panels.size());
  for (const ImportedPanel& panel : panels) boxes.push_back(panel_box(panel));
  bool overlap = false;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    overlap = overlap || boxes[i].low.cwiseAbs().maxCoeff() > 100;  // metres
    for (std::size_t k = 0; k < i && !overlap; ++k) {
      overlap = (boxes[i].low.array() < boxes[k].high.array()).all() &&
                (boxes[k].low.array() < boxes[i].high.array()).all();
    }
  }
  if (!overlap) return;
  RowFiller rows(layout_gap, 0, layout_width);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    move(panels[i], rows.add(boxes[i].high - boxes[i].low) - boxes[i].low);
  }
}

/// The drawing's sizes in its order, each once.
std::vector<std::string> sizes_of(const PieceDrawing& drawing) {
  std::vector<std::string> sizes;
  for (const Piece& piece : drawing.pieces) {
    const bool known = std::any_of(sizes.begin(), sizes.end(), [&](const std::string& size) {
      return same_word(size, piece.size);
    });
    if (!piece.size.empty() && !known) sizes.push_back(piece.size);
  }
  return sizes;
}

class Importer {
 public:
  Importer(const PieceDrawing& drawing, const ImportOptions& options, std::vector<Remark>& remarks)
      : drawing_(drawing), options_(options), remarks_(remarks) {}

  ImportedPattern import() {
    remarks_.insert(remarks_.end(), drawing_.remarks.begin(), drawing_.remarks.end());
    for (const auto& [what, count] : drawing_.ignored) {
      note(drawing_.source + ": not used: " + std::to_string(count) + " x " + shown_text(what));
    }
    choose_size();
    choose_pieces();
    take_requests();
    std::erase_if(chosen_, [&](ChosenPiece& chosen) {
      return !holds(
          [&] {
            chosen.shape =
                shape_of(chosen.piece, place_of(chosen),
                         edge_options(chosen.piece).chord_error * sampling_share, remarks_);
          },
          chosen);
    });
    stand_upright();
    int cut_lines = 0;
    for (const ChosenPiece& chosen : chosen_) {
      if (!holds([&] { add(chosen); }, chosen)) continue;
      if (chosen.piece.is_cut_line && !options_.seam_allowance) ++cut_lines;
    }
    for (const LeftOutPiece& piece : pattern_.left_out) {
      remarks_.push_back({true, std::string(piece.error.what()) + "; the piece is left out"});
    }
    if (pattern_.panels.empty() && !pattern_.left_out.empty()) {
      throw Error(pattern_.left_out.front().error);
    }
    if (pattern_.panels.empty()) {
      throw Error(drawing_.source, "holds no piece: no closed outline was found in it",
                  "draw each piece as a closed line; the notes name what was not used");
    }
    if (pattern_.panels.size() > static_cast<std::size_t>(max_panels)) {
      throw Error(drawing_.source,
                  "has " + std::to_string(pattern_.panels.size()) + " pieces, more than " +
                      std::to_string(max_panels),
                  "is it really a garment?");
    }
    if (options_.seam_allowance && std::ranges::none_of(chosen_, [](const ChosenPiece& chosen) {
          return chosen.piece.is_cut_line;
        })) {
      note(drawing_.source + ": no piece has a cut line only; no seam allowance is taken off");
    }
    if (cut_lines > 0) {
      note(drawing_.source + ": " + std::to_string(cut_lines) + " of " +
           std::to_string(pattern_.panels.size()) +
           " panels have a boundary and no sew line; if it is a cut line, give --seam-allowance");
    }
    if (!pairs_by_shape_.empty()) {
      note(drawing_.source + ": cut an even number of times, and taken as a left and a right one:" +
           pairs_by_shape_ + "; --single makes one panel");
    }
    if (no_grain_ > 0) {
      note(drawing_.source + ": " + std::to_string(no_grain_) +
           " panels have no grain line; their warp is taken " +
           (has_grain_  ? "along that of most others"
            : by_shape_ ? "as straight edges and mirror images tell it"
                        : "upright in the drawing"));
    }
    if (!ribbing_.empty()) {
      note(drawing_.source + ": cut of ribbing:" + ribbing_ + "; their fabric is " +
           ribbing_fabric + ", the known one that stretches, their warp across the longer side " +
           "where no grain line says it");
    }
    lay_out(pattern_.panels);
    pattern_.seams = drawn_seams(pattern_.panels, drawing_.source, remarks_);
    return std::move(pattern_);
  }

 private:
  void note(const std::string& text) { remarks_.push_back({false, text}); }

  /// Does the work on a piece; where that fails, the piece is left out. What was asked for has to
  /// hold.
  template <class Work, class Chosen>
  bool holds(const Work& work, const Chosen& chosen) {
    try {
      work();
      return true;
    } catch (const Error& error) {
      if (chosen.unfold) throw;
      pattern_.left_out.push_back({chosen.piece.name, chosen.piece.size, error});
      return false;
    }
  }

  void choose_size() {
    pattern_.sizes = sizes_of(drawing_);
    const auto find = [&](const std::string& size) {
      return std::find_if(pattern_.sizes.begin(), pattern_.sizes.end(),
                          [&](const std::string& other) { return same_word(size, other); });
    };
    std::string list;
    for (const std::string& size : pattern_.sizes)
      list += (list.empty() ? "" : ", ") + shown_text(size);
    if (!options_.size.empty()) {
      const auto found = find(options_.size);
      if (found == pattern_.sizes.end()) {
        throw Error(
            drawing_.source, "has no size " + in_quotes(options_.size),
            list.empty() ? "its pieces state no size; leave --size out" : "its sizes are " + list);
      }
      pattern_.size = *found;
      return;
    }
    if (pattern_.sizes.empty()) return;
    const auto base = find(drawing_.base_size);
    pattern_.size = base == pattern_.sizes.end() ? pattern_.sizes.front() : *base;
    if (pattern_.sizes.size() == 1) return;
    note(drawing_.source + ": size " + in_quotes(pattern_.size) + " is taken, " +
         (base == pattern_.sizes.end() ? "the first" : "the base size") + " of " + list +
         "; --size takes another");
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
  }

  /// A piece of the chosen size.
  struct ChosenPiece {
    Piece piece;
    std::string asked;  ///< the name that options have for it
    std::string left;   ///< the panel as drawn; of a pair, the left one
    std::string right;  ///< the mirrored panel of a pair
    PieceShape shape;   ///< turned upright
    double turned = 0;  ///< radians
    std::optional<NamedPiece> unfold;
    bool layers = false;    ///< drawn once for the layers that it is cut in
    bool by_shape = false;  ///< a pair, though the drawing does not say so
  };

  bool is_of_size(const std::string& size) const {
    return size.empty() || same_word(size, pattern_.size);
  }

  /// Names all panels before one is changed, so that options name what was written without them.
  void choose_pieces() {
    for (const Piece& piece : drawing_.pieces) {
      if (!is_of_size(piece.size)) continue;
      ChosenPiece chosen;
      chosen.piece = piece;
      const std::string name = panel_name(piece.name);
      const CutAs cut = cut_as(piece, options_.edges.chord_error);
      chosen.piece.pair = cut == CutAs::pair;
      chosen.by_shape = chosen.piece.pair && !piece.pair;
      chosen.layers = cut == CutAs::layers;
      if (chosen.piece.pair && piece.is_right_one) {
        chosen.right = unique("right_" + name);
        chosen.left = unique("left_" + name);
      } else if (chosen.piece.pair) {
        chosen.left = unique("left_" + name);
        chosen.right = unique("right_" + name);
      } else {
        chosen.left = unique(name);
      }
      chosen.asked = chosen.piece.pair ? name : chosen.left;
      chosen_.push_back(std::move(chosen));
    }
  }

  /// Leaves out what is not wanted. Pieces that were not read can be named, too.
  void leave_out() {
    for (const LeftOutPiece& piece : drawing_.left_out) {
      if (is_of_size(piece.size)) pattern_.left_out.push_back(piece);
    }
    std::string names;
    for (const std::string& text : options_.without) {
      const std::size_t unread = std::erase_if(pattern_.left_out, [&](const LeftOutPiece& piece) {
        return panel_name(piece.name) == text;
      });
      const auto found = std::ranges::find(chosen_, text, &ChosenPiece::asked);
      if (unread == 0 && found == chosen_.end()) {
        named_piece(text, asked_names(), drawing_.source + ": --without " + in_quotes(text));
      }
      if (found != chosen_.end()) chosen_.erase(found);
      names += (names.empty() ? " " : ", ") + shown_text(text);
    }
    if (!names.empty()) note(drawing_.source + ": left out as asked:" + names);
  }

  std::vector<std::string> asked_names() const {
    std::vector<std::string> names;
    names.reserve(chosen_.size());
    for (const ChosenPiece& chosen : chosen_) names.push_back(chosen.asked);
    return names;
  }

  void take_requests() {
    leave_out();
    const std::vector<std::string> names = asked_names();
    for (const std::string& text : options_.unfold) {
      const std::string place = drawing_.source + ": --unfold " + in_quotes(text);
      const NamedPiece named = named_piece(text, names, place);
      ChosenPiece& chosen = chosen_[named.piece];
      if (chosen.piece.fold) {
        throw Error(place, "is drawn with its fold, and unfolded by that", "leave the option out");
      }
      if (chosen.unfold) throw Error(place, "is to be unfolded twice", "a piece has one fold");
      chosen.unfold = named;
    }
    for (const std::string& text : options_.singles) {
      const std::string place = drawing_.source + ": --single " + in_quotes(text);
      const NamedPiece named = named_piece(text, names, place);
      ChosenPiece& chosen = chosen_[named.piece];
      if (named.edge >= 0) throw Error(place, "names an edge", "what is cut is a piece");
      if (!chosen.piece.pair) continue;
      chosen.piece.pair = false;
      chosen.by_shape = false;
      chosen.left = unique(text);
    }
    for (const std::string& text : options_.names) {
      const std::string place = drawing_.source + ": --name " + in_quotes(text);
      const std::size_t equals = text.rfind('=');
      if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
        throw Error(place, "names no piece and its new name", "write it as \"Detail_2=front\"");
      }
      const NamedPiece named = named_piece(text.substr(0, equals), names, place);
      if (named.edge >= 0) throw Error(place, "names an edge", "a name is a piece's");
      ChosenPiece& chosen = chosen_[named.piece];
      const std::string name = panel_name(text.substr(equals + 1));
      if (chosen.piece.pair) {
        chosen.left = unique("left_" + name);
        chosen.right = unique("right_" + name);
      } else {
        chosen.left = unique(name);
      }
    }
    for (const std::string& text : options_.pairs) {
      const std::string place = drawing_.source + ": --pair " + in_quotes(text);
      const NamedPiece named = named_piece(text, names, place);
      ChosenPiece& chosen = chosen_[named.piece];
      if (named.edge >= 0) throw Error(place, "names an edge", "a pair is a piece");
      if (chosen.piece.pair) continue;
      chosen.piece.pair = true;
      chosen.layers = false;
      chosen.piece.quantity = std::max(2, chosen.piece.quantity);
      chosen.right = unique("right_" + chosen.left);
      chosen.left = unique("left_" + chosen.left);
    }
  }

  /// Panels that a program wrote are kept finer, so that they come back as they were.
  EdgeOptions edge_options(const Piece& piece) const {
    EdgeOptions options = options_.edges;
    if (piece.is_panel) options.chord_error = std::min(options.chord_error, panel_chord_error);
    return options;
  }

  std::string place_of(const ChosenPiece& chosen) const {
    return drawing_.source + ": piece " + in_quotes(chosen.piece.name);
  }

  void stand_upright() {
    std::vector<PieceShape> shapes;
    shapes.reserve(chosen_.size());
    for (const ChosenPiece& chosen : chosen_) shapes.push_back(chosen.shape);
    const UprightTurns upright = upright_turns(shapes);
    has_grain_ = upright.has_grain;
    by_shape_ = upright.by_shape;
    std::string off_grain;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      chosen_[i].turned = upright.turns[i];
      chosen_[i].shape = turned_shape(shapes[i], upright.turns[i]);
      if (upright.off_grain[i]) off_grain += (off_grain.empty() ? " " : ", ") + chosen_[i].asked;
    }
    if (std::abs(upright.drawing) > to_radians(0.05)) {
      note(drawing_.source + ": turned by " + fixed_number(to_degrees(upright.drawing), 1) +
           " degrees, so that " +
           (has_grain_  ? "the grain of most of it is upright"
            : by_shape_ ? "its folds and mirror lines are upright"
                        : "its hems lie below") +
           (upright.end_by_shape ? "; shapes tell which end is up"
                                 : "; no shape tells which end is up"));
    }
    if (upright.nested) {
      note(drawing_.source +
           ": its pieces lie askew to each other; each is turned by its own shape");
    }
    if (!off_grain.empty()) {
      note(drawing_.source +
           ": cut on the bias or across the grain, and turned as the rest is:" + off_grain);
    }
  }

  /// Unfolds a piece as the drawing or the user says, or notes that it looks like a half. Says so
  /// in `panel`.
  void unfold(const ChosenPiece& chosen, const std::string& place, PieceShape& shape,
              ImportedPanel& panel) {
    if (shape.fold) {
      const PieceLine fold = *shape.fold;
      if (auto whole = unfolded_shape(shape, fold, place, remarks_)) {
        shape = std::move(*whole);
        panel.is_unfolded = true;
      }
      return;
    }
    if (!chosen.unfold && chosen.piece.pair) return;
    const EdgedOutline edges = edges_of(shape, options_.edges, place);
    const std::optional<int> likely = likely_fold(shape, edges);
    if (!chosen.unfold) {
      panel.likely_fold = likely;
      if (!likely) return;
      note(place + ": looks like a half, folded at edge " + std::to_string(*likely) +
           ", which is straight along the grain; if it is one, give --unfold " +
           shell_word(chosen.asked + ":" + std::to_string(*likely)));
      return;
    }
    const int edge = chosen.unfold->edge >= 0 ? chosen.unfold->edge : likely.value_or(-1);
    if (edge < 0) {
      throw Error(place, "--unfold finds no straight edge along its grain, with all of it beside",
                  "name the edge: --unfold " + shell_word(chosen.asked + ":EDGE"));
    }
    std::vector<Remark> none;
    auto whole = unfolded_shape(shape, fold_along(edges, edge, place), place, none);
    if (!whole) {
      throw Error(place, "lies on both sides of its edge " + std::to_string(edge),
                  "name the edge that lies on the fold");
    }
    shape = std::move(*whole);
    panel.is_unfolded = true;
  }

  void add(const ChosenPiece& chosen) {
    const Piece& piece = chosen.piece;
    const std::string place = place_of(chosen);
    if (chosen.layers) {
      note(place + ": is its own mirror image and cut " + std::to_string(piece.quantity) +
           " times: its layers are drawn as one panel; --pair " + shell_word(chosen.asked) +
           " makes a left and a right one");
    }
    if (chosen.by_shape) pairs_by_shape_ += (pairs_by_shape_.empty() ? " " : ", ") + chosen.asked;
    const bool takes_off = piece.is_cut_line && options_.seam_allowance;
    PieceShape shape = chosen.shape;
    // Sides that touch but for a rounding may cross since the piece was turned.
    if (first_crossing(shape.outline)) {
      throw Error(place, "its outline all but touches itself", "draw its sides apart");
    }
    ImportedPanel panel;
    panel.is_of_pair = piece.pair;
    unfold(chosen, place, shape, panel);
    if (takes_off) shape = without_allowance(shape, *options_.seam_allowance, place);
    if (!shape.grain && !is_ribbing(piece.material)) no_grain_ += piece.pair ? 2 : 1;
    if (!piece.pair) {
      panel.name = chosen.left;
      panel.quantity = piece.quantity;
      add(chosen, shape, place, std::move(panel));
      return;
    }
    // Of an uneven count, the one that is drawn is cut once more.
    const int mirrored = std::max(1, piece.quantity / 2);
    const bool right = piece.is_right_one;
    panel.name = right ? chosen.right : chosen.left;
    panel.quantity = std::max(1, piece.quantity - mirrored);
    add(chosen, shape, place, panel);
    panel.name = right ? chosen.left : chosen.right;
    panel.quantity = mirrored;
    add(chosen, mirrored_shape(shape), place, std::move(panel));
  }

  /// Adds a panel that has its name and quantity.
  void add(const ChosenPiece& chosen, const PieceShape& shape, const std::string& place,
           ImportedPanel panel) {
    const Piece& piece = chosen.piece;
    panel.asked = chosen.asked;
    panel.turned = chosen.turned;
    panel.piece = piece.name;
    panel.outline = edges_of(shape, edge_options(piece), place);
    if (panel.outline.far_notches > 0) {
      remarks_.push_back({true, place + ": " + std::to_string(panel.outline.far_notches) +
                                    " notches are more than 6 cm from its outline; left out"});
    }
    if (piece.is_panel && !piece.pair) {
      for (const PieceSeam& seam : piece.seams) {
        panel.seams.push_back(seam_side(turned_seam(seam, chosen.turned), panel.outline));
      }
      panel.is_of_pair = piece.side_unknown;
      panel.left_out = piece.left_out;
    }
    panel.internal_lines = shape.internal_lines;
    panel.cut_outs = shape.cut_outs;
    panel.drill_holes = shape.drill_holes;
    panel.area = signed_area(shape.outline);
    panel.is_symmetric = is_mirror_image(shape.outline, Vec2::UnitX()) ||
                         is_mirror_image(shape.outline, Vec2::UnitY());
    panel.material = piece.material;
    if (shape.grain) {
      const Vec2 warp = shape.grain->to - shape.grain->from;
      // A grain line has no direction: 90 degrees and -90 are one.
      double angle = std::atan2(warp.y(), warp.x()) - std::numbers::pi / 2;
      while (angle <= -std::numbers::pi / 2 + 1e-9) angle += std::numbers::pi;
      while (angle > std::numbers::pi / 2 + 1e-9) angle -= std::numbers::pi;
      panel.grain = angle;
    }
    if (is_ribbing(piece.material)) as_ribbing(panel);
    pattern_.panels.push_back(std::move(panel));
  }

  /// Ribbing stretches along the opening that it ends. Without a grain line its ribs, the warp of a
  /// knit, are taken across the longer side.
  void as_ribbing(ImportedPanel& panel) {
    panel.fabric = ribbing_fabric;
    ribbing_ += (ribbing_.empty() ? " " : ", ") + panel.name;
    if (panel.grain) return;
    const PanelBox box = panel_box(panel);
    const Vec2 size = box.high - box.low;
    panel.grain = size.x() >= size.y() ? 0 : std::numbers::pi / 2;
  }

  const PieceDrawing& drawing_;
  const ImportOptions& options_;
  std::vector<Remark>& remarks_;
  ImportedPattern pattern_;
  std::vector<ChosenPiece> chosen_;
  std::set<std::string> names_;
  bool has_grain_ = false;  ///< whether any piece has a grain line
  bool by_shape_ = false;   ///< none has, but shapes tell it
  int no_grain_ = 0;
  std::string pairs_by_shape_;
  std::string ribbing_;  ///< the panels that are cut of it
};

}  // namespace

ImportedPattern import_pieces(const PieceDrawing& drawing, const ImportOptions& options,
                              std::vector<Remark>& remarks) {
  if (options.size.empty()) return Importer(drawing, options, remarks).import();
  PieceDrawing complete = drawing;
  complete_size(complete, options.size, options.edges);
  return Importer(complete, options, remarks).import();
}

}  // namespace toile
