// Which fabric is what: dress --fabric.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cloth/scene/fabric.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// What --fabric says.
struct FabricChoice {
  std::string of_garments;                   ///< a name or a file, for find_fabric()
  std::map<std::string, Fabric> of_panels;   ///< by the names that panels give
  std::vector<std::filesystem::path> files;  ///< that were named; a fabric's own name may be here
};

void add_fabric_option(boost::program_options::options_description& options);

/// Throws Error for fabrics that find_fabric() refuses, and for what is given twice.
FabricChoice read_fabrics(const boost::program_options::variables_map& given);

/// All fabrics that the garments' panels name: as chosen, or else as find_fabric() knows them.
/// Throws Error for names that are neither, and for a choice that no panel names.
std::map<std::string, Fabric> panel_fabrics(const std::vector<PanelMesh>& garments,
                                            const FabricChoice& choice);

}  // namespace toile
