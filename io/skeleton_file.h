// body.json: a body's joints and segments on disk.
#pragma once

#include <filesystem>

#include "geometry/body/skeleton.h"

namespace toile {

/// {"format": "toile-body", "version": 1, "units": "m", "up": "y",
///  "joints": {name: [x, y, z]}, "segments": [{"part", "from", "to"}]}
void write_skeleton(const std::filesystem::path& path, const Skeleton& skeleton);

/// Reads what write_skeleton wrote; keys it does not know are passed over. Throws Error, naming the
/// file and the key, for other units or another up axis, a joint that is no three finite numbers, a
/// part that is none of body_parts, or a segment of joints that are not there.
Skeleton read_skeleton(const std::filesystem::path& path);

/// Whether the file says that it is one, sound or not. False where there is no file.
bool is_skeleton_file(const std::filesystem::path& path);

/// Where a body's skeleton is by convention: beside it, of the same stem, .json.
std::filesystem::path skeleton_path(const std::filesystem::path& body);

}  // namespace toile
