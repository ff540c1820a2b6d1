#include "pattern/seams/seam_weights.h"

namespace toile {

namespace {

struct Row {
  const char* name;  // of the measure
  double weight;
};

constexpr Row rows[] = {
    {"seam", -0.1},
    {"equal_length", 0.5},
    {"rare_length", 0.2},
    {"close_length", 0.3},
    {"near_length", 0.3},
    {"log_ratio", -1.0},
    {"curve", 0.4},
    {"coincide", -0.15},
    {"coincide_curved", -0.4},
    {"halves", 0.7},
    {"across_grain", -0.3},
    {"curve_gathered", 0.1},
    {"grains_differ", -0.2},
    {"same_panel", -0.2},
    {"dart", 1},
    {"concave", -1.5},
    {"roles_agree", 0.2},
    {"sides_differ", -1.2},
    {"faces_agree", 0.2},
    {"faces_differ", -0.4},
    {"numbers_follow", 0.4},
    {"numbers_apart", -0.4},
    {"words_alike", 0.2},
    {"front_and_back", 0.2},
    {"cone", -2},
    {"dart_tip", 0.6},
    {"two_inside", 1.0},
    {"two_inside_off", -1},
    {"three_inside", 1.5},
    {"three_inside_off", -1},
    {"four_inside", 2.2},
    {"four_inside_off", -1},
    {"more_inside", 1.5},
    {"more_inside_off", -1},
    {"junction_off", -0.5},
    {"smooth_border", 0.4},
    {"lone_corner", 0.1},
    {"notch_in_border", -0.2},
    {"two_at_border", 1.3},
    {"two_at_border_off", -0.6},
    {"more_at_border", 1.3},
    {"more_at_border_off", -1},
    {"unlike", -0.5},
    {"jump", -0.5},
    {"border_hole", -2},
    {"border_small", -0.5},
    {"one_border", -1},
    {"two_borders", 0},
    {"many_borders", -0.5},
    {"part_left_over", -6},
    {"handle", -6},
    {"lopsided_seam", -1},
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
