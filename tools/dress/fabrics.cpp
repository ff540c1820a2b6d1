#include "tools/dress/fabrics.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "geometry/error.h"

namespace toile {

namespace {

namespace po = boost::program_options;

std::string list_of_fabrics() {
  std::string list;
  for (const std::string& name : fabric_names()) {
    if (!list.empty()) list += ", ";
    list += name;
  }
  return list;
}

}  // namespace

void add_fabric_option(po::options_description& options) {
  const std::string help = "a JSON file with a fabric's quantities, or one of " +
                           list_of_fabrics() +
                           "; in a scene, of layers that name none. NAME=FABRIC: of the panels "
                           "that the pattern says are "
                           "cut from NAME; may be repeated";
  options.add_options()(
      "fabric", po::value<std::vector<std::string>>()->composing()->default_value({}, "default"),
      help.c_str());
}

FabricChoice read_fabrics(const po::variables_map& given) {
  FabricChoice choice;
  std::optional<std::string> of_garments;
  for (const std::string& text : given["fabric"].as<std::vector<std::string>>()) {
    const std::size_t equals = text.find('=');
    std::error_code unreachable;
    if (equals != std::string::npos && equals > 0 && !std::filesystem::exists(text, unreachable)) {
      const std::string name = text.substr(0, equals);
      choice.files.emplace_back(text.substr(equals + 1));
      if (!choice.of_panels.emplace(name, find_fabric(text.substr(equals + 1))).second) {
        throw Error("--fabric", "gives '" + name + "' twice", "leave one out");
      }
    } else if (of_garments) {
      throw Error("--fabric", "gives the garment's fabric twice",
                  "leave one out, or give it to panels: NAME=" + text);
    } else {
      of_garments = text;
      choice.files.emplace_back(text);
    }
  }
  choice.of_garments = of_garments.value_or(Fabric().name);
  return choice;
}

std::map<std::string, Fabric> panel_fabrics(const std::vector<PanelMesh>& garments,
                                            const FabricChoice& choice) {
  std::map<std::string, Fabric> fabrics = choice.of_panels;
  std::set<std::string> unused;
  for (const auto& [name, fabric] : fabrics) unused.insert(name);
  const std::vector<std::string> known = fabric_names();
  for (const PanelMesh& garment : garments) {
    for (const MeshedPanel& panel : garment.panels) {
      const std::string& name = panel.fabric;
      unused.erase(name);
      if (name.empty() || fabrics.count(name) != 0) continue;
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw Error(
            "panel '" + panel.name + "'", "is cut from '" + name + "', which is not known",
            "say what it is: --fabric " + name + "=FILE.json; known are " + list_of_fabrics());
      }
      fabrics[name] = find_fabric(name);
    }
  }
  if (!unused.empty()) {
    throw Error("--fabric", "no panel is cut from '" + *unused.begin() + "'",
                "the pattern says so by a panel's key 'fabric'");
  }
  return fabrics;
}

}  // namespace toile
