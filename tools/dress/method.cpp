#include "tools/dress/method.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cloth/dressing/constants.h"
#include "cloth/springs/constants.h"
#include "cloth/springs/dress_springs.h"
#include "geometry/error.h"
#include "io/text.h"
#include "tools/program.h"

namespace toile {

namespace {

namespace po = boost::program_options;
using std::string;

constexpr const char* of_the_paper[] = {"strain-control", "sewing", "time-step", "restitution"};

/// The paper's Table 1, and what it leaves open, by the names of --sewing.
void set_sewing(const string& setting, SpringDressOptions& options) {
  SewingForce& force = options.motion.sewing;
  const std::map<string, double*> coefficients = {
      {"epsilon", &force.epsilon},
      {"tau", &force.tau},
      {"c", &force.c},
      {"lambda-f", &force.lambda_f},
      {"damp-n", &force.damp_normal},
      {"damp-t", &force.damp_tangent},
      {"atten-n", &force.atten_normal},
      {"atten-t", &force.atten_tangent},
      {"delta", &force.delta},
      {"unit-time", &force.unit_time},
      {"hand-pull", &options.hand_pull},
  };
  const std::size_t equals = setting.find('=');
  const auto found = coefficients.find(setting.substr(0, equals));
  double value = 0;
  try {
    std::size_t read = 0;
    const string number = equals == string::npos ? "" : setting.substr(equals + 1);
    value = std::stod(number, &read);
    if (read != number.size()) value = std::nan("");
  } catch (const std::exception&) {
    value = std::nan("");
  }
  if (found == coefficients.end() || !std::isfinite(value) || value < 0) {
    string names;
    for (const auto& [name, coefficient] : coefficients) names += " " + name;
    throw UsageError("--sewing", "'" + setting + "' is no coefficient with a number of 0 and more",
                     "give NAME=VALUE, with one of" + names);
  }
  if (value == 0 && (found->first == "delta" || found->first == "unit-time")) {
    throw UsageError("--sewing", found->first + " is 0", "give a number above 0");
  }
  *found->second = value;
}

double positive(const po::variables_map& given, const string& option, double most) {
  const double value = given[option].as<double>();
  if (!(value >= 0 && value <= most)) {
    throw UsageError("--" + option, "is not between 0 and " + std::to_string(most), "see --help");
  }
  return value;
}

DressMethod paper(const po::variables_map& given, double residual) {
  SpringDressOptions options;
  options.stop_median = residual;
  options.stop_rms = rms_over_median * residual;
  const string control = given["strain-control"].as<string>();
  if (control == "position") {
    options.motion.strain_scheme = StrainScheme::position;
    options.motion.strain = provot_options();
  } else if (control == "none") {
    options.motion.strain_scheme = StrainScheme::none;
  } else if (control == "converged") {
    options.motion.converged_strain = true;
  } else if (control != "velocity") {
    throw UsageError("--strain-control",
                     "'" + control + "' is none of velocity, converged, position, none",
                     "leave it out for the paper's, by velocity");
  }
  if (const auto limit = read_strain_limit(given)) options.motion.strain.limit = *limit;
  if (given.count("time-step")) {
    options.motion.time_step = positive(given, "time-step", 0.01);
    if (options.motion.time_step < 1e-8) {
      throw UsageError("--time-step", "is below 1e-8 s", "leave it out for the largest stable one");
    }
  }
  options.motion.restitution = positive(given, "restitution", 1);
  if (given.count("sewing")) {
    for (const string& setting : given["sewing"].as<std::vector<string>>()) {
      set_sewing(setting, options);
    }
  }
  DressMethod method;
  method.name = "paper";
  method.outfit.dress = [options](const PanelMesh& garment, const Scene& scene,
                                  const FrameWatcher& watcher) {
    return dress_springs(garment, scene, options, watcher);
  };
  return method;
}

DressOptions until_residual(double residual) {
  DressOptions options;
  options.stop_median = residual;
  options.stop_rms = rms_over_median * residual;
  options.stop_wide = residual;
  return options;
}

}  // namespace

const Quality& read_quality(const po::variables_map& given) {
  // What is let go has to be at rest as a whole, or it swings.
  if (given["quality"].defaulted() && given.count("release") != 0) return standard_quality;
  const string name = given["quality"].as<string>();
  for (const Quality& quality : qualities) {
    if (name == quality.name) return quality;
  }
  throw po::error("--quality is figures, draft, standard or fine");
}

DressMethod relaxation_of(const Quality& quality) {
  return {"relaxation", quality, relaxation_method(until_residual(quality.residual), false)};
}

void add_method_options(po::options_description& options, const Quality& usual) {
  options.add_options()("method", po::value<string>()->default_value("relaxation"),
                        "relaxation: fast; paper: Zhong & Xu 2009, masses and springs in time")(
      "strain-limit", po::value<double>(),
      "relaxation: hold warp and weft to this strain, a fraction: 0.01 is 1 %, and name in the "
      "report the places where they can't be; paper: hold every edge within it, 0.01 if not "
      "given")(
      "shear-limit", po::value<double>(),
      "relaxation: hold the angle between warp and weft to this many degrees off the right one")(
      "quality", po::value<string>()->default_value(usual.name),
      "figures (a residual of 0.1), draft (0.05), standard (0.0015) or fine (0.0005); the paper's "
      "method goes to 0.05 if not told otherwise")(
      "residual", po::value<double>(),
      "instead of a quality: at rest when the force left on half of the nodes is below this share "
      "of a node's weight; method.md says the whole")(
      "strain-control", po::value<string>()->default_value("velocity"),
      "paper: velocity (three passes), converged (velocities too, until the limit holds, while "
      "draping), position (Provot's, limit 0.1) or none")(
      "sewing", po::value<std::vector<string>>()->composing(),
      "paper: a coefficient of the sewing force, NAME=VALUE: epsilon, tau, c, lambda-f, damp-n, "
      "damp-t, atten-n, atten-t, delta (m), unit-time (s), hand-pull (N/m); may be repeated")(
      "release", po::value<string>(),
      "relaxation: drape until the garment stays, let go of it for a time, such as 1s, in lightly "
      "damped motion, and report how far it moves")(
      "time-step", po::value<double>(), "paper: seconds; default: 0.9 of what is stable")(
      "restitution", po::value<double>()->default_value(0, "0"),
      "paper: share of the speed that the cloth bounces off with");
}

void check_method_options(const po::variables_map& given) {
  const string method = given["method"].as<string>();
  read_quality(given);
  if (!given["quality"].defaulted() && given.count("residual")) {
    throw po::error("--quality and --residual say the same: give one");
  }
  if (method == "paper") {
    for (const char* option : {"release", "shear-limit"}) {
      if (given.count(option) == 0) continue;
      throw po::error("--" + string(option) + " belongs to --method relaxation");
    }
    return;
  }
  if (method != "relaxation") throw po::error("--method is relaxation or paper");
  for (const char* option : of_the_paper) {
    if (given.count(option) != 0 && !given[option].defaulted()) {
      throw po::error("--" + string(option) + " belongs to --method paper");
    }
  }
}

std::optional<double> read_strain_limit(const po::variables_map& given) {
  if (given.count("strain-limit") == 0) return std::nullopt;
  const double limit = given["strain-limit"].as<double>();
  if (!(limit >= 0 && limit < 1)) {
    throw UsageError("--strain-limit",
                     "a strain of " + fixed_number(limit, 3) + " is not at least 0 and below 1",
                     "0.01 holds warp and weft to 1 %");
  }
  return limit;
}

std::optional<double> read_shear_limit(const po::variables_map& given) {
  if (given.count("shear-limit") == 0) return std::nullopt;
  const double degrees = given["shear-limit"].as<double>();
  if (!(degrees > 0 && degrees < 90)) {
    throw UsageError("--shear-limit", "is not between 0 and 90 degrees",
                     "10 is that of a dense woven");
  }
  return std::sin(degrees * std::numbers::pi / 180);
}

/// Residual of a garment at rest, in mean node weights.
double read_residual(const po::variables_map& given, bool of_paper) {
  const Quality quality = read_quality(given);
  const bool is_usual =
      given["quality"].defaulted() || string(quality.name) == standard_quality.name;
  double residual = of_paper && is_usual ? spring_resting_residual : quality.residual;
  if (given.count("residual")) residual = given["residual"].as<double>();
  if (!(residual > 0 && residual < 1)) {
    throw UsageError("--residual", "is not between 0 and 1", "leave it out for the default");
  }
  return residual;
}

DressMethod read_method(const po::variables_map& given, bool coupled) {
  const bool of_paper = given["method"].as<string>() == "paper";
  const double residual = read_residual(given, of_paper);
  if (of_paper) {
    if (!coupled) return paper(given, residual);
    throw UsageError("--method", "paper's layers are frozen",
                     "leave \"layering\" out of the scene");
  }
  DressOptions options = until_residual(residual);
  if (given.count("release")) {
    options.release_seconds = parse_time(given["release"].as<string>(), "--release");
    if (options.release_seconds > 60) {
      throw UsageError("--release", "is longer than a minute", "1s shows whether a garment stays");
    }
  }
  std::optional<Quality> quality;
  if (given.count("residual") == 0) quality = read_quality(given);
  return {"relaxation", quality, relaxation_method(options, coupled)};
}

}  // namespace toile
