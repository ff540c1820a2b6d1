#include "tools/render/run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "io/output_file.h"
#include "tools/report.h"

namespace toile {

namespace {

constexpr Colour skin{0.80, 0.76, 0.73};

/// Each group (panel) becomes a region with its own colour, counted on from `legend`, which gets
/// the groups' names. With a `name`, the whole garment has one colour under that name.
PictureMesh cloth_of(const ObjData& obj, const std::string& name,
                     std::vector<LegendEntry>& legend) {
  PictureMesh cloth;
  cloth.mesh.points = obj.points;
  const int first = static_cast<int>(legend.size());
  for (const ObjFace& face : obj.faces) {
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
      cloth.mesh.triangles.push_back(
          {face.corners[0].point, face.corners[k].point, face.corners[k + 1].point});
      cloth.regions.push_back(face.group + 1);
      cloth.triangle_colours.push_back(
          quiet_colour(first + (name.empty() ? std::max(face.group, 0) : 0)));
    }
  }
  if (!name.empty()) {
    legend.push_back({quiet_colour(first), name});
    return cloth;
  }
  for (const std::string& group : obj.groups) {
    legend.push_back({quiet_colour(static_cast<int>(legend.size())), group});
  }
  return cloth;
}

}  // namespace

void run_render(const RenderSettings& settings, const CommonSettings& common) {
  Picture picture;
  picture.views = settings.views;
  picture.view_width = settings.width;
  picture.title = settings.title;
  std::vector<PictureMesh> meshes;
  for (const std::string& path : settings.garments) {
    const bool alone = settings.garments.size() == 1;
    const std::string name = alone ? "" : std::filesystem::path(path).stem().string();
    meshes.push_back(cloth_of(read_obj(path), name, picture.legend));
    if (meshes.back().mesh.triangles.empty()) {
      throw Error(path, "holds no face", "give a garment with its surface");
    }
  }
  if (!settings.body.empty()) {
    PictureMesh body;
    body.mesh = fan_triangles(read_mesh(settings.body));
    body.colour = skin;
    body.inside_shown = false;
    body.framed = settings.whole || settings.garments.empty();
    meshes.push_back(std::move(body));
  }
  if (meshes.empty()) throw Error("render", "there is nothing to show", "name a garment or a body");
  if (picture.legend.size() > 40) picture.legend.clear();
  OutputFiles files;
  write_file(files.at(common.output), picture_png(std::move(meshes), picture));
  nlohmann::ordered_json report;
  report["picture"] = common.output.string();
  report["body"] = settings.body;
  report["garments"] = settings.garments;
  for (const View view : settings.views) {
    report["views"].push_back(view_names[static_cast<std::size_t>(view)]);
  }
  report["view_width_pixels"] = settings.width;
  write_report(files, common, report);
  files.commit();
  common.say("wrote " + common.output.string());
}

}  // namespace toile
