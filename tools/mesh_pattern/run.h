// What mesh-pattern does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "pattern/mesh/mesh_panels.h"
#include "pattern/panel_mesh.h"
#include "pattern/pattern.h"
#include "tools/mesh_pattern/report.h"
#include "tools/program.h"

namespace toile {

struct MeshPatternSettings {
  std::filesystem::path pattern;
  MeshSettings mesh;
  bool flat = false;  ///< the panels lie side by side instead of around the body
};

/// --edge-length, of a garment's triangles.
void add_edge_length_option(boost::program_options::options_description& options);
/// Metres. Throws UsageError for what is no length.
double read_edge_length(const boost::program_options::variables_map& given);

/// What became of a pattern.
struct MeshedPattern {
  PanelMesh garment;
  std::vector<PanelMeasurements> measured;  ///< one for each panel
  std::vector<Remark> remarks;
};

/// Checks and meshes the pattern of a file's `text`; `name` stands for the file in messages. Throws
/// Error for a pattern that can't be read or meshed.
MeshedPattern mesh_pattern(const std::string& text, const std::string& name,
                           const MeshPatternSettings& settings);

/// Meshes the pattern, writes garment.obj and garment.garment.json. Throws Error for a pattern
/// that can't be read or meshed. Returns the warnings that were said.
std::vector<std::string> run_mesh_pattern(const MeshPatternSettings& settings,
                                          const CommonSettings& common);

}  // namespace toile
