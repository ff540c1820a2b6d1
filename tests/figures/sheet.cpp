#include "tests/figures/sheet.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"
#include "pattern/file/garment_file.h"

namespace toile::figures {
namespace {

using Json = nlohmann::ordered_json;

/// "_" and the text, fit for a file's name.
std::string suffix_of(const std::string& text) {
  std::string suffix(1, '_');
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c));
    suffix += plain ? c : '_';
  }
  return suffix;
}

Json garment_row(const PaperDressing& d, const std::string& wanted) {
  const Judgement& judged = d.judgement;
  const GarmentMeasurements& g = judged.garment;
  const SpringOptions& motion = d.options.motion;
  Json row;
  row["name"] = d.name;
  row["edge_mm"] = 1000 * d.garment.edge_length;
  row["nodes"] = d.result.nodes.size();
  row["triangles"] = d.garment.triangles.size();
  row["panels"] = d.garment.panels.size();
  row["strain_control"] = motion.strain_scheme == StrainScheme::none ? "none"
                          : motion.converged_strain ? "velocity, 1 %, swept while draping"
                          : motion.strain_scheme == StrainScheme::velocity ? "velocity, 1 %"
                                                                           : "position";
  row["time_step_us"] = 1e6 * d.result.time_step;
  if (motion.time_step <= 0) {
    row["stable_step_us"] = 1e6 * d.result.time_step / motion.step_share;
  }
  row["steps"] = d.steps();
  row["simulated_s"] = d.simulated();
  row["seconds"] = d.seconds;
  row["ms_per_step"] = 1e3 * d.seconds_per_step();
  for (const StageReport& stage : d.result.stages) {
    row["stages"].push_back({{"name", stage.name},
                             {"steps", stage.steps},
                             {"simulated_s", stage.simulated},
                             {"seconds", stage.seconds},
                             {"converged", stage.converged}});
  }
  row["seams_open"] = g.seams.open;
  row["seams_sewn"] = g.seams.sewn;
  row["intersections"] = {{"body", judged.body_intersections},
                          {"self", judged.self_intersections},
                          {"layers", judged.layer_intersections}};
  row["wraps"] = Json::array();
  for (const WrapMeasurement& wrap : judged.wraps) {
    row["wraps"].push_back({{"part", name_of(wrap.part)}, {"fraction", wrap.fraction}});
  }
  row["strain_off_seams"] = {{"max", g.strain_off_seams.max},
                             {"p99", g.strain_off_seams.p99},
                             {"limit", motion.strain.limit}};
  row["strained_places"] = Json::array();
  for (const StrainedPlace& place : d.places) {
    row["strained_places"].push_back({{"panel", place.panel},
                                      {"joint", place.joint},
                                      {"edges", place.edges},
                                      {"largest", place.largest},
                                      {"longer", place.longer},
                                      {"height_m", place.at.y()}});
  }
  row["area_percent"] = {{"during", d.max_area()}, {"end", 100 * g.area_max_panel}};
  row["perimeter_percent"] = {{"during", d.max_perimeter()},
                              {"end", 100 * g.triangle_perimeter_max_panel}};
  row["residual"] = {{"median", d.result.residual.median}, {"rms", d.result.residual.rms}};
  row["verdict"] = to_string(judged.verdict);
  row["wanted"] = wanted;
  return row;
}

}  // namespace

std::string number(double value, int decimals) { return fixed_number(value, decimals); }

struct Sheet::Data {
  std::filesystem::path folder;
  std::string name;
  Json json;
};

Sheet::Sheet(std::filesystem::path folder, std::string name, const std::string& title)
    : data_(std::make_unique<Data>()) {
  std::filesystem::create_directories(folder);
  data_->folder = std::move(folder);
  data_->name = std::move(name);
  data_->json = {{"name", data_->name}, {"title", title}};
  for (const char* list : {"blocks", "comparisons", "garments"}) {
    data_->json[list] = Json::array();
  }
}

Sheet::~Sheet() = default;

void Sheet::say(const std::string& paragraph) {
  data_->json["blocks"].push_back({{"text", paragraph}});
}

void Sheet::file(const std::string& suffix, const std::string& bytes) {
  write_file(data_->folder / (data_->name + suffix), bytes);
}

void Sheet::pictures(const std::string& heading,
                     const std::vector<std::pair<std::string, std::string>>& png_and_caption) {
  Json row = Json::array();
  for (const auto& [png, caption] : png_and_caption) {
    const std::string suffix = suffix_of(heading + " " + caption) + ".png";
    file(suffix, png);
    row.push_back({{"file", data_->name + suffix}, {"caption", caption}});
  }
  data_->json["blocks"].push_back({{"heading", heading}, {"pictures", row}});
}

void Sheet::chart(const Chart& chart) {
  std::ostringstream csv;
  csv << "curve," << '"' << chart.x << "\",\"" << chart.y << "\"\n";
  Json curves = Json::array();
  for (const Curve& curve : chart.curves) {
    Json points = Json::array();
    for (const auto& [x, y] : curve.points) {
      csv << '"' << curve.name << "\"," << x << ',' << y << '\n';
      points.push_back({{"x", x}, {"y", y}});
    }
    curves.push_back({{"name", curve.name}, {"points", points}, {"dashed", curve.dashed}});
  }
  file(suffix_of(chart.title) + ".csv", csv.str());
  data_->json["blocks"].push_back(
      {{"chart", {{"title", chart.title}, {"x", chart.x}, {"y", chart.y}, {"curves", curves}}}});
}

void Sheet::table(const std::string& caption, const std::vector<std::string>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  data_->json["blocks"].push_back(
      {{"table", {{"caption", caption}, {"columns", columns}, {"rows", rows}}}});
}

void Sheet::compare(const std::string& what, const std::string& paper, const std::string& ours,
                    std::optional<bool> holds) {
  Json line = {{"what", what}, {"paper", paper}, {"ours", ours}};
  if (holds) line["holds"] = *holds;
  data_->json["comparisons"].push_back(line);
}

void Sheet::garment(const PaperDressing& dressing, const std::string& wanted) {
  data_->json["garments"].push_back(garment_row(dressing, wanted));
  const std::string stem = data_->name + suffix_of(dressing.name);
  write_dressed(data_->folder / (stem + ".obj"), dressing.dressed);
  std::ostringstream csv;
  csv << "seconds,stage,area_percent,perimeter_percent\n";
  for (const DressingMoment& m : dressing.moments) {
    csv << m.seconds << ',' << m.stage << ',' << m.largest_area() << ',' << m.largest_perimeter()
        << '\n';
  }
  write_file(data_->folder / (stem + ".csv"), csv.str());
}

void Sheet::write() { file(".json", data_->json.dump(1) + "\n"); }

int run_sheet(int argc, char** argv, void (*work)(const SheetSettings&)) {
  const std::string program = std::filesystem::path(argv[0]).filename();
  SheetSettings settings;
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: " << program << " FOLDER [EDGE_MM]\n";
    return 2;
  }
  try {
    settings.folder = argv[1];
    if (argc == 3) settings.edge_length = std::stod(argv[2]) / 1000;
    if (!(settings.edge_length >= 0.002 && settings.edge_length <= 0.1)) {
      throw Error(argv[2], "is no edge length in millimetres", "15 is the default");
    }
    work(settings);
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << "\n";
    return 1;
  }
  return 0;
}

}  // namespace toile::figures
