#include "geometry/body/mannequin/fit_mannequin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/body/centreline.h"
#include "geometry/body/mannequin/mannequin_measures.h"
#include "geometry/body/torso_section.h"
#include "geometry/error.h"

namespace toile {

namespace {

using Part = BuildPart;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A measure and the parts that move it, with their shares: a factor's logarithm moves the
/// measure's by so much.
struct Moved {
  const char* name;
  std::vector<std::pair<Part, double>> parts;
  double weight = 1;  ///< of lengths along the skin, which also hang on the trunk's form: less
};

const std::vector<Moved>& moved_measures() {
  // The shares of sums are those of the sample: waist 1.05 m, hip 0.86, crotch 0.763 and so on.
  static const std::vector<Moved> all = {
      {"height", {{Part::height, 1}}},
      {"cervicale_height", {{Part::cervicale_height, 1}}},
      {"bust_height", {{Part::bust_height, 1}}},
      {"waist_height", {{Part::waist_height, 1}}},
      {"hip_height", {{Part::hip_height, 1}}},
      {"crotch_height", {{Part::crotch_height, 1}}},
      {"inside_leg", {{Part::crotch_height, 1}}},
      {"knee_height", {{Part::knee_height, 1}}},
      {"arm_length", {{Part::arm_length, 1}}},
      {"waist_to_floor", {{Part::waist_height, 1}}},
      {"waist_to_hip", {{Part::waist_height, 5.5}, {Part::hip_height, -4.5}}},
      {"waist_to_knee", {{Part::waist_height, 1.8}, {Part::knee_height, -0.8}}},
      {"crotch_depth", {{Part::waist_height, 3.7}, {Part::crotch_height, -2.7}}},
      {"back_centre_length", {{Part::cervicale_height, 3.6}, {Part::waist_height, -2.6}}},
      {"front_centre_length", {{Part::cervicale_height, 4.2}, {Part::waist_height, -3.2}}, 0.3},
      {"back_full_length", {{Part::cervicale_height, 3.4}, {Part::waist_height, -2.4}}, 0.3},
      {"front_full_length", {{Part::cervicale_height, 3.4}, {Part::waist_height, -2.4}}, 0.3},
      {"bust_depth", {{Part::cervicale_height, 5.4}, {Part::bust_height, -4.4}}, 0.3},
      {"side_hip_depth", {{Part::waist_height, 5.5}, {Part::hip_height, -4.5}}, 0.3},
      {"front_hip_depth", {{Part::waist_height, 5.5}, {Part::hip_height, -4.5}}, 0.3},
      {"back_hip_depth", {{Part::waist_height, 5.5}, {Part::hip_height, -4.5}}, 0.3},
      {"shoulder_length", {{Part::shoulder_width, 1.3}}},
      {"back_across_shoulder", {{Part::shoulder_width, 1}}},
      {"front_across_shoulder", {{Part::shoulder_width, 1}}, 0.3},
      {"shoulder_width", {{Part::shoulder_width, 1}}},
      {"head", {{Part::head, 1}}},
      {"neck", {{Part::neck, 1}}},
      {"bust", {{Part::chest, 0.8}, {Part::breast, 0.3}}},
      {"underbust", {{Part::underbust, 1}}},
      {"waist", {{Part::waist, 1}}},
      {"abdomen", {{Part::abdomen, 1}}},
      {"hip", {{Part::hip, 1}}},
      {"upper_thigh", {{Part::upper_thigh, 1}}},
      {"mid_thigh", {{Part::mid_thigh, 1}}},
      {"knee", {{Part::knee, 1}}},
      {"calf", {{Part::calf, 1}}},
      {"ankle", {{Part::ankle, 1}}},
      {"upper_arm", {{Part::upper_arm, 1}}},
      {"elbow", {{Part::elbow, 1}}},
      {"wrist", {{Part::wrist, 1}}},
      {"bust_span", {{Part::bust_span, 1}}},
  };
  return all;
}

MannequinBuild build_of(const VectorXd& factors) {
  MannequinBuild build;
  for (int i = 0; i < build_parts; ++i) build[static_cast<Part>(i)] = std::exp(factors[i]);
  return build;
}

int column(Part part) { return static_cast<int>(part); }

/// Whether the measure follows from others that are given. A dressmaker's measures never agree to
/// the millimetre, and both together would bend the body.
bool is_told_by_others(const std::string& name, const MeasureValues& given) {
  if (name != "crotch_depth") return false;
  const bool has_waist = given.contains("waist_to_floor") || given.contains("waist_height");
  return has_waist && (given.contains("inside_leg") || given.contains("crotch_height"));
}

/// What a round has to solve: rows of measures, then rows that hold the factors.
class Problem {
 public:
  Problem(const MeasureValues& given, const MeasureValues& filled, const MeasureValues& sample,
          FigureType figure) {
    for (const Moved& measure : moved_measures()) {
      const bool is_given = given.contains(measure.name);
      if (!is_given && !filled.contains(measure.name)) continue;
      if (is_told_by_others(measure.name, given)) continue;
      if (!sample.contains(measure.name)) continue;
      rows_.push_back({&measure, (is_given ? given : filled).at(measure.name), is_given});
    }
    waist_is_given_ = given.contains("waist");
    jacobian_ = MatrixXd::Zero(size(), build_parts);
    for (int row = 0; row < size(); ++row) {
      for (const auto& [part, share] : rows_[row].measure->parts) {
        jacobian_(row, column(part)) = share;
      }
    }
    start_ = VectorXd::Zero(build_parts);
    double girths = 0;
    int counted = 0;
    for (const Row& row : rows_) {
      const double factor = std::log(row.wanted / sample.at(row.measure->name));
      for (const auto& [part, share] : row.measure->parts) {
        if (row.measure->parts.size() == 1) start_[column(part)] = factor;
      }
      const std::string name = row.measure->name;
      if (name == "bust" || name == "height") {
        girths += factor;
        ++counted;
      }
    }
    start_[column(Part::chest)] = start_[column(Part::underbust)];
    start_[column(Part::breast)] =
        std::log(figure == FigureType::woman ? breast_factor(sample, given, filled) : flat_breast);
    start_[column(Part::shoulder_width)] =
        girths / std::max(counted, 1) + (figure == FigureType::man ? std::log(1.06) : 0);
    keep_hip_clear(start_);
  }

