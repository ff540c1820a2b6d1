#include "tools/dress/report.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/text.h"
#include "pattern/classify/panel_class_json.h"
#include "tools/dress/extra_offset.h"
#include "tools/report.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

Json residual_json(const Residual& residual) {
  return {{"median", residual.median},
          {"rms", residual.rms},
          {"max", residual.max},
          {"wide", residual.wide},
          {"held_nodes", residual.held}};
}

Json stages_json(const std::vector<StageReport>& stages) {
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

Json strain_json(const StrainStatistics& strain) {
  return {{"max", strain.max}, {"p99", strain.p99}, {"rms", strain.rms}};
}

Json release_json(const ReleaseReport& release) {
  return {{"seconds", release.seconds},
          {"moved_mm", moved_json(release.all)},
          {"held_nodes", release.sticking},
          {"crept_mm", moved_json(release.of_sticking)},
          {"stays", release.stays()},
          {"end_speed_p99_mm_per_s", 1000 * release.speed_p99},
          {"end_kinetic_energy_J", release.kinetic},
          {"energy_given_up_J", release.released_energy},
          {"time_step_s", release.time_step},
          {"steps", release.steps},
          {"searches", release.searches},
          {"wall_seconds", release.wall_seconds}};
}

Json tight_regions_json(const std::vector<TightRegion>& regions) {
  Json all = Json::array();
  for (const TightRegion& region : regions) {
    all.push_back({{"panel", region.panel},
                   {"flat_cm", {100 * region.flat.x(), 100 * region.flat.y()}},
                   {"height_cm", 100 * region.height},
                   {"area_cm2", 1e4 * region.area},
                   {"direction", region.along_warp ? "warp" : "weft"},
                   {"largest_percent", 100 * region.largest},
                   {"mean_percent", 100 * region.mean},
                   {"missing_cm", 100 * region.missing}});
  }
  return all;
}

Json attachments_json(const std::vector<AttachmentMeasurement>& attachments) {
  Json all = Json::array();
  for (const AttachmentMeasurement& measured : attachments) {
    if (!measured.used) continue;
    Json json = {
        {"name", measured.name},
        {"to", measured.to},
        {"while", measured.always ? "always" : "dressing"},
        {"off_mm", {{"mean", 1000 * measured.off_mean}, {"max", 1000 * measured.off_max}}}};
    if (measured.always) {
      json["force_N"] = measured.pull.norm();
      json["pull_N"] = {measured.pull.x(), measured.pull.y(), measured.pull.z()};
    }
    all.push_back(std::move(json));
  }
  return all;
}

Json certified_json(const Certificate& certificate) {
  Json json;
  const std::optional<int> clean_from = certificate.clean_from();
  json["clean_from_frame"] = clean_from ? Json(*clean_from) : Json();
  json["clean_from_stage"] = clean_from ? Json(certificate.frames()[*clean_from].stage) : Json();
  json["stayed_clean"] = certificate.stayed_clean();
  json["check"] = "exact";
  json["frames"] = Json::array();
  for (const FrameCheck& frame : certificate.frames()) {
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

Json garment_json(const WornLayer& layer) {
  return {{"nodes", layer.result.nodes.size()},
          {"material_points", layer.garment.flat.size()},
          {"triangles", layer.garment.triangles.size()},
          {"panels", layer.garment.panels.size()},
          {"seams", layer.garment.seams.size()}};
}

Json panels_json(const PanelMesh& garment) {
  Json all = Json::array();
  for (const MeshedPanel& panel : garment.panels) {
    all.push_back({{"name", panel.name},
                   {"grain_degrees", degrees(panel.grain)},
                   {"is", text_of(panel.is)},
                   {"class", panel_class_json(panel.is)}});
  }
  return all;
}

/// Where the panels started, and what was done to bring them there.
Json start_json(const Placement& placement) {
  Json json;
  json["points_inside_at_start"] = placement.points_inside;
  json["seam_pairs_inside_at_start"] = placement.seams_inside;
  json["lift_mm"] = 1000 * placement.lift;
  for (const auto& [part, angle] : placement.turned) {
    json["turned_degrees"][name_of(part)] = angle * 180 / std::numbers::pi;
  }
  for (const PositionedPanel& panel : placement.positioned) {
    Json entry = {{"panel", panel.panel}, {"rolled", panel.rolled}, {"bent", panel.bent}};
    entry[panel.rolled ? "radius_mm" : "distance_mm"] = 1000 * panel.distance;
    if (panel.rolled) {
      entry["gap_mm"] = 1000 * panel.gap;
      entry["drawn_out_mm"] = 1000 * panel.drawn_out;
      entry["points_too_near"] = panel.points_too_near;
    }
    json["positioned"].push_back(entry);
  }
  for (const auto& [panel, distance] : placement.moved_off_layers) {
    json["moved_off_layers_mm"][panel] = 1000 * distance;
  }
  for (const auto& [panel, distance] : placement.moved_clear) {
    json["moved_clear_mm"][panel] = 1000 * distance;
  }
  return json;
}

/// How all panels were moved together to where the body is.
Json layout_moved_json(const LayoutMove& move) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    rotation.push_back({move.rotation(row, 0), move.rotation(row, 1), move.rotation(row, 2)});
  }
  const Vec3& by = move.translation;
  return {{"rotation", rotation},
          {"translation_mm", {1000 * by.x(), 1000 * by.y(), 1000 * by.z()}},
          {"as_body", move.as_body}};
}

/// Where panels were placed whose pattern did not tell.
Json places_json(const WornLayer& layer) {
  Json panels = Json::array();
  for (const FoundPlace& place : layer.places) {
    panels.push_back({{"panel", place.panel},
                      {"part", name_of(place.part)},
                      {"side", side_name(place.side)},
                      {"around", place.around},
                      {"asked", place.asked}});
  }
  return {{"reason", layer.place_reason}, {"panels", panels}};
}

/// How far a garment went on from an earlier drape.
Json continued_json(const ContinuedDress& continued) {
  if (!continued.refusal.empty()) {
    return {{"from_flat_panels", continued.refusal}, {"seconds", continued.seconds}};
  }
  return {{"outside_mm", 1000 * continued.outside}, {"seconds", continued.seconds}};
}

/// The fabrics that panels are cut from, with what the drape was computed with.
Json fabrics_json(const WornLayer& layer) {
  std::map<const Fabric*, Json> panels;
  std::vector<const Fabric*> fabrics;
  for (const MeshedPanel& panel : layer.garment.panels) {
    const Fabric* fabric = &fabric_of(layer.scene, panel);
    if (!panels.contains(fabric)) fabrics.push_back(fabric);
    panels[fabric].push_back(valid_utf8(panel.name));
  }
  Json all = Json::array();
  for (const Fabric* fabric : fabrics) {
    all.push_back({{"panels", panels[fabric]}, {"quantities", fabric_json(*fabric)}});
  }
  return all;
}

/// What was simulated.
Json scene_json(const WornLayer& layer) {
  const DressResult& result = layer.result;
  const Scene& scene = layer.scene;
  Json json;
  for (const auto& [term, count] : result.terms) json["terms"][term] = count;
  json["fabric"] = scene.fabric.name;
  json["fabrics"] = fabrics_json(layer);
  json["gravity_m_per_s2"] = {scene.gravity.x(), scene.gravity.y(), scene.gravity.z()};
  json["body_offset_mm"] = 1000 * result.body_offset;
  if (const ExtraOffset extra = extra_offset_of(result.extra_offset); extra.nodes > 0) {
    json["extra_offset"] = {{"nodes", extra.nodes}, {"max_mm", 1000 * extra.max}};
  }
  json.update(start_json(result.placement));
  if (!layer.places.empty()) json["placed_by_seams"] = places_json(layer);
  if (layer.continued) json["continued"] = continued_json(*layer.continued);
  if (layer.moved) json["layout_moved"] = layout_moved_json(*layer.moved);
  return json;
}

/// How the cloth is strained and sheared, and what that does to its panels.
Json shape_json(const GarmentMeasurements& measured, const DuringDressing& during) {
  Json json;
  json["strain"] = strain_json(measured.strain);
  json["strain_off_seams"] = strain_json(measured.strain_off_seams);
  json["warp_weft_strain"] = strain_json(measured.warp_weft_strain);
  json["shear_degrees"] = {{"max", degrees(measured.shear.max)},
                           {"p99", degrees(measured.shear.p99)},
                           {"rms", degrees(measured.shear.rms)}};
  json["area_change_percent"] = {{"total", 100 * measured.area_total},
                                 {"max_panel", 100 * measured.area_max_panel},
                                 {"max_during", 100 * during.area}};
  json["perimeter_change_percent"] = {
      {"max_panel", 100 * measured.perimeter_max_panel},
      {"max_during", 100 * during.perimeter},
      {"triangles_max_panel", 100 * measured.triangle_perimeter_max_panel}};
  return json;
}

Json elastics_json(const std::vector<ElasticMeasurement>& elastics) {
  Json all = Json::array();
  for (const ElasticMeasurement& segment : elastics) {
    all.push_back({{"name", segment.name},
                   {"flat_cm", 100 * segment.flat},
                   {"rest_cm", 100 * segment.rest},
                   {"worn_cm", 100 * segment.now},
                   {"tension_N", segment.tension}});
  }
  return all;
}

Json wraps_json(const Judgement& judgement) {
  Json all = Json::array();
  for (const WrapMeasurement& wrap : judgement.wraps) {
    const bool slid = wrap.part == BodyPart::torso && judgement.worn.slid;
    all.push_back({{"part", name_of(wrap.part)},
                   {"fraction", wrap.fraction},
                   {"slid_cm", slid ? 100 * judgement.worn.slid->down : 0},
                   {"from_m", wrap.from},
                   {"to_m", wrap.to}});
  }
  return all;
}

std::string around_words(const LimbsThrough& limbs) {
  if (!limbs.any()) return "nothing";
  if (limbs == through_neckline) return "neck";
  if (limbs == through_hem) return "trunk";
  std::string words;
  const auto add = [&](bool is_through, const char* limb) {
    if (!is_through) return;
    if (!words.empty()) words += ", ";
    words += limb;
  };
  add(limbs.left_arm, "left arm");
  add(limbs.right_arm, "right arm");
  add(limbs.left_leg, "left leg");
  add(limbs.right_leg, "right leg");
  return words;
}

Json openings_json(const std::vector<Opening>& openings) {
  Json all = Json::array();
  for (const Opening& opening : openings) {
    all.push_back({{"around", around_words(opening.limbs)},
                   {"length_cm", 100 * opening.length},
                   {"height_cm", 100 * opening.middle.y()},
                   {"is_cut_out", opening.is_cut_out}});
  }
  return all;
}

/// The garment's edges and its waist seam, where they rest and where they were drafted to lie.
Json levels_json(const Judgement& judgement) {
  Json all = Json::array();
  for (const GarmentLevel& level : judgement.levels) {
    Json row = {
        {"name", level.name}, {"as_cut_cm", 100 * level.as_cut}, {"height_cm", 100 * level.height}};
    if (level.drafted) {
      row["drafted_height_cm"] = 100 * *level.drafted;
      row["risen_cm"] = 100 * *level.risen();
    }
    row["plus_minus_height_cm"] = 100 * judgement.height_error;
    if (level.drafted_body) {
      row["drafted_body_cm"] = 100 * *level.drafted_body;
      row["plus_minus_drafted_body_cm"] = 100 * level.drafted_body_error;
    }
    all.push_back(std::move(row));
  }
  return all;
}

/// The verdict, and what it names.
Json verdict_json(const WornLayer& layer) {
  const DressResult& result = layer.result;
  const Judgement& judgement = layer.judgement;
  std::vector<std::string> panels;
  panels.reserve(layer.garment.panels.size());
  for (const MeshedPanel& panel : layer.garment.panels) panels.push_back(panel.name);
  const Json fit = fit_json(judgement.fit, to_string(judgement.fit), panels);
  Json json;
  // What crosses may cross because it is cut too small: that comes first.
  if (judgement.verdict == Verdict::intersecting) json["fit"] = fit;
  json["verdict"] = to_string(judgement.verdict);
  json["fit"] = fit;
  for (const OpenSeam& seam : judgement.garment.seams.open_seams) {
    json["unsewable_seams"].push_back({{"name", seam.name}, {"gap_cm", 100 * seam.gap}});
  }
  for (const TightSeam& seam : result.tight_seams) {
    json["tight_seams"].push_back({{"name", seam.name},
                                   {"tension_N_per_m", seam.tension},
                                   {"missing_cm", 100 * seam.missing}});
  }
  if (result.tight_regions) {
    json["tight_regions"] = tight_regions_json(result.tight_regions->regions);
    json["tight_specks"] = result.tight_regions->specks;
  }
  if (!judgement.garment.overstretched.empty()) {
    json["overstretched"] = tight_regions_json(judgement.garment.overstretched);
  }
  if (judgement.asymmetry) json["asymmetry_cm"] = 100 * judgement.asymmetry->largest;
  const WearFindings& worn = judgement.worn;
  json["worn"] = worn.is_checked ? "checked" : "not_checked";
  if (worn.misplaced) {
    json["misplaced"] = {{"part", name_of(worn.misplaced->part)},
                         {"at", worn.misplaced->at},
                         {"should_be", worn.misplaced->should_be}};
  }
  for (const BodyPart part : worn.unwrapped) json["unwrapped"].push_back(name_of(part));
  return json;
}

/// The preset that a garment was draped by, and its error on other garments.
Json quality_json(const Quality& quality) {
  const double rms = std::round(1e5 * quality.distance_rms) / 100;  // as measured, to 0.01 mm
  return {{"quality", quality.name},
          {"preset_error",
           {{"node_distance_rms_mm", rms},
            {"against", "the same run brought to rest"},
            {"measured_on", measured_on}}}};
}

}  // namespace

