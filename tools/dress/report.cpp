#include "tools/dress/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tools/dress/attachments.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Metres by which cloth is held farther off the body than the offset, from which on the user is
/// told.
constexpr double worth_saying = 0.002;

struct ExtraOffset {
  std::ptrdiff_t nodes = 0;
  double most = 0;  ///< metres
};

ExtraOffset extra_offset_of(const std::vector<double>& extra) {
  if (extra.empty()) return {};
  return {std::ranges::count_if(extra, [](double metres) { return metres > 0; }),
          std::ranges::max(extra)};
}

/// Strain (99th percentile, off the seams) that no woven is worn at.
constexpr double suspicious_strain = 0.1;
/// Metres from which on a garment is said to have slid.
constexpr double far_to_slide = 0.05;

Json strain_json(const StrainFigures& strain) {
  return {{"max", strain.max}, {"p99", strain.p99}, {"rms", strain.rms}};
}

Json release_json(const ReleaseReport& release) {
  return {{"seconds", release.seconds},
          {"moved_mm", moved_json(release.all)},
          {"held_nodes", release.held},
          {"crept_mm", moved_json(release.of_held)},
          {"stays", release.stays()},
          {"end_speed_p99_mm_per_s", 1000 * release.speed_p99},
          {"end_kinetic_energy_J", release.kinetic},
          {"energy_given_up_J", release.given_up},
          {"time_step_s", release.time_step},
          {"steps", release.steps},
          {"searches", release.searches},
          {"wall_seconds", release.wall_seconds}};
}

Json tight_regions_json(const TightRegions& tight) {
  Json all = Json::array();
  for (const TightRegion& place : tight.places) {
    all.push_back({{"panel", place.panel},
                   {"flat_cm", {100 * place.flat.x(), 100 * place.flat.y()}},
                   {"height_cm", 100 * place.height},
                   {"area_cm2", 1e4 * place.area},
                   {"direction", place.along_warp ? "warp" : "weft"},
                   {"largest_percent", 100 * place.largest},
                   {"mean_percent", 100 * place.mean},
                   {"missing_cm", 100 * place.missing}});
  }
  return all;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string percent(double fraction) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << 100 * fraction << " %";
  return text.str();
}

/// Names the most strained place of those that can't be held to the strain limit.
void say_tight_places(const TightRegions& tight, const CommonSettings& common) {
  if (tight.places.empty()) return;
  const TightRegion& most = tight.places.front();
  std::ostringstream line;
  line << std::fixed << std::setprecision(1) << "beyond the strain limit: panel " << most.panel
       << ", " << 100 * most.height << " cm above the ground, " << 1e4 * most.area
       << " cm2, is strained by up to " << percent(most.largest) << " along the "
       << (most.along_warp ? "warp" : "weft") << ", where " << 100 * most.missing
       << " cm are missing";
  if (const std::size_t others = tight.places.size() - 1; others > 0) {
    line << "; other places: " << others;
  }
  common.say(line.str());
}

void say_release(const ReleaseReport& release, const CommonSettings& common) {
  std::ostringstream line;
  line << std::fixed << std::setprecision(2) << "let go for " << release.seconds
       << " s, half of its nodes move less than " << 1000 * release.all.median
       << " mm, 99 % less than " << 1000 * release.all.p99 << " mm, all less than "
       << 1000 * release.all.max << " mm";
  common.say(line.str());
  if (release.stays()) return;
  CommonSettings::warn(
      "the garment does not stay where it was draped: let go, a hundredth of its nodes "
      "moves 2 mm and more; a smaller --residual can bring it nearer to rest");
}

}  // namespace

nlohmann::ordered_json quality_json(const Quality& quality) {
  return {{"quality", quality.name},
          {"expected_error",
           {{"node_distance_rms_mm", quality.distance_rms_mm},
            {"against", "the same run brought to rest"},
            {"measured_on", measured_on}}}};
}

nlohmann::ordered_json residual_json(const Residual& residual) {
  return {{"median", residual.median},
          {"rms", residual.rms},
          {"max", residual.max},
          {"wide", residual.wide}};
}

