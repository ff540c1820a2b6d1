#include "pattern/import/svg_roles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "io/svg_style.h"

namespace toile {

namespace {

/// FreeSewing's classes of the materials that pieces are cut of.
constexpr std::array<std::string_view, 4> materials = {"fabric", "lining", "interfacing", "canvas"};

// Words in names, in English, German, French, Spanish, Italian and Dutch.
constexpr std::array<std::string_view, 8> grain_words = {"grain",      "fadenlauf",    "droit fil",
                                                         "droit-fil",  "droitfil",     "recto hilo",
                                                         "drittofilo", "draadrichting"};
constexpr std::array<std::string_view, 7> fold_words = {
    "fold", "stoffbruch", "im bruch", "pliure", "doblez", "piega", "stofvouw"};
constexpr std::array<std::string_view, 6> notch_words = {"notch",   "knips", "passzeichen",
                                                         "piquete", "tacca", "cran de"};
constexpr std::array<std::string_view, 3> cut_out_words = {"cut-out", "cutout", "cut out"};
constexpr std::array<std::string_view, 3> drill_words = {"drill", "bohrloch", "punch"};
constexpr std::array<std::string_view, 6> allowance_words = {"seam allowance", "seam-allowance",
                                                             "seam_allowance", "seamallowance",
                                                             "nahtzugabe",     "marge de couture"};

std::string lower_case(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

template <class Words>
bool has_word(const std::string& text, const Words& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

bool has(const std::vector<std::string>& classes, std::string_view name) {
  return std::find(classes.begin(), classes.end(), name) != classes.end();
}

bool is_straight(const SvgShape& shape) {
  return shape.paths.size() == 1 && shape.paths[0].segments.size() == 1 &&
         !shape.paths[0].segments[0].curved;
}

/// What the element says that a `use` draws.
SvgMeaning meaning_of_use(const SvgDrawing& drawing, const std::string& target) {
  const std::string name = lower_case(target);
  if (has_word(name, notch_words)) return {SvgRole::notch, "", ""};
  if (has_word(name, drill_words)) return {SvgRole::drill_hole, "", ""};
  // FreeSewing draws buttons, snaps and its logo by use, and never a piece.
  if (is_freesewing(drawing)) return {SvgRole::remark, "symbol " + target, ""};
  return {};
}

std::optional<SvgMeaning> meaning_by_class(const SvgDrawing& drawing, const SvgShape& shape) {
  const std::vector<std::string>& classes = shape.classes;
  if (is_freesewing(drawing) && has(classes, "hidden")) return SvgMeaning{SvgRole::unseen, "", ""};
  if (has(classes, "scalebox")) return SvgMeaning{SvgRole::remark, "scale box", ""};
  if (has(classes, "help")) return SvgMeaning{SvgRole::remark, "help line", ""};
  if (has(classes, "cut-out")) return SvgMeaning{SvgRole::cut_out, "", ""};
  std::string material;
  for (const std::string_view name : materials) {
    if (has(classes, name)) material = std::string(name);
  }
  if (has(classes, "sa")) return SvgMeaning{SvgRole::allowance, "", material};
  if (!material.empty()) return SvgMeaning{SvgRole::outline, "", material};
  return std::nullopt;
}

/// Letters and digits as words; a key such as "plugin-annotations:onFold" as "on fold".
std::vector<std::string> plain_words(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ':') {
      plain.erase(plain.find_last_of(" ,") + 1);
    } else if (std::isupper(byte) != 0 && !plain.empty() &&
               std::islower(static_cast<unsigned char>(plain.back())) != 0) {
      plain += ' ';
      plain += c;
    } else {
      plain += c;
    }
  }
  std::replace(plain.begin(), plain.end(), ',', ' ');
  return split_words(lower_case(plain));
}

/// "Denim" of "Cut 2 from Denim"; a key without its colon and in small letters.
std::string material_after_from(const std::string& text) {
  const bool is_key = text.find(':') != std::string::npos;
  std::string material;
  bool after = false;
  for (const std::string& word : is_key ? plain_words(text) : split_words(text)) {
    if (after) material += (material.empty() ? "" : " ") + word;
    after = after || lower_case(word) == "from";
  }
  // FreeSewing's name for what its class calls fabric.
  return lower_case(material) == "main fabric" ? "fabric" : material;
}

/// One line about cutting.
std::optional<CuttingText> read_cutting(const std::string& text) {
  const std::vector<std::string> words = plain_words(text);
  CuttingText cutting;
  bool found = false;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& number = words[i + 1];
    if (words[i] == "cut" && number.size() <= 2 &&
        std::all_of(number.begin(), number.end(),
                    [](unsigned char c) { return std::isdigit(c) != 0; })) {
      cutting.quantity.count = std::stoi(number);
      found = cutting.quantity.count > 0;
    }
  }
  if (!found) return std::nullopt;
  // Drafting programs say of each pair that it is mirrored.
  cutting.quantity.none_mirrored = true;
  cutting.material = material_after_from(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "mirrored") cutting.quantity = {cutting.quantity.count, true, false};
    const bool before = i > 0 && (words[i - 1] == "on" || words[i - 1] == "the");
    if (words[i] == "fold" && before) cutting.on_fold = true;
  }
  return cutting;
}

}  // namespace

