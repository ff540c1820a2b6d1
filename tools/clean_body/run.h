// What clean-body does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/axis_direction.h"
#include "tools/program.h"

namespace toile {

struct CleanBodySettings {
  std::vector<std::filesystem::path> inputs;      ///< one or more; several are one scan
  std::optional<double> metres_per_unit = {};     ///< none: found by the body's height
  std::optional<double> height = {};              ///< metres; none: by the unit
  std::vector<std::filesystem::path> poses = {};  ///< of the inputs' points: one each, or none
  bool as_points = false;                         ///< whether faces are ignored
  std::optional<AxisDirection> up = {};           ///< none: found
  std::optional<AxisDirection> front = {};        ///< none: found
  std::optional<double> edge_length = {};  ///< metres, of a scan's surface; none: its default
};

/// --unit, --height, --up, --front and --points, of a body's file.
void add_body_options(boost::program_options::options_description& options);
/// Reads them. Throws boost::program_options::error for a value that they can't take.
void read_body_options(const boost::program_options::variables_map& given,
                       CleanBodySettings& settings);

/// What became of a body.
struct CleanBodyResult {
  std::vector<std::string> warnings;  ///< as they were said
  bool is_usable = true;              ///< its surface hardly crosses itself
};

/// Cleans the body, writes it and its skeleton beside it. Throws Error for what can't be read,
/// closed or written.
CleanBodyResult run_clean_body(const CleanBodySettings& settings, const CommonSettings& common);

}  // namespace toile
