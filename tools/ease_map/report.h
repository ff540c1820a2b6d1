// The ease map as files for programs: statistics, a table, a coloured mesh.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/ease.h"
#include "cloth/ease/ease_targets.h"
#include "cloth/ease/worn_figures.h"
#include "cloth/loads/load_summary.h"
#include "cloth/loads/loads.h"
#include "io/mesh_file.h"
#include "pattern/measure/spec_sheet.h"
#include "tools/ease_map/dress_report.h"

namespace toile {

/// Another drape of the garment.
struct RepeatedDrape {
  std::string file;
  std::string verdict;  ///< empty: there is no report of dress
};

/// All that the files say.
struct EaseReport {
  DressedGarment garment;
  TriangleMesh body;
  EaseMap map;
  EaseOptions options;
  WornFigures figures;                  ///< empty: not measured
  std::vector<RepeatedDrape> repeats;   ///< that the errors of `figures` are taken from
  std::optional<Loads> loads;           ///< none: not known, a note says why
  LoadRows load_rows;                   ///< of panels and girths
  std::string target;                   ///< name of the ease meant; empty: not asked for
  std::vector<TargetFinding> targets;   ///< levels against it
  std::optional<DressReport> dressing;  ///< none: there is no report of dress
  std::vector<Warning> warnings;        ///< of the dressing and of the ease map
  std::vector<std::string> notes;       ///< what could not be told, and why
  std::string garment_name;             ///< shown in titles
  std::string body_name;
  std::string against;  ///< what the other drape is called; empty: there is none
  std::shared_ptr<const EaseReport> other;  ///< beside which this one is shown; null: none
  std::string size;                         ///< of the pattern; empty: not known
  std::vector<MeasuredPoint> points;        ///< of measure
  std::string garment_file;                 ///< name without its folder
  std::string body_file;
  double top = 0;  ///< gap that gets the scale's last colour, metres, positive
};

/// A round gap that most of the cloth is below: a scale's end that suits the garment.
double suggested_top(const EaseMap& map);

/// One row a point of the garment, in the order of EaseMap::points, under the header
/// panel,u_m,v_m,x_m,y_m,z_m,gap_mm. Where loads are known, these columns follow:
/// strain_warp_percent,
/// strain_weft_percent,strain_bias_percent,tension_warp_N_per_m,tension_weft_N_per_m,pressure_kPa,
/// friction_kPa. Quoted as RFC 4180 says.
std::string ease_csv(const EaseReport& report);

/// Statistics of the garment and of each panel that has points, and girths, as JSON.
nlohmann::ordered_json ease_json(const EaseReport& report);

/// "sewn, too small by 2.0 cm at the hip": the verdict with the fit. There is a report of dress.
std::string dressing_line(const EaseReport& report);

/// The colour and gap of each node, and the loads of nodes and triangles where they are known.
MeshProperties ease_properties(const EaseReport& report);

/// A few lines for the terminal.
std::vector<std::string> ease_summary(const EaseReport& report);

}  // namespace toile