bool is_freesewing(const SvgDrawing& drawing) {
  return std::any_of(drawing.namespaces.begin(), drawing.namespaces.end(),
                     [](const std::string& name) {
                       return name.find("freesewing.org/namespaces") != std::string::npos;
                     });
}

int freesewing_part(const SvgDrawing& drawing, int group) {
  while (group >= 0) {
    const SvgGroup& one = drawing.groups[static_cast<std::size_t>(group)];
    if (one.id.find("-part-") != std::string::npos) return group;
    group = one.parent;
  }
  return -1;
}

std::string freesewing_part_name(const SvgGroup& part) {
  std::string name = part.id.substr(part.id.rfind("-part-") + 6);
  return name.substr(name.rfind('.') + 1);
}

bool is_freesewing_mark(const SvgShape& shape) {
  return has(shape.classes, "mark") || has(shape.classes, "note");
}

SvgMeaning meaning_of(const SvgDrawing& drawing, const SvgShape& shape) {
  if (shape.use >= 0) {
    const SvgUse& use = drawing.uses[static_cast<std::size_t>(shape.use)];
    SvgMeaning meaning = meaning_of_use(drawing, use.target);
    if (meaning.role != SvgRole::unknown) return meaning;
  }
  if (const auto meaning = meaning_by_class(drawing, shape)) return *meaning;
  const std::string markers = lower_case(shape.marker_start + " " + shape.marker_end);
  if (markers.find("cutonfold") != std::string::npos) return {SvgRole::fold, "", ""};
  if (markers.find("grain") != std::string::npos) return {SvgRole::grain, "", ""};
  if (markers.find("dimension") != std::string::npos) return {SvgRole::remark, "dimension", ""};
  // A line with a head is the grain's, when nothing says otherwise.
  if (is_straight(shape) && markers.find("arrow") != std::string::npos) {
    return {SvgRole::grain, "", ""};
  }
  std::string own = shape.label + " " + shape.title + " " + shape.id;
  const bool closed = std::all_of(shape.paths.begin(), shape.paths.end(),
                                  [](const DrawnPath& path) { return path.closed; });
  // A layer of notches says what its lines are; what it says of outlines is their piece's name.
  if (!closed && shape.group >= 0) {
    const SvgGroup& group = drawing.groups[static_cast<std::size_t>(shape.group)];
    own += " " + group.label + " " + group.title;
  }
  own = lower_case(own);
  if (has_word(own, notch_words)) return {SvgRole::notch, "", ""};
  if (closed) {
    if (has_word(own, drill_words)) return {SvgRole::drill_hole, "", ""};
    if (has_word(own, cut_out_words)) return {SvgRole::cut_out, "", ""};
    if (has_word(own, allowance_words)) return {SvgRole::allowance, "", ""};
  } else {
    if (has_word(own, grain_words)) return {SvgRole::grain, "", ""};
    if (has_word(own, fold_words)) return {SvgRole::fold, "", ""};
  }
  return {};
}

std::vector<CuttingText> read_cuttings(const std::string& text) {
  const std::string small = lower_case(text);
  std::vector<std::size_t> starts = {0};
  for (std::size_t at = small.find("cut"); at != std::string::npos;
       at = small.find("cut", at + 1)) {
    const bool is_word = at == 0 || std::isalpha(static_cast<unsigned char>(small[at - 1])) == 0;
    const std::size_t next = small.find_first_not_of(" ,", at + 3);
    if (is_word && next != std::string::npos && next > at + 3 &&
        std::isdigit(static_cast<unsigned char>(small[next])) != 0) {
      starts.push_back(at);
    }
  }
  starts.push_back(text.size());
  std::vector<CuttingText> cuttings;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    // The first part ends before the first "cut", and says nothing.
    const auto one = read_cutting(text.substr(starts[i], starts[i + 1] - starts[i]));
    if (one) cuttings.push_back(*one);
  }
  return cuttings;
}

bool is_automatic_id(const std::string& id) {
  static constexpr std::array<std::string_view, 13> stems = {
      "path", "rect", "circle", "ellipse", "line", "polyline", "polygon",
      "g",    "use",  "layer",  "shape",   "svg",  "fs-"};
  const std::string small = lower_case(id);
  return small.empty() || std::any_of(stems.begin(), stems.end(), [&](std::string_view stem) {
           return small.starts_with(stem) &&
                  small.find_first_not_of("0123456789-_", stem.size()) == std::string::npos;
         });
}

}  // namespace toile