  int size() const { return static_cast<int>(rows_.size()); }
  const VectorXd& start() const { return start_; }

  /// The logarithms of measured by wanted; NaN where nothing was read.
  VectorXd off(const MeasureValues& measured) const {
    VectorXd result = VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN());
    for (int row = 0; row < size(); ++row) {
      const auto found = measured.find(rows_[row].measure->name);
      if (found == measured.end() || !(found->second > 0)) continue;
      result[row] = std::log(found->second / rows_[row].wanted);
    }
    return result;
  }

  /// The root of the weighted squares of all differences, metres. What can't be read counts as 5 %.
  double miss(const VectorXd& off) const {
    constexpr double unread = 0.05;
    double sum = 0;
    for (int row = 0; row < size(); ++row) {
      if (!rows_[row].pulls) continue;
      const double by = std::isfinite(off[row]) ? off[row] : unread;
      sum += std::pow(rows_[row].measure->weight * rows_[row].wanted * by, 2);
    }
    return std::sqrt(sum);
  }

  /// The largest difference of a given measure, metres.
  double worst(const VectorXd& off) const {
    double most = 0;
    for (int row = 0; row < size(); ++row) {
      if (!rows_[row].pulls || !std::isfinite(off[row])) continue;
      most = std::max(most, rows_[row].wanted * std::abs(std::expm1(off[row])));
    }
    return most;
  }

  /// Lengths between levels of the trunk and legs that are off by more than `far` (metres) pull no
  /// more: others contradict them. False: there are none.
  bool let_go(const VectorXd& off, double far) {
    bool lets_go = false;
    for (int row = 0; row < size(); ++row) {
      Row& each = rows_[row];
      if (!each.pulls || !std::isfinite(off[row]) || !is_between_levels(*each.measure)) continue;
      if (each.wanted * std::abs(std::expm1(off[row])) <= far) continue;
      each.pulls = false;
      lets_go = true;
    }
    return lets_go;
  }

