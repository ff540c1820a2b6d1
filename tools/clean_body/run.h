// What clean-body does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <optional>
#include <vector>

#include "geometry/axis_direction.h"
#include "tools/program.h"

namespace toile {

struct CleanBodySettings {
  std::vector<std::filesystem::path> inputs;      ///< one or more; several are one scan
  std::optional<double> metres_per_unit = {};     ///< none: found by the body's height
  std::vector<std::filesystem::path> poses = {};  ///< of the inputs' points: one each, or none
  bool as_points = false;                         ///< whether faces are ignored
  std::optional<AxisDirection> up = {};           ///< none: found
  std::optional<AxisDirection> front = {};        ///< none: found
  std::optional<double> edge_length = {};  ///< metres, of a scan's surface; none: its default
};

/// --unit, of a body's mesh.
void add_unit_option(boost::program_options::options_description& options);
/// Metres, if it was given.
std::optional<double> read_unit(const boost::program_options::variables_map& given);

/// Cleans the body, writes it and its skeleton beside it. Throws Error for what can't be read,
/// closed or written.
void run_clean_body(const CleanBodySettings& settings, const CommonSettings& common);

}  // namespace toile
