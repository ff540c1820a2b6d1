#include "io/measure_names.h"

#include <algorithm>
#include <array>

namespace toile {

namespace {

constexpr MeasureName body(std::string_view name) { return {name}; }
constexpr MeasureName side(std::string_view name) { return {name, MeasureUnit::length, true}; }

constexpr std::array names = {
    body("height"),
    body("bust"),
    body("underbust"),
    body("waist"),
    body("abdomen"),
    body("hip"),
    body("neck"),
    body("neck_base"),
    body("front_centre_length"),
    body("back_centre_length"),
    side("front_full_length"),
    side("back_full_length"),
    side("front_shoulder_slope"),
    side("back_shoulder_slope"),
    MeasureName{"shoulder_angle", MeasureUnit::degrees, true},
    side("front_strap"),
    side("back_strap"),
    side("bust_depth"),
    side("bust_radius"),
    body("bust_span"),
    side("side_length"),
    side("back_neck"),
    side("shoulder_length"),
    side("front_across_shoulder"),
    side("back_across_shoulder"),
    side("across_chest"),
    side("across_back"),
    side("bust_arc"),
    side("back_arc"),
    side("front_waist_arc"),
    side("back_waist_arc"),
    side("dart_placement"),
    side("front_abdominal_arc"),
    side("back_abdominal_arc"),
    side("front_hip_arc"),
    side("back_hip_arc"),
    body("front_hip_depth"),
    body("back_hip_depth"),
    side("side_hip_depth"),
    side("vertical_trunk"),
    side("waist_to_ankle"),
    side("waist_to_floor"),
    side("waist_to_knee"),
    body("waist_to_hip"),
    body("crotch_depth"),
    body("crotch_length"),
    body("inside_leg"),
    side("upper_thigh"),
    side("mid_thigh"),
    side("knee"),
    side("calf"),
    side("ankle"),
    side("upper_arm"),
    side("elbow"),
    side("forearm"),
    side("wrist"),
    side("arm_length"),
    body("head"),
    body("bust_height"),
    body("waist_height"),
    body("hip_height"),
    body("crotch_height"),
    side("knee_height"),
    body("cervicale_height"),
    body("shoulder_width"),
    body("seat_span"),
    side("armscye_depth"),
    MeasureName{"arm_angle", MeasureUnit::degrees, true},
    MeasureName{"hip_angle", MeasureUnit::degrees, true},
};

// SeamlyMe's neck_circ lies at the neck's base, neck_mid_circ half-way up, where ISO 8559-1
// measures the neck. Its "highhip" is where the abdomen stands out the most.
std::vector<ForeignMeasure> valentina() {
  return {
      {"height", {{"height"}}},
      {"height_neck_back", {{"cervicale_height"}}},
      {"height_bustpoint", {{"bust_height"}}},
      {"height_waist_side", {{"waist_height"}}},
      {"height_hip", {{"hip_height"}}},
      {"height_knee", {{"knee_height"}}},
      {"height_waist_side_to_hip", {{"waist_to_hip"}}},
      {"head_circ", {{"head"}}},
      {"neck_mid_circ", {{"neck"}}},
      {"neck_circ", {{"neck_base"}}},
      {"bust_circ", {{"bust"}}},
      {"lowbust_circ", {{"underbust"}}},
      {"waist_circ", {{"waist"}}},
      {"highhip_circ", {{"abdomen"}}},
      {"hip_circ", {{"hip"}}},
      {"neck_arc_half_b", {{"back_neck"}}},
      {"bust_arc_f", {{"bust_arc", 2}}},
      {"bust_arc_b", {{"back_arc", 2}}},
      {"waist_arc_f", {{"front_waist_arc", 2}}},
      {"waist_arc_b", {{"back_waist_arc", 2}}},
      {"highhip_arc_f", {{"front_abdominal_arc", 2}}},
      {"highhip_arc_b", {{"back_abdominal_arc", 2}}},
      {"hip_arc_f", {{"front_hip_arc", 2}}},
      {"hip_arc_b", {{"back_hip_arc", 2}}},
      {"body_torso_circ", {{"vertical_trunk"}}},
      {"neck_front_to_waist_f", {{"front_centre_length"}}},
      {"neck_back_to_waist_b", {{"back_centre_length"}}},
      {"neck_side_to_waist_f", {{"front_full_length"}}},
      {"neck_side_to_waist_b", {{"back_full_length"}}},
      {"armpit_to_waist_side", {{"side_length"}}},
      {"shoulder_tip_to_waist_front", {{"front_shoulder_slope"}}},
      {"shoulder_tip_to_waist_back", {{"back_shoulder_slope"}}},
      {"shoulder_slope_neck_side_angle", {{"shoulder_angle"}}},
      {"neck_side_to_bust_side_f", {{"front_strap"}}},
      {"neck_side_to_bust_side_b", {{"back_strap"}}},
      {"shoulder_length", {{"shoulder_length"}}},
      {"neck_front_to_shoulder_tip_f", {{"front_across_shoulder"}}},
      {"neck_back_to_shoulder_tip_b", {{"back_across_shoulder"}}},
      {"across_chest_f", {{"across_chest", 2}}},
      {"across_back_b", {{"across_back", 2}}},
      {"bustpoint_to_neck_side", {{"bust_depth"}}},
      {"bustpoint_to_lowbust", {{"bust_radius"}}},
      {"bustpoint_to_bustpoint", {{"bust_span"}}},
      {"waist_to_hip_f", {{"front_hip_depth"}}},
      {"waist_to_hip_b", {{"back_hip_depth"}}},
      {"waist_to_hip_side", {{"side_hip_depth"}}},
      {"arm_shoulder_tip_to_wrist", {{"arm_length"}}},
      {"arm_upper_circ", {{"upper_arm"}}},
      {"arm_elbow_circ", {{"elbow"}}},
      {"arm_wrist_circ", {{"wrist"}}},
      {"leg_crotch_to_floor", {{"inside_leg"}}},
      {"leg_waist_side_to_floor", {{"waist_to_floor"}}},
      {"leg_waist_side_to_ankle", {{"waist_to_ankle"}}},
      {"leg_waist_side_to_knee", {{"waist_to_knee"}}},
      {"leg_thigh_upper_circ", {{"upper_thigh"}}},
      {"leg_thigh_mid_circ", {{"mid_thigh"}}},
      {"leg_knee_circ", {{"knee"}}},
      {"leg_calf_circ", {{"calf"}}},
      {"leg_ankle_circ", {{"ankle"}}},
      {"crotch_length", {{"crotch_length"}}},
      {"rise_length_side", {{"crotch_depth"}}},
  };
}

// FreeSewing's hips are at the hip bone, its seat is the largest girth below.
std::vector<ForeignMeasure> freesewing() {
  return {
      {"ankle", {{"ankle"}}},
      {"biceps", {{"upper_arm"}}},
      {"bustFront", {{"bust_arc", 2}}},
      {"bustPointToUnderbust", {{"bust_radius"}}},
      {"bustSpan", {{"bust_span"}}},
      {"chest", {{"bust"}}},
      {"crossSeam", {{"crotch_length"}}},
      {"crotchDepth", {{"crotch_depth"}}},
      {"head", {{"head"}}},
      {"hips", {{"abdomen"}}},
      {"hpsToBust", {{"bust_depth"}}},
      {"hpsToWaistBack", {{"back_full_length"}}},
      {"hpsToWaistFront", {{"front_full_length"}}},
      {"inseam", {{"inside_leg"}}},
      {"knee", {{"knee"}}},
      {"neck", {{"neck"}}},
      {"seat", {{"hip"}}},
      {"seatBack", {{"back_hip_arc", 2}}},
      {"shoulderSlope", {{"shoulder_angle"}}},
      {"shoulderToShoulder", {{"back_across_shoulder", 2}}},
      {"shoulderToWrist", {{"arm_length"}}},
      {"underbust", {{"underbust"}}},
      {"upperLeg", {{"upper_thigh"}}},
      {"waist", {{"waist"}}},
      {"waistBack", {{"back_waist_arc", 2}}},
      {"waistToArmpit", {{"side_length"}}},
      {"waistToFloor", {{"waist_to_floor"}}},
      {"waistToKnee", {{"waist_to_knee"}}},
      {"waistToSeat", {{"waist_to_hip"}}},
      {"wrist", {{"wrist"}}},
  };
}

// GarmentCode's head_l goes from the nape to the crown, vert_bust_line from the nape down to the
// height of the bust.
std::vector<ForeignMeasure> garmentcode() {
  return {
      {"arm_length", {{"arm_length"}}},
      {"arm_pose_angle", {{"arm_angle"}}},
      {"armscye_depth", {{"armscye_depth"}}},
      {"back_width", {{"back_arc", 2}}},
      {"bum_points", {{"seat_span"}}},
      {"bust", {{"bust"}}},
      {"bust_line", {{"bust_depth"}}},
      {"bust_points", {{"bust_span"}}},
      {"crotch_hip_diff", {{"crotch_depth", 1}, {"waist_to_hip", -1}}},
      {"head_l", {{"height", 1}, {"cervicale_height", -1}}},
      {"height", {{"height"}}},
      {"hip_back_width", {{"back_hip_arc", 2}}},
      {"hip_inclination", {{"hip_angle"}}},
      {"hips", {{"hip"}}},
      {"hips_line", {{"waist_to_hip"}}},
      {"leg_circ", {{"upper_thigh"}}},
      {"neck_w", {{"back_neck", 2}}},
      {"shoulder_incl", {{"shoulder_angle"}}},
      {"shoulder_w", {{"shoulder_width"}}},
      {"underbust", {{"underbust"}}},
      {"vert_bust_line", {{"cervicale_height", 1}, {"bust_height", -1}}},
      {"waist", {{"waist"}}},
      {"waist_back_width", {{"back_waist_arc", 2}}},
      {"waist_line", {{"back_centre_length"}}},
      {"waist_over_bust_line", {{"front_full_length"}}},
      {"wrist", {{"wrist"}}},
  };
}

}  // namespace

std::span<const MeasureName> measure_names() { return names; }

const MeasureName* find_measure_name(std::string_view name) {
  if (name == "chest") name = "bust";
  const auto found = std::ranges::find(names, name, &MeasureName::name);
  return found == names.end() ? nullptr : &*found;
}

const std::vector<ForeignMeasure>& foreign_measures(DraftingProgram program) {
  static const std::array<std::vector<ForeignMeasure>, 3> tables = {valentina(), freesewing(),
                                                                    garmentcode()};
  return tables[static_cast<std::size_t>(program)];
}

}  // namespace toile