  /// The step of the factors that takes `off` away, as far as the holding rows let it.
  VectorXd step(const VectorXd& factors, const VectorXd& off) const {
    constexpr double tolerance = 0.0003;  // metres
    const int holds = build_parts + 2;
    MatrixXd left = MatrixXd::Zero(size() + holds, build_parts);
    VectorXd right = VectorXd::Zero(size() + holds);
    for (int row = 0; row < size(); ++row) {
      // What was filled in set the start. It is no aim: where a body lacks a level that a
      // proportion has, what is read there says nothing of the part.
      if (!rows_[row].pulls || !std::isfinite(off[row])) continue;
      const double weight = rows_[row].measure->weight * rows_[row].wanted / tolerance;
      left.row(row) = weight * jacobian_.row(row);
      right[row] = -weight * off[row];
    }
    for (int part = 0; part < build_parts; ++part) {
      const int row = size() + part;
      double weight = 1 / 0.03;
      if (part == column(Part::breast)) weight = 1 / 0.01;
      if (part == column(Part::shoulder_width)) weight = 1 / 0.01;
      left(row, part) = weight;
      right[row] = weight * (start_[part] - factors[part]);
    }
    // The trunk at the bust goes with that below it.
    const int last = size() + build_parts;
    constexpr double tied = 1 / 0.1;
    left(last, column(Part::chest)) = tied;
    left(last, column(Part::underbust)) = -tied;
    right[last] = tied * (factors[column(Part::underbust)] - factors[column(Part::chest)]);
    // What is below the bust leaves its start with a waist that is given: over a belly the hollow
    // is between both.
    const VectorXd left_start = factors - start_;
    const double goes_with = waist_is_given_ ? 1 / 0.01 : 0;
    left(last + 1, column(Part::underbust)) = goes_with;
    left(last + 1, column(Part::waist)) = -goes_with;
    right[last + 1] =
        goes_with * (left_start[column(Part::waist)] - left_start[column(Part::underbust)]);
    VectorXd step = left.colPivHouseholderQr().solve(right);
    // A factor of 1.35 a round at most.
    constexpr double longest = 0.3;
    const double most = step.cwiseAbs().maxCoeff();
    if (most > longest) step *= longest / most;
    return step;
  }

  /// No girth leaves the start by a factor of more than 1.4, no height by more than 1.08, so that
  /// a body stays one.
  VectorXd bounded(VectorXd factors) const {
    for (int part = 0; part < build_parts; ++part) {
      const double reach = sample_height(static_cast<Part>(part)) > 0 ? 0.08 : 0.35;
      factors[part] = std::clamp(factors[part], start_[part] - reach, start_[part] + reach);
    }
    keep_hip_clear(factors);
    return factors;
  }

  /// Buttocks and thighs need room between the levels of the crotch and of the hip. With 65 mm the
  /// body's parts run into each other.
  static void keep_hip_clear(VectorXd& factors) {
    constexpr double room = 0.075;  // metres of the sample
    const double crotch =
        sample_height(Part::crotch_height) * std::exp(factors[column(Part::crotch_height)]);
    const double least = crotch + room * std::exp(factors[column(Part::height)]);
    double& hip = factors[column(Part::hip_height)];
    hip = std::max(hip, std::log(least / sample_height(Part::hip_height)));
  }

  /// Corrects how parts move their own measures, by what the last step did [Schubert 1970]. Other
  /// entries stay 0: a few rounds can't tell some hundred of them.
  void correct(const VectorXd& step, const VectorXd& change) {
    for (int row = 0; row < size(); ++row) {
      double predicted = 0;
      double square = 0;
      for (const auto& [part, share] : rows_[row].measure->parts) {
        predicted += jacobian_(row, column(part)) * step[column(part)];
        square += step[column(part)] * step[column(part)];
      }
      // A step of less than 0.2 % shows what other parts do.
      if (square < 4e-6 || !std::isfinite(change[row])) continue;
      for (const auto& [part, share] : rows_[row].measure->parts) {
        double& entry = jacobian_(row, column(part));
        entry += (change[row] - predicted) * step[column(part)] / square;
        const double bound = entry * share > 0 ? std::abs(entry / share) : 0;
        entry = share * std::clamp(bound, 0.6, 1.8);
      }
    }
  }

  std::vector<FittedMeasure> compared(const MeasureValues& measured, const MeasureValues& given,
                                      const MeasureValues& filled) const {
    std::vector<FittedMeasure> all;
    const auto add = [&](const MeasureValues& wanted, bool is_given) {
      for (const auto& [name, value] : wanted) {
        const auto found = measured.find(name);
        const double is =
            found == measured.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
        const bool is_fitted = std::ranges::any_of(
            rows_, [&name = name](const Row& row) { return name == row.measure->name; });
        all.push_back({name, value, is, is_given, is_fitted});
      }
    };
    add(given, true);
    add(filled, false);
    std::ranges::sort(all, {}, &FittedMeasure::name);
    return all;
  }

