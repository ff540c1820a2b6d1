#include "pattern/seams/panel_words.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>

namespace toile {

namespace {

struct RoleWords {
  PanelRole role;
  std::initializer_list<std::string_view> beginnings;  ///< of a word
};

/// English, German, French, Spanish, Italian. The first role that fits counts, so what is sewn onto
/// a piece stands before the piece: a sleeve's cuff is a cuff. Accents are left out, ä is a.
const RoleWords role_words[] = {
    {PanelRole::cuff, {"cuff", "manschette", "poignet", "puno", "polsin", "bundchen"}},
    {PanelRole::facing, {"facing", "beleg", "parementure", "vista", "paramontura", "ripiego"}},
    {PanelRole::pocket, {"pocket", "tasche", "poche", "bolsillo", "tasca"}},
    {PanelRole::hood, {"hood", "kapuze", "capuch", "capucha", "cappuccio"}},
    {PanelRole::collar, {"collar", "kragen", "col", "cuello", "colletto", "lapel", "revers"}},
    {PanelRole::waistband,
     {"waistband", "wb", "belt", "bund", "ceinture", "pretina", "cinturilla", "cintur", "cinta"}},
    {PanelRole::yoke, {"yoke", "passe", "sattel", "empiecement", "canesu", "sprone", "carre"}},
    {PanelRole::sleeve, {"sleeve", "armel", "aermel", "manche", "manga", "manica"}},
    {PanelRole::skirt, {"skirt", "rock", "jupe", "falda", "gonna", "godet"}},
    {PanelRole::trousers,
     {"trouser", "pant", "jean", "short", "leg", "hose", "bein", "pantalon", "jambe", "pierna",
      "calzon", "gamba"}},
    {PanelRole::bodice, {"torso",    "ftorso", "btorso",   "bodice",  "top",     "shirt",  "blouse",
                         "oberteil", "mieder", "leib",     "hemd",    "corsage", "buste",  "cuerpo",
                         "corpino",  "busto",  "corpetto", "chemise", "camisa",  "camicia"}},
};

struct KindWords {
  std::string_view kind;
  std::initializer_list<std::string_view> beginnings;  ///< of a word
};

/// English, German, French, Spanish, Italian, as above. A facing is sewn to its edge, and is none
/// of these; a pocket's facing is of the pocket.
const KindWords beside_shell_words[] = {
    {"pocket", {"pocket", "tasche", "poche", "bolsillo", "tasca", "welt", "flap"}},
    {"interfacing",
     {"interfacing", "interlining", "fusible", "canvas", "einlage", "vlies", "entoilage",
      "thermocollant", "entretela", "teletta", "fliselina", "backstay"}},
    {"lining", {"lining", "futter", "doublure", "forro", "fodera"}},
    {"placket",
     {"placket", "fly", "knopfleiste", "untertritt", "ubertritt", "uebertritt", "schlitzbesatz",
      "braguette", "boutonnage", "bragueta", "tapeta", "abbottonatura"}},
    {"binding",
     {"binding", "piping", "einfass", "paspel", "schragband", "schraegband", "passepoil", "ribete",
      "bordino"}},
    {"loop", {"loop", "schlaufe", "passant", "trabilla", "presilla"}},
};

/// A strip cut on the bias, if nothing else is said: a skirt may be as well.
const std::initializer_list<std::string_view> bias_words = {"bias", "biais", "bies", "sesgo",
                                                            "sbieco"};

const std::initializer_list<std::string_view> ribbing_words = {
    "rib",       "ribs", "ribbing",  "ribbed", "ribknit", "bundchen",
    "buendchen", "ripp", "bordcote", "canale", "costina"};

const std::initializer_list<std::string_view> left_words = {
    "left",      "links", "linke",    "linker",   "linkes", "gauche", "izquierda",
    "izquierdo", "izq",   "sinistra", "sinistro", "sx",     "l"};
const std::initializer_list<std::string_view> right_words = {
    "right",   "rechts",  "rechte", "rechter", "rechtes", "droit", "droite",
    "derecha", "derecho", "der",    "destra",  "destro",  "dx",    "r"};
const std::initializer_list<std::string_view> front_words = {
    "front",      "ftorso",    "vorne", "vorder",    "vorderteil", "vorderhose",
    "vorderrock", "devant",    "avant", "delantero", "delantera",  "delante",
    "davanti",    "anteriore", "f",     "fr"};
const std::initializer_list<std::string_view> back_words = {
    "back",        "btorso",     "hinten",     "hinter",     "hinterteil", "ruckenteil", "rucken",
    "rueckenteil", "hinterhose", "hinterrock", "dos",        "arriere",    "espalda",    "trasero",
    "trasera",     "detras",     "dietro",     "posteriore", "schiena",    "b",          "bk"};

/// The letter without its accent, of the two-byte letters of UTF-8 that begin with C3.
char plain_letter(unsigned char second) {
  static constexpr std::string_view plain =
      "aaaaaaaceeeeiiiidnooooo ouuuuy saaaaaaaceeeeiiiidnooooo ouuuuy y";
  return second >= 0x80 && second < 0xC0 ? plain[second - 0x80] : ' ';
}

struct Word {
  std::string text;
  bool number = false;
};

/// Runs of letters in small letters without accents, cut where a capital follows a small letter,
/// and runs of digits.
std::vector<Word> split(const std::string& name) {
  std::vector<Word> words;
  enum class Kind { none, letter, digit } last = Kind::none;
  bool was_small = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    auto c = static_cast<unsigned char>(name[i]);
    bool capital = std::isupper(c) != 0;
    if (c == 0xC3 && i + 1 < name.size()) {
      const auto second = static_cast<unsigned char>(name[++i]);
      capital = second < 0xA0;
      c = static_cast<unsigned char>(plain_letter(second));
    }
    const Kind kind = std::isalpha(c) != 0   ? Kind::letter
                      : std::isdigit(c) != 0 ? Kind::digit
                                             : Kind::none;
    if (kind != Kind::none) {
      if (kind != last || (kind == Kind::letter && was_small && capital)) {
        words.push_back({"", kind == Kind::digit});
      }
      words.back().text += static_cast<char>(std::tolower(c));
    }
    last = kind;
    was_small = kind == Kind::letter && !capital;
  }
  return words;
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Whether one of the words is one of the list.
bool any_fits(const std::vector<Word>& words, std::initializer_list<std::string_view> beginnings) {
  for (const Word& word : words) {
    for (const std::string_view beginning : beginnings) {
      // German joins words: Vorderhose, Hemdkragen. Short beginnings would be found anywhere.
      const bool fits = beginning.size() < 4 ? word.text == beginning
                        : beginning.size() < 5
                            ? word.text.starts_with(beginning) || word.text.ends_with(beginning)
                            : word.text.find(beginning) != std::string::npos;
      if (fits) return true;
    }
  }
  return false;
}

PanelRole role_by(const std::vector<Word>& words) {
  for (const RoleWords& entry : role_words) {
    if (any_fits(words, entry.beginnings)) return entry.role;
  }
  return PanelRole::unknown;
}

}  // namespace

PanelWords words_of(const PatternPanel& panel) {
  const std::vector<Word> words = split(panel.name);
  PanelWords found;
  found.role = role_by(words);
  for (const Word& word : words) {
    if (word.number) {
      found.number = word.text.size() < 6 ? std::stoi(word.text) : -1;
      found.whole += word.text + " ";
      continue;
    }
    const bool left = is_one_of(word.text, left_words);
    const bool right = is_one_of(word.text, right_words);
    const bool front = is_one_of(word.text, front_words) || word.text.starts_with("vorder");
    const bool back = is_one_of(word.text, back_words) || word.text.starts_with("hinter");
    if (found.side == 0) found.side = left ? 1 : right ? -1 : 0;
    if (found.face == 0) found.face = front ? 1 : back ? -1 : 0;
    if (!left && !right) found.whole += word.text + " ";
    if (!left && !right && !front && !back) found.stem += word.text + " ";
  }
  if (found.role == PanelRole::unknown) {
    if (panel.part.ends_with("_arm") || panel.label == "arm") found.role = PanelRole::sleeve;
    if (panel.part.ends_with("_leg")) found.role = PanelRole::trousers;
    if (panel.part == "head") found.role = PanelRole::hood;
  }
  return found;
}

bool is_ribbing(const std::string& material) {
  const std::vector<Word> words = split(material);
  if (any_fits(words, ribbing_words)) return true;
  // "bord-côte": without the border, a côté is a side.
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].text.starts_with("bord") && words[i + 1].text.starts_with("cote")) return true;
  }
  return false;
}

std::string kind_beside_shell(const PatternPanel& panel) {
  const std::vector<Word> words = split(panel.name);
  for (const KindWords& entry : beside_shell_words) {
    if (any_fits(words, entry.beginnings)) return std::string(entry.kind);
  }
  if (role_by(words) == PanelRole::unknown && any_fits(words, bias_words)) return "binding";
  // "fabric cut 2 from interfacing" is of fabric: what is named first counts.
  const std::vector<Word> material = split(panel.material.substr(0, panel.material.find(' ')));
  for (const KindWords& entry : beside_shell_words) {
    const bool is_cloth = entry.kind == "lining" || entry.kind == "interfacing";
    if (is_cloth && any_fits(material, entry.beginnings)) return std::string(entry.kind);
  }
  return "";
}

}  // namespace toile
