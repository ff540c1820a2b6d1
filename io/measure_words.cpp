#include "io/measure_words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace toile {

namespace {

struct Word {
  std::string_view word;
  std::string_view name;
  double factor = 1;
};

// How each is taken: docs/your-body.md.
constexpr std::array known_words = {
    Word{"stature", "height"},
    Word{"body_height", "height"},
    Word{"koerpergroesse", "height"},
    Word{"koerperhoehe", "height"},
    Word{"groesse", "height"},
    Word{"hauteur", "height"},
    Word{"hauteur_totale", "height"},
    Word{"poitrine", "bust"},
    Word{"oberweite", "bust"},
    Word{"brust", "bust"},
    Word{"under_bust", "underbust"},
    Word{"band", "underbust"},
    Word{"unterbrust", "underbust"},
    Word{"sous_poitrine", "underbust"},
    Word{"natural_waist", "waist"},
    Word{"taille", "waist"},
    Word{"taillen", "waist"},
    Word{"high_hip", "abdomen"},
    Word{"belly", "abdomen"},
    Word{"bauch", "abdomen"},
    Word{"ventre", "abdomen"},
    Word{"hips", "hip"},
    Word{"seat", "hip"},
    Word{"huefte", "hip"},
    Word{"hueft", "hip"},
    Word{"gesaess", "hip"},
    Word{"hanches", "hip"},
    Word{"bassin", "hip"},
    Word{"collar", "neck"},
    Word{"collar_size", "neck"},
    Word{"hals", "neck"},
    Word{"cou", "neck"},
    Word{"encolure", "neck"},
    Word{"neck_circ", "neck"},
    Word{"hat_size", "head"},
    Word{"kopf", "head"},
    Word{"tete", "head"},
    Word{"shoulder", "shoulder_length"},
    Word{"shoulder_seam", "shoulder_length"},
    Word{"schulterbreite", "shoulder_length"},
    Word{"schulterlaenge", "shoulder_length"},
    Word{"longueur_epaule", "shoulder_length"},
    Word{"longueur_d'epaule", "shoulder_length"},
    Word{"shoulders", "shoulder_width"},
    Word{"shoulder_breadth", "shoulder_width"},
    Word{"shoulder_to_shoulder", "shoulder_width"},
    Word{"cross_shoulder", "shoulder_width"},
    Word{"sleeve", "arm_length"},
    Word{"sleeve_length", "arm_length"},
    Word{"armlaenge", "arm_length"},
    Word{"aermellaenge", "arm_length"},
    Word{"longueur_bras", "arm_length"},
    Word{"longueur_de_bras", "arm_length"},
    Word{"longueur_de_manche", "arm_length"},
    Word{"bicep", "upper_arm"},
    Word{"biceps", "upper_arm"},
    Word{"arm", "upper_arm"},
    Word{"oberarm", "upper_arm"},
    Word{"bras", "upper_arm"},
    Word{"ellbogen", "elbow"},
    Word{"coude", "elbow"},
    Word{"unterarm", "forearm"},
    Word{"avant_bras", "forearm"},
    Word{"handgelenk", "wrist"},
    Word{"handgelenks", "wrist"},
    Word{"poignet", "wrist"},
    Word{"thigh", "upper_thigh"},
    Word{"upper_leg", "upper_thigh"},
    Word{"oberschenkel", "upper_thigh"},
    Word{"cuisse", "upper_thigh"},
    Word{"knie", "knee"},
    Word{"genou", "knee"},
    Word{"wade", "calf"},
    Word{"waden", "calf"},
    Word{"mollet", "calf"},
    Word{"fessel", "ankle"},
    Word{"knoechel", "ankle"},
    Word{"cheville", "ankle"},
    Word{"inseam", "inside_leg"},
    Word{"inner_leg", "inside_leg"},
    Word{"inside_leg_length", "inside_leg"},
    Word{"schrittlaenge", "inside_leg"},
    Word{"innenbeinlaenge", "inside_leg"},
    Word{"entrejambe", "inside_leg"},
    Word{"outseam", "waist_to_floor"},
    Word{"outside_leg", "waist_to_floor"},
    Word{"seitenlaenge", "waist_to_floor"},
    Word{"rise", "crotch_depth"},
    Word{"body_rise", "crotch_depth"},
    Word{"sitzhoehe", "crotch_depth"},
    Word{"leibhoehe", "crotch_depth"},
    Word{"montant", "crotch_depth"},
    Word{"crotch", "crotch_length"},
    Word{"total_rise", "crotch_length"},
    Word{"enfourchure", "crotch_length"},
    Word{"back_length", "back_centre_length"},
    Word{"back_waist_length", "back_centre_length"},
    Word{"nape_to_waist", "back_centre_length"},
    Word{"rueckenlaenge", "back_centre_length"},
    Word{"longueur_dos", "back_centre_length"},
    Word{"nape_height", "cervicale_height"},
    Word{"hip_depth", "waist_to_hip"},
    Word{"huefttiefe", "waist_to_hip"},
    Word{"bust_points", "bust_span"},
    Word{"bust_point_distance", "bust_span"},
    Word{"apex_to_apex", "bust_span"},
    Word{"brustpunktabstand", "bust_span"},
    Word{"brustabstand", "bust_span"},
    Word{"ecart_de_poitrine", "bust_span"},
    Word{"brusttiefe", "bust_depth"},
    Word{"back_width", "across_back", 2},
    Word{"cross_back", "across_back", 2},
    Word{"rueckenbreite", "across_back", 2},
    Word{"carrure_dos", "across_back", 2},
    Word{"chest_width", "across_chest", 2},
    Word{"carrure_devant", "across_chest", 2},
};

/// Lower case, blanks as underscores, no accents.
std::string plain_word(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 18> letters = {{
      {"ä", "ae"},
      {"ö", "oe"},
      {"ü", "ue"},
      {"Ä", "ae"},
      {"Ö", "oe"},
      {"Ü", "ue"},
      {"ß", "ss"},
      {"é", "e"},
      {"è", "e"},
      {"ê", "e"},
      {"É", "e"},
      {"È", "e"},
      {"Ê", "e"},
      {"ç", "c"},
      {"à", "a"},
      {"â", "a"},
      {"î", "i"},
      {"’", "'"},
  }};
  std::string text;
  while (!word.empty()) {
    const auto accent = std::ranges::find_if(
        letters, [&](const auto& letter) { return word.starts_with(letter.first); });
    if (accent != letters.end()) {
      text += accent->second;
      word.remove_prefix(accent->first.size());
      continue;
    }
    char c = word.front();
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    text += c == ' ' || c == '-' ? '_' : c;
    word.remove_prefix(1);
  }
  return text;
}

/// "Brustumfang", "tour de taille", "hip girth": what is gone around.
std::string_view without_girth(std::string_view word) {
  for (const std::string_view before : {"tour_de_", "tour_du_", "tour_d'", "tour_"}) {
    if (word.starts_with(before)) return word.substr(before.size());
  }
  for (const std::string_view after :
       {"_girth", "_circumference", "_circ", "_round", "umfang", "_measurement"}) {
    if (word.size() > after.size() && word.ends_with(after)) {
      return word.substr(0, word.size() - after.size());
    }
  }
  return word;
}

std::optional<MeasureTerm> term_of(std::string_view word) {
  if (const MeasureName* name = find_measure_name(word)) return MeasureTerm{name->name, 1};
  const auto known = std::ranges::find(known_words, word, &Word::word);
  if (known == known_words.end()) return std::nullopt;
  return MeasureTerm{known->name, known->factor};
}

/// The one measure that a program has under this name; none of a sum.
std::optional<MeasureTerm> of_program(std::string_view word) {
  for (const DraftingProgram program :
       {DraftingProgram::valentina, DraftingProgram::freesewing, DraftingProgram::garmentcode}) {
    const std::vector<ForeignMeasure>& all = foreign_measures(program);
    const auto found = std::ranges::find(all, word, &ForeignMeasure::name);
    if (found != all.end() && found->terms.size() == 1) return found->terms.front();
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeasureWord> measure_of_word(std::string_view word) {
  const std::string text = plain_word(word);
  std::string_view bare = text;
  MeasureWord found;
  for (const std::string_view side : {"left_", "right_"}) {
    if (!bare.starts_with(side)) continue;
    found.side = side;
    bare.remove_prefix(side.size());
  }
  std::optional<MeasureTerm> term = term_of(bare);
  if (!term) term = of_program(word);
  if (!term) term = term_of(without_girth(bare));
  if (!term) return std::nullopt;
  if (!found.side.empty() && !find_measure_name(term->name)->is_sided) return std::nullopt;
  found.measure = *term;
  return found;
}

}  // namespace toile