 private:
  struct Row {
    const Moved* measure;
    double wanted;
    bool pulls;  ///< the fit is to meet it
  };
  static bool is_between_levels(const Moved& measure) {
    return measure.parts.size() > 1 && sample_height(measure.parts.front().first) > 0;
  }
  static constexpr double flat_breast = 0.5;

  /// By how much the bust is larger than the underbust, against the sample of the same size.
  static double breast_factor(const MeasureValues& sample, const MeasureValues& given,
                              const MeasureValues& filled) {
    const auto wanted = [&](const char* name) {
      return given.contains(name) ? given.at(name) : filled.at(name);
    };
    const auto share = [](double bust, double underbust) { return (bust - underbust) / bust; };
    const double more = share(wanted("bust"), wanted("underbust")) -
                        share(sample.at("bust"), sample.at("underbust"));
    return std::clamp(1 + 4 * more, 0.6, 1.5);
  }

  std::vector<Row> rows_;
  bool waist_is_given_ = false;
  VectorXd start_;
  MatrixXd jacobian_;
};

/// The mesh of a build; nothing, and `why`, where it can't be made.
std::optional<Mannequin> meshed(const MannequinBuild& build, const MannequinOptions& options,
                                std::exception_ptr& why) {
  try {
    return mesh_mannequin(built_mannequin(build), options);
  } catch (const Error&) {
    why = std::current_exception();
    return {};
  }
}

/// Where the line of the left arm's bones comes down to a height; nothing where it stays above.
std::optional<Vec3> arm_at(const Skeleton& joints, double y) {
  const std::array<Vec3, 3> line = {joints.joint("left_shoulder"), joints.joint("left_elbow"),
                                    joints.joint("left_wrist")};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i].y() < y || line[i + 1].y() > y) continue;
    const double share = (line[i].y() - y) / (line[i].y() - line[i + 1].y());
    return Vec3(line[i] + share * (line[i + 1] - line[i]));
  }
  return std::nullopt;
}

/// Whether the section of the trunk at the bust holds the arms, too: a tape can't go around it.
bool holds_arms(const Mannequin& made) {
  for (const MannequinGirth& girth : made.girths) {
    if (girth.name != "bust") continue;
    const double y = girth.centre.y();
    const std::optional<Vec3> arm = arm_at(made.skeleton, y);
    const std::optional<Section> section = torso_section(made.surface, y);
    if (arm && section && contains(*section, *arm, Vec3::UnitY())) return true;
  }
  return false;
}

/// Raises both arms by one step; false: they are as high as a mannequin's go.
bool raise_arms(Pose& pose) {
  constexpr double step = 15;  // degrees
  constexpr double most = 80;
  if (pose.left.shoulder_abduction >= most) return false;
  const double degrees = std::min(pose.left.shoulder_abduction + step, most);
  pose.left.shoulder_abduction = pose.right.shoulder_abduction = degrees;
  return true;
}

/// The best body of some rounds, and its miss, in metres.
/// Infinite: there is none.
struct Fit {
  FittedMannequin best;
  double least = std::numeric_limits<double>::infinity();
  std::exception_ptr why;  ///< what ended the rounds; null: nothing did
};

/// The factors of a round, how far off its body is, and by how much in all.
struct Tried {
  VectorXd factors;
  VectorXd off;
  double miss = std::numeric_limits<double>::infinity();
};

