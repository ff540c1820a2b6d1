#include "pattern/classify/panel_name.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "pattern/classify/name_words.h"

namespace toile {

namespace {

struct RoleWords {
  PanelRole role;
  std::initializer_list<std::string_view> beginnings;  ///< of a word
};

/// English, German, French, Spanish, Italian, in the order of PanelName::roles. Accents are left
/// out, ä is a.
const RoleWords role_words[] = {
    {PanelRole::cuff, {"cuff", "manschette", "poignet", "puno", "polsin", "bundchen"}},
    {PanelRole::facing, {"facing", "beleg", "parementure", "vista", "paramontura", "ripiego"}},
    {PanelRole::pocket, {"pocket", "tasche", "poche", "bolsillo", "tasca"}},
    {PanelRole::hood, {"hood", "kapuze", "capuch", "capucha", "cappuccio"}},
    {PanelRole::collar,
     {"collar", "kragen", "col", "turtle", "cuello", "colletto", "lapel", "revers"}},
    {PanelRole::waistband,
     {"waistband", "wb", "belt", "bund", "ceinture", "pretina", "cinturilla", "cintur", "cinta"}},
    {PanelRole::yoke, {"yoke", "passe", "sattel", "empiecement", "canesu", "sprone", "carre"}},
    {PanelRole::sleeve, {"sleeve", "sl", "armel", "aermel", "manche", "manga", "manica"}},
    {PanelRole::skirt, {"skirt", "rock", "jupe", "falda", "gonna", "godet"}},
    {PanelRole::trousers,
     {"trouser", "pant", "jean", "shorts", "leg", "legs", "hose", "bein", "pantalon", "jambe",
      "pierna", "calzon", "gamba"}},
    {PanelRole::bodice, {"torso",    "ftorso", "btorso",   "bodice",  "top",     "shirt",  "blouse",
                         "oberteil", "mieder", "leib",     "hemd",    "corsage", "buste",  "cuerpo",
                         "corpino",  "busto",  "corpetto", "chemise", "camisa",  "camicia"}},
};

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

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// +1 left, -1 right, 0 neither.
int side_in(const std::string& word) {
  return is_one_of(word, left_words) ? 1 : is_one_of(word, right_words) ? -1 : 0;
}

/// +1 front, -1 back, 0 neither.
int face_in(const std::string& word) {
  if (is_one_of(word, front_words) || word.starts_with("vorder")) return 1;
  return is_one_of(word, back_words) || word.starts_with("hinter") ? -1 : 0;
}

}  // namespace

bool PanelName::says(PanelRole role) const { return std::ranges::find(roles, role) != roles.end(); }

PanelName read_panel_name(const std::string& name) {
  const std::vector<NameWord> words = words_in(name);
  PanelName found;
  for (const RoleWords& entry : role_words) {
    if (any_fits(words, entry.beginnings)) found.roles.push_back(entry.role);
  }
  // A letter says a side or a face beside a word that says what the panel is: "pant_b_l", not
  // "K-B2".
  const bool letters_tell =
      !found.roles.empty() || std::ranges::any_of(words, [](const auto& word) {
        return word.text.size() > 1 && (side_in(word.text) != 0 || face_in(word.text) != 0);
      });
  for (const NameWord& word : words) {
    if (word.number) {
      found.number = word.text.size() < 6 ? std::stoi(word.text) : -1;
      found.whole += word.text + " ";
      continue;
    }
    const bool tells = word.text.size() > 1 || letters_tell;
    const int side = tells ? side_in(word.text) : 0;
    const int face = tells ? face_in(word.text) : 0;
    if (found.side == 0) found.side = side;
    if (found.face == 0) found.face = face;
    if (side == 0) found.whole += word.text + " ";
    if (side == 0 && face == 0) found.stem += word.text + " ";
  }
  return found;
}

}  // namespace toile
