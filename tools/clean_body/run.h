// What clean-body does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/body/clean_body.h"
#include "geometry/body/landmark.h"
#include "geometry/scan/reconstruct_scan.h"
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

struct BodyInput;  // scan.h

/// A hole of a scan in the cleaned body's frame.
struct PlacedHole {
  std::string place;  ///< "crotch", "left armpit", "left arm", ...; empty: there are no joints
  Vec3 centre;        ///< metres
  double area = 0;    ///< square metres
};

/// A cleaned body, and what there is to say of it.
struct CleanedInput {
  CleanBody body;
  Landmarks landmarks;             ///< empty where there are no joints
  std::optional<ScanReport> scan;  ///< none: it was a mesh
  std::vector<PlacedHole> holes;   ///< of the scan
  bool joints_given = false;
  std::vector<std::string> warnings;
};

/// The joints that came with a body, and their file's name; none: they are not beside the first
/// input. Throws Error as read_skeleton() does.
std::pair<std::optional<Skeleton>, std::string> joints_beside(const CleanBodySettings& settings);

/// Cleans what was read. `joints` are those that came with it, from a file called `joints_name`.
/// Says what it does. Takes the points out of `input`. Throws Error for what can't be closed.
CleanedInput clean_input(BodyInput& input, const std::optional<Skeleton>& joints,
                         const std::string& joints_name, const CleanBodySettings& settings,
                         const CommonSettings& common);

/// The report of it.
nlohmann::ordered_json cleaned_json(const CleanedInput& cleaned, const BodyInput& input);

/// Cleans the body, writes it and its skeleton beside it. Throws Error for what can't be read,
/// closed or written.
CleanBodyResult run_clean_body(const CleanBodySettings& settings, const CommonSettings& common);

}  // namespace toile