nlohmann::ordered_json stages_json(const std::vector<StageReport>& stages) {
  Json json = Json::array();
  for (const StageReport& stage : stages) {
    json.push_back({{"name", stage.name},
                    {"attempt", stage.attempt},
                    {"open", stage.open},
                    {"nodes", stage.nodes},
                    {"steps", stage.steps},
                    {"searches", stage.searches},
                    {"seconds", stage.seconds},
                    {"simulated_seconds", stage.simulated},
                    {"converged", stage.converged},
                    {"residual", residual_json(stage.residual)}});
  }
  return json;
}

nlohmann::ordered_json moved_json(const MovedFigures& moved) {
  return {{"median", 1000 * moved.median}, {"p99", 1000 * moved.p99}, {"max", 1000 * moved.max}};
}

nlohmann::ordered_json report_of(const PanelMesh& garment, const Scene& scene,
                                 const std::string& method, const DressResult& result,
                                 const Judgement& judgement, double seconds) {
  const GarmentFigures& figures = judgement.garment;
  Json report;
  report["garment"] = {{"vertices", result.nodes.size()},
                       {"material_points", garment.flat.size()},
                       {"triangles", garment.triangles.size()},
                       {"panels", garment.panels.size()},
                       {"seams", garment.seams.size()}};
  for (const auto& [term, count] : result.terms) {
    report["scene"]["terms"][term] = count;
  }
  report["scene"]["fabric"] = scene.fabric.name;
  for (const MeshedPanel& panel : garment.panels) {
    if (panel.fabric.empty()) continue;
    report["scene"]["panel_fabrics"][panel.name] = fabric_of(scene, panel).name;
  }
  report["scene"]["gravity_m_per_s2"] = {scene.gravity.x(), scene.gravity.y(), scene.gravity.z()};
  report["scene"]["body_offset_mm"] = 1000 * result.body_offset;
  if (const ExtraOffset extra = extra_offset_of(result.extra_offset); extra.nodes > 0) {
    report["scene"]["extra_offset"] = {{"nodes", extra.nodes}, {"max_mm", 1000 * extra.most}};
  }
  report["scene"]["points_inside_at_start"] = result.placement.points_inside;
  report["scene"]["seam_pairs_inside_at_start"] = result.placement.seams_inside;
  report["scene"]["lift_mm"] = 1000 * result.placement.lift;
  for (const auto& [part, angle] : result.placement.turned) {
    report["scene"]["turned_degrees"][part] = angle * 180 / std::numbers::pi;
  }
  for (const auto& [part, distance] : result.placement.drawn_out) {
    report["scene"]["drawn_out_mm"][part] = 1000 * distance;
  }
  for (const PositionedPanel& panel : result.placement.positioned) {
    Json json = {{"panel", panel.panel}, {"rolled", panel.rolled}, {"bent", panel.bent}};
    json[panel.rolled ? "radius_mm" : "distance_mm"] = 1000 * panel.distance;
    if (panel.rolled) {
      json["gap_mm"] = 1000 * panel.gap;
      json["drawn_out_mm"] = 1000 * panel.drawn_out;
      json["points_too_near"] = panel.points_too_near;
    }
    report["scene"]["positioned"].push_back(json);
  }
  for (const auto& [panel, distance] : result.placement.moved_off_layers) {
    report["scene"]["stepped_out_mm"][panel] = 1000 * distance;
  }
  for (const auto& [panel, distance] : result.placement.moved_clear) {
    report["scene"]["moved_clear_mm"][panel] = 1000 * distance;
  }
  report["method"] = method;
  if (result.time_step > 0) report["time_step_s"] = result.time_step;
  report["stages"] = stages_json(result.stages);
  report["seconds"] = seconds;
  report["converged"] = result.converged;
  report["residual"] = residual_json(result.residual);
  if (result.release) report["release"] = release_json(*result.release);
  report["strain"] = strain_json(figures.strain);
  report["strain_off_seams"] = strain_json(figures.strain_off_seams);
  report["warp_weft_strain"] = strain_json(figures.warp_weft_strain);
  report["shear_degrees"] = {{"max", degrees(figures.shear.max)},
                             {"p99", degrees(figures.shear.p99)},
                             {"rms", degrees(figures.shear.rms)}};
  report["area_change_percent"] = {{"total", figures.area_total_percent},
                                   {"max_panel", figures.area_max_panel_percent},
                                   {"max_during", result.during.area_percent}};
  report["perimeter_change_percent"] = {
      {"max_panel", figures.perimeter_max_panel_percent},
      {"max_during", result.during.perimeter_percent},
      {"triangles_max_panel", figures.triangle_perimeter_max_panel_percent}};
  report["seams"] = {{"sewn", figures.seams.sewn},
                     {"open", figures.seams.open},
                     {"max_gap_mm", figures.seams.max_gap_mm}};
  for (const ElasticFigures& segment : figures.elastics) {
    report["elastics"].push_back({{"name", segment.name},
                                  {"flat_cm", 100 * segment.flat},
                                  {"rest_cm", 100 * segment.rest},
                                  {"worn_cm", 100 * segment.now},
                                  {"tension_N", segment.tension}});
  }
  if (!result.attachments.empty()) report["attachments"] = attachments_json(result.attachments);
  report["wraps"] = Json::array();
  for (const WrapFigure& wrap : judgement.wraps) {
    report["wraps"].push_back({{"part", wrap.part},
                               {"fraction", wrap.fraction},
                               {"slid_cm", 100 * wrap.slid},
                               {"from_m", wrap.from},
                               {"to_m", wrap.to},
                               {"tube", wrap.tube}});
  }
  report["borders"] = figures.borders;
  report["intersections"] = {{"body", judgement.body_intersections},
                             {"self", judgement.self_intersections},
                             {"layers", judgement.layer_intersections},
                             {"check", "exact"}};
  report["verdict"] = judgement.verdict;
  for (const OpenSeam& seam : judgement.unsewable_seams) {
    report["unsewable_seams"].push_back({{"name", seam.name}, {"missing_cm", seam.missing_cm}});
  }
  for (const TightSeam& seam : result.tight_seams) {
    report["tight_seams"].push_back(
        {{"name", seam.name}, {"tension_N_per_m", seam.tension}, {"missing_cm", seam.missing_cm}});
  }
  if (result.tight_regions) {
    report["tight_regions"] = tight_regions_json(*result.tight_regions);
    report["tight_specks"] = result.tight_regions->specks;
  }
  for (const std::string& part : judgement.unwrapped) report["unwrapped"].push_back(part);
  return report;
}