/// Rounds that bring nothing more: measures that contradict each other are as near as they come.
class Progress {
 public:
  bool is_over(double miss) {
    // With two rounds, busts of two large women of 43 sets are missed by 2 and 4 mm. Half and
    // double of the share were not tried.
    constexpr double counts = 0.9;  // of the least miss before
    constexpr int rounds = 3;
    idle_ = miss < counts * least_ ? 0 : idle_ + 1;
    least_ = std::min(least_, miss);
    return idle_ >= rounds;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int idle_ = 0;
};

Fit fit_rounds(Problem problem, const MeasureValues& given, const MeasureValues& filled,
               const MannequinOptions& options) {
  // Coarse meshes read the girths some 0.3 mm too small, so the last rounds are as fine as asked.
  constexpr int max_rounds = 14;
  constexpr double enough = 0.001;         // metres
  constexpr double enough_coarse = 0.002;  // metres
  // Metres: a length that stays farther off would bend the body and spoil its girths.
  constexpr double far_off = 0.02;
  // Metres: a mesh has to part the thighs.
  const double coarse =
      std::clamp(0.012 * std::exp(problem.start()[column(Part::height)]), 0.006, 0.014);
  MannequinOptions trial = options;
  trial.pose = standing_pose();
  trial.pose_name = "measures";
  Fit fit;
  Tried nearest;
  VectorXd factors = problem.start();
  VectorXd before;
  VectorXd step;
  Progress progress;
  bool is_fine = options.edge_length >= coarse;
  trial.edge_length = is_fine ? options.edge_length : coarse;
  for (int round = 1; round <= max_rounds; ++round) {
    const MannequinBuild build = build_of(factors);
    std::optional<Mannequin> made = meshed(build, trial, fit.why);
    while (made && holds_arms(*made) && raise_arms(trial.pose)) {
      made = meshed(build, trial, fit.why);
      step.resize(0);  // what the arms' move changes is not the factors' doing
      fit.least = nearest.miss = std::numeric_limits<double>::infinity();
    }
    if (!made) {
      if (!std::isfinite(nearest.miss)) return fit;
      factors = (factors + nearest.factors) / 2;
      step.resize(0);
      continue;
    }
    const MeasureValues measured = mannequin_measures(*made);
    const VectorXd off = problem.off(measured);
    const double miss = problem.miss(off);
    if (step.size() > 0) problem.correct(step, off - before);
    if (is_fine && miss < fit.least) {
      fit.least = miss;
      fit.best = {std::move(*made), build, problem.compared(measured, given, filled), trial.pose};
    }
    const bool is_nearer = miss < nearest.miss;
    if (is_nearer) nearest = {factors, off, miss};
    const double worst = problem.worst(nearest.off);
    const bool is_over = progress.is_over(miss);
    const bool lets_go = is_over && problem.let_go(nearest.off, far_off);
    // What is nearly met goes on; what contradicts comes no nearer.
    const bool contradicts = worst > far_off / 4;
    if (is_fine && (worst < enough || (is_over && !lets_go && contradicts))) break;
    const bool gets_fine =
        !is_fine && !lets_go && (worst < enough_coarse || is_over || round >= max_rounds - 4);
    if (gets_fine) {
      is_fine = true;
      trial.edge_length = options.edge_length;
    }
    // A step that led away was too long for what the Jacobian knows.
    const double share = is_nearer || gets_fine || lets_go ? 1 : 0.5;
    const VectorXd next =
        problem.bounded(nearest.factors + share * problem.step(nearest.factors, nearest.off));
    step = next - factors;
    factors = next;
    before = off;
    if (is_over || gets_fine) {
      progress = {};
      nearest.miss = std::numeric_limits<double>::infinity();
    }
  }
  return fit;
}

}  // namespace

FittedMannequin fit_mannequin(const MeasureValues& given, const MeasureValues& filled,
                              FigureType figure, const MannequinOptions& options, bool keeps_pose) {
  static const MeasureValues sample = [] {
    MannequinOptions coarse;
    coarse.edge_length = 0.015;
    return mannequin_measures(mesh_mannequin(built_mannequin({}), coarse));
  }();
  Fit fit = fit_rounds({given, filled, sample, figure}, given, filled, options);
  if (!std::isfinite(fit.least)) std::rethrow_exception(fit.why);
  FittedMannequin& best = fit.best;
  if (keeps_pose ? !(options.pose == best.pose) : !(options.pose == standing_pose())) {
    best.mannequin = mesh_mannequin(built_mannequin(best.build), options);
  }
  if (!is_one_sphere(best.mannequin.surface)) {
    throw Error("measures", "make a body whose thighs or arms touch it",
                "give a smaller --edge-length, and look at the girths");
  }
  for (MannequinGirth& girth : best.mannequin.girths) {
    const auto found = std::ranges::find(best.measures, measure_of(girth), &FittedMeasure::name);
    girth.target = found == best.measures.end() ? girth.measured : found->wanted;
  }
  return std::move(best);
}

}  // namespace toile
