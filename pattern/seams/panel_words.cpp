#include "pattern/seams/panel_words.h"

#include <initializer_list>
#include <string_view>

#include "pattern/classify/classify.h"
#include "pattern/classify/name_words.h"

namespace toile {

namespace {

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

}  // namespace

PanelWords words_of(const PatternPanel& panel) {
  PanelWords words{read_panel_name(panel.name)};
  words.role = classify(witnesses_of(panel)).role;
  return words;
}

bool is_ribbing(const std::string& material) {
  const std::vector<NameWord> words = words_in(material);
  if (any_fits(words, ribbing_words)) return true;
  // "bord-côte": without the border, a côté is a side.
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].text.starts_with("bord") && words[i + 1].text.starts_with("cote")) return true;
  }
  return false;
}

std::string kind_beside_shell(const PatternPanel& panel) {
  const std::vector<NameWord> words = words_in(panel.name);
  for (const KindWords& entry : beside_shell_words) {
    if (any_fits(words, entry.beginnings)) return std::string(entry.kind);
  }
  if (read_panel_name(panel.name).roles.empty() && any_fits(words, bias_words)) return "binding";
  // "fabric cut 2 from interfacing" is of fabric: what is named first counts.
  const std::vector<NameWord> material =
      words_in(panel.material.substr(0, panel.material.find(' ')));
  for (const KindWords& entry : beside_shell_words) {
    const bool is_cloth = entry.kind == "lining" || entry.kind == "interfacing";
    if (is_cloth && any_fits(material, entry.beginnings)) return std::string(entry.kind);
  }
  return "";
}

}  // namespace toile