nlohmann::ordered_json judged_json(const WornLayer& layer) {
  const Judgement& judgement = layer.judgement;
  const GarmentMeasurements& measured = judgement.garment;
  Json report;
  report["seams"] = {{"sewn", measured.seams.sewn},
                     {"open", measured.seams.open},
                     {"max_gap_mm", 1000 * measured.seams.max_gap}};
  if (!measured.elastics.empty()) report["elastics"] = elastics_json(measured.elastics);
  report["wraps"] = wraps_json(judgement);
  report["borders"] = measured.borders;
  report["openings"] = openings_json(judgement.worn.openings);
  if (!judgement.levels.empty()) report["levels"] = levels_json(judgement);
  report["intersections"] = {{"body", judgement.body_intersections},
                             {"self", judgement.self_intersections},
                             {"layers", judgement.layer_intersections},
                             {"check", "exact"}};
  report.update(verdict_json(layer));
  return report;
}

nlohmann::ordered_json layer_json(const WornLayer& layer, const DressMethod& method,
                                  const LayerNotes& notes) {
  const DressResult& result = layer.result;
  Json report;
  report["inputs"] = {{"body", notes.body}, {"garment", notes.garment}};
  if (!notes.standing.empty()) report["inputs"]["from"] = notes.standing;
  if (!notes.earlier.empty()) report["inputs"]["continue"] = notes.earlier;
  report["dressed_sha256"] = notes.dressed_sha256;
  report["garment"] = garment_json(layer);
  report["panels"] = panels_json(layer.garment);
  report["scene"] = scene_json(layer);
  report["method"] = method.name;
  if (result.time_step > 0) report["time_step_s"] = result.time_step;
  report["stages"] = stages_json(result.stages);
  report["seconds"] = notes.seconds;
  report["converged"] = result.converged;
  report["residual"] = residual_json(result.residual);
  if (result.release) report["release"] = release_json(*result.release);
  report.update(shape_json(layer.judgement.garment, result.during));
  if (!result.attachments.empty()) report["attachments"] = attachments_json(result.attachments);
  report.update(judged_json(layer));
  report["warnings"] = warnings_json(notes.warnings);
  report["other_seconds"] = Json::object();
  for (const auto& [what, seconds] : notes.other_seconds) report["other_seconds"][what] = seconds;
  report["body_distances_computed"] = layer.distances_computed;
  if (method.quality) report.update(quality_json(*method.quality));
  if (layer.certificate) report["certified"] = certified_json(*layer.certificate);
  return report;
}

nlohmann::ordered_json coupled_json(const WornOutfit& worn, const std::vector<std::string>& names) {
  const CoupledResult& coupled = *worn.coupled;
  Json json = {{"stages", stages_json(coupled.stages)},
               {"converged", coupled.converged},
               {"residual", residual_json(coupled.stages.back().residual)},
               {"contacts", Json::array()}};
  for (const LayerContact& pressing : coupled.contacts) {
    json["contacts"].push_back({{"inner", names[pressing.inner]},
                                {"outer", names[pressing.outer]},
                                {"force_N", pressing.force},
                                {"area_m2", pressing.area},
                                {"mean_Pa", pressing.force / pressing.area}});
  }
  if (worn.coupled_certificate) json["certified"] = certified_json(*worn.coupled_certificate);
  return json;
}

nlohmann::ordered_json moved_json(const MoveStatistics& moved) {
  return {{"median", 1000 * moved.median}, {"p99", 1000 * moved.p99}, {"max", 1000 * moved.max}};
}

}  // namespace toile
