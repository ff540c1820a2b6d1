#include "geometry/body/measure_checks.h"

#include <array>

#include "geometry/error.h"

namespace toile {

namespace {

/// Metres that a measure may have.
struct Range {
  const char* name;
  double min;
  double max;
};

constexpr std::array ranges = {
    Range{"height", 0.60, 2.30},    Range{"bust", 0.38, 2.00},
    Range{"underbust", 0.36, 1.80}, Range{"waist", 0.36, 2.00},
    Range{"abdomen", 0.36, 2.10},   Range{"hip", 0.38, 2.20},
    Range{"neck", 0.18, 0.70},      Range{"head", 0.38, 0.68},
    Range{"upper_arm", 0.11, 0.65}, Range{"elbow", 0.11, 0.50},
    Range{"wrist", 0.09, 0.28},     Range{"upper_thigh", 0.20, 1.10},
    Range{"mid_thigh", 0.18, 0.95}, Range{"knee", 0.16, 0.70},
    Range{"calf", 0.14, 0.70},      Range{"ankle", 0.11, 0.45},
    Range{"bust_span", 0.08, 0.40},
};

/// A measure against another: the quotient's bounds.
struct Quotient {
  const char* name;
  const char* by;
  double min;
  double max;
};

constexpr std::array quotients = {
    Quotient{"bust", "height", 0.33, 1.25},
    Quotient{"waist", "height", 0.28, 1.25},
    Quotient{"hip", "height", 0.35, 1.30},
    Quotient{"waist", "hip", 0.48, 1.30},
    Quotient{"waist", "bust", 0.50, 1.35},
    Quotient{"bust", "hip", 0.60, 1.55},
    Quotient{"underbust", "bust", 0.62, 1.04},
    Quotient{"abdomen", "hip", 0.55, 1.30},
    Quotient{"abdomen", "waist", 0.80, 1.90},
    Quotient{"neck", "bust", 0.25, 0.60},
    Quotient{"upper_arm", "bust", 0.20, 0.50},
    Quotient{"elbow", "upper_arm", 0.60, 1.25},
    Quotient{"wrist", "elbow", 0.45, 1.00},
    Quotient{"upper_thigh", "hip", 0.42, 0.75},
    Quotient{"mid_thigh", "upper_thigh", 0.65, 1.05},
    Quotient{"knee", "mid_thigh", 0.50, 1.15},
    Quotient{"calf", "knee", 0.75, 1.30},
    Quotient{"ankle", "calf", 0.45, 1.05},
    Quotient{"shoulder_length", "height", 0.04, 0.12},
    Quotient{"cervicale_height", "height", 0.76, 0.90},
    Quotient{"bust_height", "height", 0.60, 0.80},
    Quotient{"waist_height", "height", 0.52, 0.69},
    Quotient{"hip_height", "height", 0.40, 0.58},
    Quotient{"crotch_height", "height", 0.34, 0.54},
    Quotient{"knee_height", "height", 0.20, 0.33},
    Quotient{"arm_length", "height", 0.24, 0.42},
    Quotient{"back_centre_length", "height", 0.15, 0.35},
    Quotient{"waist_to_hip", "height", 0.05, 0.19},
    Quotient{"waist_to_knee", "height", 0.25, 0.42},
    Quotient{"crotch_depth", "height", 0.09, 0.24},
    // Levels rise.
    Quotient{"knee_height", "crotch_height", 0.45, 0.75},
    Quotient{"crotch_height", "hip_height", 0.70, 0.985},
    Quotient{"hip_height", "waist_height", 0.65, 0.93},
    Quotient{"waist_height", "bust_height", 0.70, 0.94},
    Quotient{"bust_height", "cervicale_height", 0.72, 0.93},
};

/// `sum` has to be `first` plus `second`, metres.
struct Sum {
  const char* sum;
  const char* first;
  const char* second;
  double tolerance;
};

constexpr std::array sums = {
    Sum{"waist_height", "hip_height", "waist_to_hip", 0.02},
    Sum{"waist_height", "crotch_height", "crotch_depth", 0.04},
    Sum{"waist_height", "inside_leg", "crotch_depth", 0.04},
    Sum{"waist_height", "knee_height", "waist_to_knee", 0.03},
    Sum{"waist_to_floor", "inside_leg", "crotch_depth", 0.05},
    Sum{"crotch_height", "inside_leg", nullptr, 0.02},
    Sum{"waist_to_floor", "waist_height", nullptr, 0.04},
};

std::string with_value(const std::string& name, double value) {
  return name + " " + number_text(100 * value) + " cm";
}

}  // namespace

std::vector<std::string> contradictions(const MeasureValues& measures,
                                        const MeasureValues& derived) {
  std::vector<std::string> found;
  MeasureValues all = measures;
  all.insert(derived.begin(), derived.end());
  const auto in = [](const MeasureValues& values, const char* name) {
    const auto at = values.find(name);
    return at == values.end() ? nullptr : &at->second;
  };
  const auto value = [&](const char* name) { return in(all, name); };
  for (const Range& range : ranges) {
    const double* is = value(range.name);
    if (is == nullptr || (*is >= range.min && *is <= range.max)) continue;
    found.push_back(with_value(range.name, *is) + " is not within " + number_text(100 * range.min) +
                    " to " + number_text(100 * range.max) + " cm");
  }
  for (const Quotient& rule : quotients) {
    const double* a = value(rule.name);
    const double* b = value(rule.by);
    if (a == nullptr || b == nullptr || (*a >= rule.min * *b && *a <= rule.max * *b)) continue;
    found.push_back(with_value(rule.name, *a) + " and " + with_value(rule.by, *b) + " disagree (" +
                    rule.name + " is " + number_text(100 * rule.min) + " to " +
                    number_text(100 * rule.max) + " % of " + rule.by + ")");
  }
  for (const Sum& rule : sums) {
    const double* sum = in(measures, rule.sum);
    const double* first = in(measures, rule.first);
    const double* second = rule.second == nullptr ? nullptr : in(measures, rule.second);
    if (sum == nullptr || first == nullptr || (rule.second != nullptr && second == nullptr)) {
      continue;
    }
    const double parts = *first + (second == nullptr ? 0 : *second);
    if (std::abs(*sum - parts) <= rule.tolerance) continue;
    found.push_back(with_value(rule.sum, *sum) + " and " + with_value(rule.first, *first) +
                    (second == nullptr ? "" : " plus " + with_value(rule.second, *second)) +
                    " disagree");
  }
  return found;
}

}  // namespace toile