nlohmann::ordered_json certified_json(const Certificate& certificate) {
  Json json;
  const std::optional<int> clean_from = certificate.clean_from();
  json["clean_from_frame"] = clean_from ? Json(*clean_from) : Json();
  json["clean_from_stage"] = clean_from ? Json(certificate.frames()[*clean_from].stage) : Json();
  json["stayed_clean"] = certificate.stayed_clean();
  json["check"] = "exact";
  json["frames"] = Json::array();
  for (const FrameFigures& frame : certificate.frames()) {
    json["frames"].push_back({{"frame", json["frames"].size()},
                              {"stage", frame.stage},
                              {"points", frame.points},
                              {"open_pairs", frame.open_pairs},
                              {"body", frame.body},
                              {"self", frame.self},
                              {"self_across_open_seams", frame.across_seams},
                              {"layers", frame.layers},
                              {"pieces_inside", frame.inside},
                              {"clean", frame.clean()}});
  }
  return json;
}

void say_certificate(const Certificate& certificate, const CommonSettings& common) {
  const std::size_t count = certificate.frames().size();
  if (const std::optional<int> first = certificate.clean_from()) {
    common.say("certified: " + std::to_string(count) + " frames, clean from frame " +
               std::to_string(*first) + " (" + certificate.frames()[*first].stage + ") on");
  }
  if (certificate.stayed_clean()) return;
  std::size_t last = count;
  while (last > 0 && certificate.frames()[last - 1].clean()) --last;
  if (last == 0) return;
  const FrameFigures& frame = certificate.frames()[last - 1];
  CommonSettings::warn(
      "not certified: the state did not stay free of intersections; last in frame " +
      std::to_string(last - 1) + " (" + frame.stage + "): " + std::to_string(frame.body) +
      " with the body, " + std::to_string(frame.self) + " with itself, " +
      std::to_string(frame.layers) + " with layers below, " + std::to_string(frame.inside) +
      " pieces inside the body");
}

