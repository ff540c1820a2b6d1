#include "tools/clean_body/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/report.h"

namespace toile {

double largest_hole(const RepairReport& report) {
  double largest = 0;
  for (const FilledHole& hole : report.holes_filled) largest = std::max(largest, hole.across);
  return largest;
}

nlohmann::ordered_json clean_body_json(const CleanBody& body, bool skeleton_given,
                                       const std::vector<std::string>& warnings) {
  const CleanReport& report = body.report;
  const RepairReport& r = report.repair;
  const double unit = report.metres_per_unit;
  return {{"read", {{"points", r.points_read}, {"polygons", r.polygons_read}}},
          {"changed",
           {{"points_merged", r.points_merged},
            {"polygons_removed", r.polygons_removed},
            {"polygons_triangulated", r.polygons_triangulated},
            {"points_split", r.points_split},
            {"borders_stitched", r.borders_stitched},
            {"components_dropped", r.components_dropped},
            {"dropped_area_percent", 100 * r.dropped_area},
            {"holes_filled", r.holes_filled.size()},
            {"largest_hole_filled_mm", 1000 * unit * largest_hole(r)},
            {"turned_inside_out", r.turned_inside_out},
            {"largest_move_mm", 1000 * unit * r.largest_move},
            {"turned", report.turned},
            {"turned_degrees", report.turned_degrees},
            {"levelled_degrees", report.levelled_degrees},
            {"lifted_mm", 1000 * report.lifted},
            {"brought_m", {report.brought.x(), report.brought.z()}}}},
          {"self_intersections",
           {{"found", r.self_intersections_found},
            {"left", r.self_intersections_left},
            {"area_percent", report.crossings ? 100 * report.crossings->area_share : 0}}},
          {"unit", {{"metres", unit}, {"inferred", report.unit_inferred}}},
          {"body",
           {{"points", body.mesh.points.size()},
            {"triangles", body.mesh.triangles.size()},
            {"height_m", report.height},
            {"usable", is_usable(report.crossings)}}},
          {"skeleton", body.skeleton.has_value()},
          {"skeleton_given", skeleton_given},
          {"warnings", warnings_json(warnings_of("body", warnings))}};
}

}  // namespace toile
