#include "pattern/seams/seam_weights.h"

namespace toile {

namespace {

struct Row {
  const char* name;  // of the measure
  double weight;
};

constexpr Row rows[] = {
    {"seam", -0.461},
    {"equal_length", -0.700},
    {"rare_length", 0.271},
    {"close_length", 1.932},
    {"near_length", 0.749},
    {"log_ratio", -1.236},
    {"curve", 0.583},
    {"coincide", 1.679},
    {"coincide_curved", -0.450},
    {"halves", -1.115},
    {"across_grain", -2.435},
    {"curve_gathered", 0.404},
    {"grains_differ", -0.486},
    {"up_and_down", 0.542},
    {"both_up", 0.061},
    {"both_down", -3.054},
    {"rise_together", 0.000},
    {"rise_apart", -1.000},
    {"same_panel", -6.195},
    {"dart", 1.561},
    {"concave", -3.334},
    {"roles_agree", 0.060},
    {"sides_differ", -2.378},
    {"faces_agree", 0.015},
    {"faces_differ", -3.213},
    {"numbers_follow", 0.191},
    {"numbers_apart", -0.575},
    {"words_alike", 0.677},
    {"named_halves", -0.783},
    {"front_and_back", 0.214},
    {"numbers_differ", -1.500},
    {"first_number", 0.000},
    {"later_number", -1.500},
    {"cone", -2.000},
    {"dart_tip", 1.161},
    {"two_inside", 3.363},
    {"two_inside_off", -4.506},
    {"three_inside", 6.994},
    {"three_inside_off", -6.304},
    {"four_inside", 3.280},
    {"four_inside_off", 0.449},
    {"more_inside", -0.270},
    {"more_inside_off", -1.924},
    {"junction_off", -4.730},
    {"smooth_border", 0.740},
    {"lone_corner", -0.115},
    {"notch_in_border", 2.199},
    {"two_at_border", 0.426},
    {"two_at_border_off", 0.470},
    {"more_at_border", 0.375},
    {"more_at_border_off", -1.854},
    {"unlike", -0.763},
    {"jump", -2.618},
    {"border_hole", -2.350},
    {"border_small", -2.237},
    {"one_border", -1.173},
    {"two_borders", 0.317},
    {"many_borders", -1.000},
    {"part_left_over", -0.522},
    {"handle", -9.557},
    {"lopsided_seam", -1.959},
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
