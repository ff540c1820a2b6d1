// edit-seams: the page on which seams are drawn, as a file or served on this machine.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/program.h"

namespace toile {

struct EditSeamsSettings {
  std::filesystem::path pattern;
  std::optional<std::filesystem::path> proposals;  ///< the report of find-seams
  bool serve = false;
  int port = 0;                               ///< of the server; 0: any that is free
  std::optional<std::filesystem::path> body;  ///< that the server dresses
  double edge_length = 0.025;                 ///< metres, of the server's drapes
};

/// Writes the page, or serves it until a signal ends it. Throws Error for a pattern that can't be
/// read, and when the port is taken.
void run_edit_seams(const EditSeamsSettings& settings, const CommonSettings& common);

}  // namespace toile
