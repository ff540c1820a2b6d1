// Reads and writes body.body.json: the joints, segments and landmarks of body.ply.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/body/landmark.h"
#include "geometry/body/skeleton.h"
#include "io/output_file.h"

namespace toile {

/// Writes, for example,
/// {"format": "toile-body", "version": 1, "units": "m", "up": "y",
///  "joints": {name: [x, y, z]}, "segments": [{"part", "from", "to"}],
///  "landmarks": {name: {"place_m": [x, y, z], "confidence": 0.9}},
///  "cleaned": {"rotation": rows, "translation_m": [x, y, z], "metres_per_unit": 0.01}}.
///
/// `landmarks` is there unless they are empty, `cleaned` and `measures` where those of `skeleton`
/// are. `measures` has girths (name, origin_m, normal, girth_m), lengths_m and shoulder_points_m.
void write_skeleton(const OutputPath& path, const Skeleton& skeleton,
                    const Landmarks& landmarks = {});
/// The text of such a file.
std::string format_skeleton(const Skeleton& skeleton, const Landmarks& landmarks);

/// Reads a file that write_skeleton() wrote and skips unknown keys. It throws Error, with the file
/// and the key, for text that is not JSON, other units or another up axis. A joint that is not
/// three numbers within max_metres is an Error, too. So is a part that is not in body_parts, a
/// segment without its joints, and joints of one of body_segments() without that segment.
/// So is a `cleaned` that is no rigid move, and a measure beyond max_metres.
Skeleton read_skeleton(const std::filesystem::path& path);
/// The same of a text; `file` stands for its name in messages.
Skeleton parse_skeleton(const std::string& text, const std::string& file);

/// Whether the file is meant as a skeleton file, sound or not: it has joints, or its `format` says
/// so. False if there is no file. Throws Error for a file that is not JSON.
bool is_skeleton_file(const std::filesystem::path& path);

/// Where a body's skeleton is written: body.body.json beside body.ply.
std::filesystem::path skeleton_path(const std::filesystem::path& body);

/// Where a body's skeleton is read: skeleton_path(), or body.json of an earlier version if that is
/// a skeleton file. See sidecar_beside().
std::filesystem::path skeleton_beside(const std::filesystem::path& body);

}  // namespace toile