void say_positions(const Placement& placement, const CommonSettings& common) {
  for (const PositionedPanel& panel : placement.positioned) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << "panel " << panel.panel;
    if (panel.rolled) {
      line << " is rolled" << (panel.bent ? " along the bend of its part" : "") << ", radius "
           << 100 * panel.distance << " cm, gap " << 100 * panel.gap << " cm";
    } else {
      line << " stands " << 100 * panel.distance << " cm from the bones";
    }
    common.say(line.str());
  }
  for (const auto& [part, angle] : placement.turned) {
    common.say("the sleeve of " + part + " was turned by " +
               std::to_string(std::lround(angle * 180 / std::numbers::pi)) +
               " degrees, to run down the arm");
  }
  for (const auto& [panel, distance] : placement.moved_clear) {
    std::ostringstream line;
    line << "panel " << panel << " stood through the body or another panel, and was moved out by "
         << std::lround(100 * distance) << " cm";
    common.say(line.str());
  }
}

void say_terms(const DressResult& result, const CommonSettings& common) {
  std::string line = "terms:";
  for (const auto& [term, count] : result.terms) {
    line += " " + term + " " + std::to_string(count) + ",";
  }
  line.back() = '.';
  common.say(line);
}

namespace {

/// Why the verdict is what it is, where that takes a name.
void warn_of_verdict(const DressResult& result, const Judgement& judgement) {
  std::ostringstream line;
  line << std::fixed << std::setprecision(1);
  const char* separator = "";
  for (const OpenSeam& seam : judgement.unsewable_seams) {
    line << separator << seam.name << " (" << seam.missing_cm << " cm)";
    separator = ", ";
  }
  if (!result.tight_seams.empty()) {
    CommonSettings::warn("too tight: closing these seams takes more than a hand's pull of " +
                         std::to_string(std::lround(hand_pull)) +
                         " N/m; what is missing at each: " + line.str());
  } else if (!judgement.unsewable_seams.empty()) {
    CommonSettings::warn("these seams could not be closed; how far they stand open: " + line.str());
  }
  for (const std::string& part : judgement.unwrapped) {
    CommonSettings::warn(
        "the garment does not go around " + part +
        ": check where the panels of that part are placed, and what they are sewn to");
  }
}

}  // namespace

void say_result(const DressResult& result, const Judgement& judgement,
                const CommonSettings& common) {
  const GarmentFigures& figures = judgement.garment;
  std::ostringstream residual;
  residual << std::setprecision(2) << result.residual.median << " median, " << result.residual.rms
           << " rms";
  common.say("seams: " + std::to_string(figures.seams.sewn) + " sewn, " +
             std::to_string(figures.seams.open) +
             " open; intersections: " + std::to_string(judgement.body_intersections) +
             " with the body, " + std::to_string(judgement.self_intersections) + " with itself, " +
             std::to_string(judgement.layer_intersections) + " with layers below");
  common.say("strain off the seams: " + percent(figures.strain_off_seams.p99) +
             " (99th percentile); residual in node weights: " + residual.str());
  if (const ExtraOffset extra = extra_offset_of(result.extra_offset); extra.most > worth_saying) {
    std::ostringstream line;
    line << std::setprecision(2) << "held up to " << 1000 * extra.most
         << " mm farther off the body at " << extra.nodes
         << " nodes, whose triangles span something sharp: a finer mesh comes nearer";
    common.say(line.str());
  }
  say_attachments(result.attachments, common);
  if (result.tight_regions) say_tight_places(*result.tight_regions, common);
  if (result.release) say_release(*result.release, common);
  for (const WrapFigure& wrap : judgement.wraps) {
    common.say("wraps " + wrap.part + ": " + percent(wrap.fraction));
    if (std::abs(wrap.slid) < far_to_slide) continue;
    std::ostringstream line;
    line << "the garment " << (wrap.slid > 0 ? "slid down " : "rode up ") << wrap.part << " by "
         << std::setprecision(2) << 100 * std::abs(wrap.slid) << " cm from where it was placed";
    CommonSettings::warn(line.str());
  }
  if (result.placement.points_inside > 0) {
    CommonSettings::warn(
        std::to_string(result.placement.points_inside) +
        " points of the panels start inside the body, or a layer on it: place the panels clear of "
        "it");
  }
  if (figures.strain_off_seams.p99 > suspicious_strain) {
    CommonSettings::warn("the cloth is strained by " + percent(figures.strain_off_seams.p99) +
                         " in places: the garment is too small for this body, or caught on it");
  }
  warn_of_verdict(result, judgement);
  common.say("verdict: " + judgement.verdict);
}

}  // namespace toile
