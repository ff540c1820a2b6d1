#include "tools/try/taken.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "io/text.h"
#include "pattern/import/half_pieces.h"

namespace toile {

namespace {

/// "a, b, c", each once, in the order given.
class WordList {
 public:
  explicit WordList(std::string between = ", ") : between_(std::move(between)) {}
  void add(const std::string& word) {
    if (!words_.insert(word).second) return;
    text_ += (text_.empty() ? "" : between_) + word;
  }
  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

 private:
  std::string between_;
  std::set<std::string> words_;
  std::string text_;
};

/// Parts of a sentence that have something to say, or else `nothing`.
std::string joined(const std::vector<std::string>& parts, const std::string& nothing) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  }
  return text.empty() ? nothing : text;
}

std::string said(const WordList& words, const std::string& before, const std::string& after) {
  return words.empty() ? "" : before + words.text() + after;
}

Taken unit_of(const ImportEnd& imported) {
  if (imported.drawing.pieces.empty()) return {"unit", "as the pattern states", "its JSON"};
  double longest = 0;
  for (const ImportedPanel& panel : imported.pattern.panels) {
    const std::vector<Vec2>& vertices = panel.outline.vertices;
    const auto [low, high] = std::ranges::minmax(vertices, {}, [](const Vec2& v) { return v.y(); });
    longest = std::max(longest, high.y() - low.y());
  }
  return {"unit",
          shown_text(imported.drawing.unit) + ": the longest panel is " +
              fixed_number(100 * longest, 0) + " cm long",
          "--unit mm, cm or in"};
}

Taken grain_of(const ImportEnd& imported) {
  WordList without;
  bool has_grain = false;
  double turned = 0;
  for (const ImportedPanel& panel : imported.pattern.panels) {
    has_grain = has_grain || panel.grain;
    if (!panel.grain) without.add(panel.name);
    if (std::abs(panel.turned) > std::abs(turned)) turned = panel.turned;
  }
  std::string taken = has_grain ? "upright, as drawn" : "";
  if (!has_grain && !without.empty()) taken = "drawn in no piece: as their shapes tell it";
  if (has_grain) taken += said(without, "; without a line, as most: ", "");
  if (taken.empty()) taken = "as the pattern states";
  if (const double degrees = turned * 180 / std::numbers::pi; std::abs(degrees) > 0.05) {
    taken += "; pieces are turned by up to " + fixed_number(std::abs(degrees), 0) + " degrees";
  }
  return {"grain", taken, "a grain line drawn in the piece"};
}

Taken halves_of(const ImportEnd& imported) {
  WordList unfolded, whole, options(" ");  // options as a shell takes them
  for (const ImportedPanel& panel : imported.pattern.panels) {
    if (panel.is_unfolded) {
      unfolded.add(panel.asked);
      if (imported.is_half_garment) options.add("--single " + shell_word(panel.asked));
    }
    if (!panel.likely_fold) continue;
    whole.add(panel.asked);
    options.add("--unfold " + shell_word(panel.asked + ":" + std::to_string(*panel.likely_fold)));
  }
  return {"halves",
          joined({said(unfolded, "",
                       imported.is_half_garment ? " unfolded, for half a garment seems to be drawn"
                                                : " unfolded"),
                  said(whole, "", " taken as whole, with a straight edge like a fold's")},
                 "none"),
          options.empty() ? "--unfold PIECE:EDGE" : options.text()};
}

Taken pairs_of(const ImportEnd& imported) {
  WordList pairs, single, options(" ");
  for (const ImportedPanel& panel : imported.pattern.panels) {
    if (panel.is_of_pair) {
      pairs.add(panel.asked);
    } else if (panel.quantity > 1) {
      single.add(panel.asked);
      options.add("--pair " + shell_word(panel.asked));
    }
  }
  return {"pairs",
          joined({said(pairs, "", " left and right"),
                  said(single, "", " cut several times, taken as one panel")},
                 "none"),
          options.empty() ? (pairs.empty() ? "--pair PIECE" : "--single PIECE") : options.text()};
}

Taken spare_pieces_of(const ImportEnd& imported, const FindSeamsEnd& seams,
                      const std::vector<LeftOut>& aside) {
  WordList broken, beside, loose, options(" ");
  for (const LeftOutPiece& piece : imported.pattern.left_out) broken.add(shown_text(piece.name));
  for (const LeftOut& panel : seams.left_out) {
    beside.add(panel.name + " (" + panel.kind + ")");
    options.add("--with " + shell_word(panel.name));
  }
  for (const LeftOut& panel : aside) loose.add(panel.name);
  return {"spare_pieces",
          joined({said(beside, "", " left out"),
                  said(loose, "", " sewn to nothing of the rest, laid aside"),
                  said(broken, "", " can't be panels, the warnings say why")},
                 "none"),
          joined({options.text(), loose.empty() ? "" : "a seam that holds them, as below"},
                 "--without PIECE")};
}

Taken undecided_of(const FindSeamsEnd& seams, const std::string& edit_seams) {
  if (seams.undecided.empty()) return {"undecided_seams", "none", edit_seams};
  WordList names;
  double least = 1;
  for (const UndecidedSeam& seam : seams.undecided) {
    // Rounded down: as an option, the number takes the seam in.
    const double confidence = std::floor(100 * seam.confidence) / 100;
    names.add(seam.name + " (" + fixed_number(confidence, 2) + ")");
    least = std::min(least, confidence);
  }
  return {"undecided_seams", names.text() + " not sewn",
          "--sew " + shell_word(seams.undecided.front().name) + " for one, --min-confidence " +
              fixed_number(least, 2) + " for all, or " + edit_seams};
}

}  // namespace

std::vector<Taken> taken_for_granted(const ImportEnd& imported, const FindSeamsEnd& seams,
                                     const std::vector<LeftOut>& aside,
                                     const std::string& edit_seams) {
  return {unit_of(imported),
          grain_of(imported),
          halves_of(imported),
          pairs_of(imported),
          spare_pieces_of(imported, seams, aside),
          undecided_of(seams, edit_seams)};
}

std::string line_of(const Taken& taken) {
  std::string what = taken.what;
  std::ranges::replace(what, '_', ' ');
  return what + ": " + taken.taken + "; to change: " + taken.change;
}

}  // namespace toile
