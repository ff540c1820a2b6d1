#include "pattern/seams/seam_weights.h"

namespace toile {

namespace {

struct Row {
  const char* name;  // of the measure
  double weight;
};

/// Fitted by bench_fit_seam_weights, but for the notches: its garments have none. With half of
/// these weights the sleeves of FreeSewing's T-shirt are sewn in one notch too far; double changes
/// nothing.
constexpr Row rows[] = {
    {"seam", -0.677},
    {"equal_length", -1.056},
    {"rare_length", 0.855},
    {"close_length", 1.925},
    {"near_length", 0.730},
    {"log_ratio", -1.011},
    {"curve", 0.575},
    {"coincide", 1.553},
    {"coincide_curved", -0.470},
    {"halves", -1.691},
    {"halves_concave", 2.000},
    {"folded_over", 0.000},
    {"across_grain", -2.163},
    {"curve_gathered", 0.206},
    {"grains_differ", -0.184},
    {"up_and_down", 0.590},
    {"both_up", 0.270},
    {"both_down", -2.736},
    {"rise_together", 0.348},
    {"rise_apart", -1.023},
    {"same_panel", -4.331},
    {"dart", 1.739},
    {"dart_upwards", 0.000},
    {"slit", -4.000},
    {"ends_differ", 0.500},
    {"ends_alike", -0.500},
    {"concave", -3.985},
    {"roles_agree", 0.262},
    {"sides_differ", -2.137},
    {"faces_agree", 0.081},
    {"faces_differ", -3.813},
    {"numbers_follow", 0.187},
    {"numbers_apart", -0.464},
    {"words_alike", 0.996},
    {"named_halves", -0.519},
    {"front_and_back", 0.568},
    {"numbers_differ", -1.875},
    {"first_number", 1.855},
    {"later_number", -1.577},
    {"cone", -2.000},
    {"dart_tip", 1.339},
    {"two_inside", 3.595},
    {"two_inside_off", -5.057},
    {"three_inside", 5.940},
    {"three_inside_off", -4.748},
    {"four_inside", 3.869},
    {"four_inside_off", 0.082},
    {"more_inside", -0.152},
    {"more_inside_off", -1.697},
    {"notches_meet", 2.000},
    {"notch_alone", -1.000},
    {"junction_off", -4.402},
    {"smooth_border", 0.425},
    {"lone_corner", -0.185},
    {"notch_in_border", 2.568},
    {"two_at_border", 0.778},
    {"two_at_border_off", 0.233},
    {"more_at_border", 0.472},
    {"more_at_border_off", -2.012},
    {"unlike", -0.717},
    {"jump", -2.593},
    {"fold", 0.000},
    {"same_fullness", 1.000},
    {"narrow_open", -2.000},
    {"border_hole", -2.438},
    {"border_small", -2.722},
    {"one_border", -1.213},
    {"two_borders", 0.561},
    {"many_borders", -1.312},
    {"part_left_over", -0.206},
    {"handle", -10.490},
    {"lopsided_seam", -2.287},
};
static_assert(std::size(rows) == seam_measures);

SeamMeasures weights_of_rows() {
  SeamMeasures weights{};
  for (int i = 0; i < seam_measures; ++i) weights[i] = rows[i].weight;
  return weights;
}

}  // namespace

const SeamMeasures seam_weights = weights_of_rows();

const char* name_of(SeamMeasure measure) { return rows[static_cast<int>(measure)].name; }

double worth_of(const SeamMeasures& measures, const SeamMeasures& weights) {
  double sum = 0;
  for (int i = 0; i < seam_measures; ++i) sum += measures[i] * weights[i];
  return sum;
}

}  // namespace toile
