#include "geometry/body/body_proportions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/error.h"

namespace toile {

namespace {

/// Shares of the stature: women, men, and children of 1.00 m.
struct Share {
  const char* name;
  double woman;
  double man;
  double child;
};

constexpr std::array shares = {
    Share{"cervicale_height", 0.852, 0.855, 0.800}, Share{"bust_height", 0.718, 0.725, 0.688},
    Share{"waist_height", 0.620, 0.615, 0.595},     Share{"hip_height", 0.503, 0.510, 0.480},
    Share{"crotch_height", 0.455, 0.465, 0.430},    Share{"knee_height", 0.275, 0.280, 0.260},
    Share{"arm_length", 0.318, 0.322, 0.302},
};

class Filling {
 public:
  Filling(const MeasureValues& given, FigureType figure) : given_(given), figure_(figure) {}

  MeasureValues run() {
    // Heights that follow from others that were taken.
    derive("crotch_height", "inside_leg");
    derive("waist_height", "waist_to_floor");
    if (!has("height")) fill_stature();
    need("height");
    need("bust");
    need("hip");
    const double height = of("height");
    for (const Share& share : shares) set(share.name, height * at_stature(share));
    keep_gap("hip_height", "waist_height", "waist_to_hip", -1);
    keep_gap("waist_height", "hip_height", "waist_to_hip", 1);
    // The inside of the leg tells the crotch's height by itself. A depth that was taken on a chair
    // is up to 4 cm less than what is left of the waist's height.
    if (!has("inside_leg")) keep_gap("crotch_height", "waist_height", "crotch_depth", -1);
    keep_gap("knee_height", "waist_height", "waist_to_knee", -1);
    keep_gap("cervicale_height", "waist_height", "back_centre_length", 0.985);
    fill_girths();
    return filled_;
  }

 private:
  bool has(const std::string& name) const { return given_.contains(name); }
  double of(const std::string& name) const {
    const auto found = given_.find(name);
    return found != given_.end() ? found->second : filled_.at(name);
  }
  void set(const std::string& name, double value) {
    if (!has(name)) filled_.try_emplace(name, value);
  }
  void need(const std::string& name) const {
    if (has(name) || filled_.contains(name)) return;
    throw Error("measures", "there is no " + name, "give at least height, bust and hip");
  }
  void derive(const std::string& name, const std::string& same) {
    if (has(same)) set(name, of(same));
  }
  void fill_stature() {
    for (const char* level : {"waist_height", "crotch_height", "cervicale_height"}) {
      if (!has(level) && !filled_.contains(level)) continue;
      const auto share = std::ranges::find_if(
          shares, [level](const Share& s) { return std::string(s.name) == level; });
      filled_["height"] = of(level) / (figure_ == FigureType::man ? share->man : share->woman);
      return;
    }
  }
  /// Of an adult from 1.60 m on, of a small child at 1.00 m.
  double at_stature(const Share& share) const {
    const double adult = figure_ == FigureType::man ? share.man : share.woman;
    if (figure_ != FigureType::child) return adult;
    const double grown = std::clamp((of("height") - 1.0) / 0.6, 0.0, 1.0);
    return share.child + grown * (adult - share.child);
  }
  /// A level that was not taken stands off another one as a measure says that was.
  void keep_gap(const std::string& level, const std::string& from, const std::string& gap,
                double sign) {
    if (!has(level) && has(gap)) filled_[level] = of(from) + sign * of(gap);
  }

  void fill_girths() {
    const bool man = figure_ == FigureType::man;
    const bool child = figure_ == FigureType::child;
    const double bust = of("bust");
    const double hip = of("hip");
    const double mean = (bust + hip) / 2;
    if (child) {
      set("waist", 0.88 * mean);
    } else if (man) {
      set("waist", mean * std::clamp(0.867 + 0.48 * (mean - 1.015), 0.75, 1.05));
    } else {
      set("waist", mean * std::clamp(0.780 + 0.31 * (mean - 0.925), 0.70, 1.00));
    }
    const double waist = of("waist");
    // A woman's is that of a cup B. Without a hollow below it, no waist would be found. Of a man
    // whose belly is larger than his chest it lies between both.
    const double between = std::min(waist, waist + 0.57 * (bust - waist));
    set("underbust", child ? std::max(0.975 * bust, between)
                     : man ? std::max(0.945 * bust, between)
                           : std::max(bust - 0.15 * std::min(bust / 0.90, 1.0), waist + 0.02));
    // A belly that is larger than the hip does not get smaller below the waist.
    set("abdomen", std::max(waist, waist + (man ? 0.50 : 0.56) * (hip - waist)));
    set("neck", child ? 0.265 + 0.28 * (bust - 0.56)
                : man ? 0.370 + 0.25 * (bust - 0.88)
                      : 0.350 + 0.20 * (bust - 0.88));
    set("head", child ? std::min(0.510 + 0.075 * (of("height") - 1.10), 0.555)
                : man ? 0.575
                      : 0.555);
    set("upper_arm", child ? 0.175 + 0.32 * (bust - 0.58)
                     : man ? 0.315 + 0.28 * (bust - 1.00)
                           : 0.280 + 0.32 * (bust - 0.88));
    const double arm = of("upper_arm");
    set("elbow", child ? 0.95 * arm : 0.125 + 0.45 * arm);
    set("wrist", child ? 0.125 + 0.30 * (arm - 0.175)
                 : man ? 0.172 + 0.20 * (arm - 0.315)
                       : 0.158 + 0.15 * (arm - 0.28));
    set("upper_thigh", (child ? 0.545 : man ? 0.565 : 0.572) * hip);
    set("mid_thigh", 0.86 * of("upper_thigh"));
    set("knee", (child ? 0.385 : 0.365) * hip);
    set("calf", of("knee"));
    set("ankle", child ? 0.26 * hip : 0.120 + 0.115 * hip);
  }

  const MeasureValues& given_;
  FigureType figure_;
  MeasureValues filled_;
};

}  // namespace

MeasureValues filled_measures(const MeasureValues& given, FigureType figure) {
  return Filling(given, figure).run();
}

double underbust_of_cup(double bust, const std::string& cup) {
  constexpr std::array cups = {"AA", "A", "B", "C", "D", "E", "F", "G", "H"};
  const auto found = std::ranges::find(cups, cup);
  if (found == cups.end()) {
    throw Error("--cup", "there is no cup '" + cup + "'", "give AA, A, B, C, D, E, F, G or H");
  }
  return bust - 0.11 - 0.02 * static_cast<double>(found - cups.begin());
}

}  // namespace toile
