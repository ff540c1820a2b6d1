// What mesh-pattern does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "pattern/mesh/mesh_panels.h"
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

/// Meshes the pattern, writes garment.obj and garment.garment.json. Throws Error for a pattern
/// that can't be read or meshed. Returns the warnings that were said.
std::vector<std::string> run_mesh_pattern(const MeshPatternSettings& settings,
                                          const CommonSettings& common);

}  // namespace toile
