// Bust, waist and hip of bodies against measures that are known of them.
#include <algorithm>
#include <fstream>

#include "geometry/body/clean_body.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/mannequin/mannequin_shape.h"
#include "geometry/body/measures.h"
#include "geometry/body/torso_section.h"
#include "geometry/body/trunk_levels.h"
#include "io/measure_names.h"
#include "io/mesh_file.h"
#include "tests/support/run_program.h"
#include "tests/validation/report.h"

namespace toile {
namespace levels_test {

constexpr double bound = 0.5;  // cm

/// Centimetres around the body at a level; 0: it has none.
double girth_at(const TriangleMesh& body, const Skeleton& skeleton, const std::string& name) {
  for (const NamedLevel& level : girth_levels(body, skeleton)) {
    if (level.name == name) return 100 * torso_section(body, level.height)->girth;
  }
  return 0;
}

/// Centimetres: a measure from a list of lines `name: value`.
double measure(const std::filesystem::path& file, const std::string& name) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(name + ":");
    if (at != std::string::npos && line.find_first_not_of(' ') == at) {
      return std::stod(line.substr(at + name.size() + 1));
    }
  }
  ADD_FAILURE() << file << " has no " << name;
  return 0;
}

void expect_measures(const std::string& name, const std::filesystem::path& mesh,
                     const std::filesystem::path& measures) {
  const CleanBody body = clean_body(read_mesh(mesh), name);
  ASSERT_TRUE(body.skeleton);
  for (const auto& [level, key] :
       {std::pair("bust", "bust"), {"waist", "waist"}, {"hip", "hips"}}) {
    test::expect_near({name + ", girth of the " + level, "trunk levels", "", "cm"},
                      girth_at(body.mesh, *body.skeleton, level), measure(measures, key), bound);
  }
}

/// The mean of both sides, in centimetres or degrees.
double taken(const std::vector<Measure>& measures, std::string_view name) {
  double sum = 0;
  int n = 0;
  for (const std::string side : {"", "left_", "right_"}) {
    const Measure* found = find_measure(measures, side + std::string(name));
    if (found == nullptr || !found->value) continue;
    sum += *found->value * (found->is_angle ? 1 : 100);
    ++n;
  }
  EXPECT_GT(n, 0) << name;
  return sum / n;
}

/// All that GarmentCode's file of the body says: girths within 5 mm, others within 10 mm or
/// degrees.
void expect_garmentcode(const std::string& name, const std::filesystem::path& mesh,
                        const std::filesystem::path& file) {
  const std::vector<std::string> girths = {"bust", "underbust", "waist",
                                           "hips", "leg_circ",  "wrist"};
  // Taken otherwise there: not over the bust's points, not square to the neck.
  const std::vector<std::string> others = {"bust_line", "waist_over_bust_line", "neck_w"};
  const auto holds = [](const std::vector<std::string>& list, const std::string& key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  const std::vector<Measure> measures =
      measure_body(find_landmarks(fan_triangles(read_mesh(mesh)), name));
  for (const ForeignMeasure& foreign : foreign_measures(DraftingProgram::garmentcode)) {
    const std::string key(foreign.name);
    double ours = 0;
    for (const MeasureTerm& term : foreign.terms) ours += term.factor * taken(measures, term.name);
    const double theirs = measure(file, key);
    const bool is_angle =
        key.ends_with("angle") || key.ends_with("incl") || key.ends_with("inclination");
    test::Figure figure{name + ", GarmentCode's " + key, "measures", "",
                        is_angle ? "degrees" : "cm"};
    if (holds(others, key)) {
      figure.reason = "taken otherwise there";
      test::state(figure, ours, test::number(theirs, 6, figure.unit),
                  test::number(ours - theirs, 3, figure.unit));
    } else {
      test::expect_near(figure, ours, theirs, holds(girths, key) ? 0.5 : 1);
    }
  }
}

TEST(Levels, GarmentCodesMeasuresOfAWoman) {
  TOILE_REAL_DATA(mesh, "bodies/mean_all.obj");
  TOILE_REAL_DATA(measures, "bodies/mean_all.yaml");
  expect_garmentcode("mean_all", mesh, measures);
}

TEST(Levels, GarmentCodesMeasuresOfAMan) {
  TOILE_REAL_DATA(mesh, "bodies/mean_male.obj");
  TOILE_REAL_DATA(measures, "bodies/mean_male.yaml");
  expect_garmentcode("mean_male", mesh, measures);
}

TEST(Levels, OfAWomanMeasured) {
  TOILE_REAL_DATA(mesh, "bodies/mean_all.obj");
  TOILE_REAL_DATA(measures, "bodies/mean_all.yaml");
  expect_measures("mean_all", mesh, measures);
}

TEST(Levels, OfAManMeasured) {
  TOILE_REAL_DATA(mesh, "bodies/mean_male.obj");
  TOILE_REAL_DATA(measures, "bodies/mean_male.yaml");
  expect_measures("mean_male", mesh, measures);
}

TEST(Levels, OfTheMannequin) {
  const Mannequin mannequin = make_mannequin();
  for (const GirthTarget& target : girth_targets()) {
    const std::string name(target.name);
    if (name != "bust" && name != "waist" && name != "hip") continue;
    test::expect_near({"mannequin, girth of the " + name, "trunk levels", "", "cm"},
                      girth_at(mannequin.surface, mannequin.skeleton, name), 100 * target.girth,
                      bound);
  }
}

}  // namespace levels_test
}  // namespace toile
