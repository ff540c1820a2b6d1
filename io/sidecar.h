// Sidecars: what belongs to a mesh and has no place in its file stands in a file beside it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "io/json_value.h"

namespace toile {

/// Where a sidecar of that kind is written: NAME.KIND.json beside NAME.obj. No pattern, report or
/// table that is called after the mesh has such a name.
std::filesystem::path sidecar_path(const std::filesystem::path& mesh, const std::string& kind);

/// Where earlier versions wrote it: NAME.json.
std::filesystem::path earlier_sidecar_path(const std::filesystem::path& mesh);

/// Where a sidecar is read: sidecar_path() if it is there. Else earlier_sidecar_path() if that
/// `is_sidecar`, or is no JSON: its reader says what is wrong. Else sidecar_path(), where nothing
/// is.
std::filesystem::path sidecar_beside(const std::filesystem::path& mesh, const std::string& kind,
                                     const std::function<bool(const JsonValue&)>& is_sidecar);

}  // namespace toile
