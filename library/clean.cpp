#include "toile/clean.h"

#include <nlohmann/json.hpp>

#include "io/json_words.h"
#include "library/rooms.h"
#include "tools/clean_body/run.h"
#include "tools/clean_body/scan.h"
#include "tools/make_mannequin/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

namespace {

std::optional<AxisDirection> direction_in(const std::string& axis, const std::string& name) {
  if (axis.empty()) return std::nullopt;
  const std::optional<AxisDirection> direction = axis_direction(axis);
  if (!direction) throw Error(name, in_quotes(axis) + " is no axis", "use x, -x, y, -y, z or -z");
  return direction;
}

void check_range(const std::optional<double>& metres, double least, double most,
                 const std::string& name) {
  if (!metres || (*metres >= least && *metres <= most)) return;
  throw Error(name, number_text(*metres) + " m is out of range",
              "use " + number_text(least) + " to " + number_text(most));
}

CleanBodySettings clean_settings(const CleanChoices& choices) {
  check_range(choices.height, 0.3, 3, "height");
  check_range(choices.edge_length, 0.003, 0.02, "edge_length");
  check_range(choices.metres_per_unit, 1e-9, 1e9, "metres_per_unit");
  CleanBodySettings settings;
  settings.metres_per_unit = choices.metres_per_unit;
  settings.height = choices.height;
  settings.up = direction_in(choices.up, "up");
  settings.front = direction_in(choices.front, "front");
  settings.as_points = choices.as_points;
  settings.edge_length = choices.edge_length;
  return settings;
}

Body cleaned_out(BodyInput input, const std::optional<Skeleton>& joints,
                 const std::string& joints_name, const CleanBodySettings& settings) {
  const CommonSettings common = settings_of("clean-body");
  const CleanedInput cleaned = clean_input(input, joints, joints_name, settings, common);
  Body body = body_out(cleaned.body.mesh, cleaned.body.skeleton, cleaned.landmarks);
  body.report = report_text(common, cleaned_json(cleaned, input));
  return body;
}

}  // namespace

Body clean(const Mesh& mesh, const CleanChoices& choices) {
  return guarded([&] {
    const CleanBodySettings settings = clean_settings(choices);
    TriangleMesh read = mesh_in(mesh.points, mesh.triangles, "mesh");
    BodyInput input;
    input.name = "mesh";
    if (read.triangles.empty() || settings.as_points) {
      input.scan.points = std::move(read.points);
    } else {
      input.soup.points = std::move(read.points);
      for (const Triangle& t : read.triangles) input.soup.polygons.push_back({t[0], t[1], t[2]});
    }
    return cleaned_out(std::move(input), std::nullopt, "", settings);
  });
}

Body clean(const std::vector<std::filesystem::path>& files, const CleanChoices& choices) {
  return guarded([&] {
    if (files.empty()) throw Error("files", "are none", "name a mesh or a scan");
    CleanBodySettings settings = clean_settings(choices);
    settings.inputs = files;
    const auto [joints, name] = joints_beside(settings);
    return cleaned_out(read_body_input(settings), joints, name, settings);
  });
}

Body mannequin(const std::map<std::string, double>& measures, const std::string& figure) {
  return guarded([&] {
    MakeMannequinSettings settings;
    settings.mannequin.pose_name = "standing";
    settings.mannequin.edge_length =
        parse_length("9mm", "edge_length");  // the program's, to the bit
    if (!figure.empty() && figure != "woman" && figure != "man" && figure != "child") {
      throw Error("figure", in_quotes(figure) + " is none of woman, man, child", "");
    }
    if (!measures.empty() || !figure.empty()) {
      settings.measures.emplace();
      settings.measures->figure = figure;
      settings.measures->scales_edges = true;
      for (const auto& [name, centimetres] : measures) {
        settings.measures->measures.push_back(name + "=" + number_text(centimetres, 17));
      }
    }
    const CommonSettings common = settings_of("make-mannequin");
    const MadeMannequin made = made_mannequin(settings, common);
    Body body = body_out(made.mannequin.surface, made.mannequin.skeleton, made.landmarks);
    body.report = report_text(common, made.report);
    return body;
  });
}

}  // namespace library
}  // namespace toile
