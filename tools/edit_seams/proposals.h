// Proposed seams, checked against the pattern that they are for.
#pragma once

#include <filesystem>
#include <string>

#include "pattern/pattern.h"

namespace toile {

/// The text of a report of find-seams. Throws Error when it is none, or that of another pattern. It
/// is one where it names a panel or an edge that is not there, or one of another length. `drawn`:
/// the pattern without mending, see parse_drawn_pattern().
std::string read_proposals(const std::filesystem::path& path, const Pattern& drawn);

}  // namespace toile
