// What the user says about a drawing.
#pragma once

#include <optional>

namespace toile {

struct DrawingOptions {
  std::optional<double> unit;  ///< metres
  bool cut_line = false;       ///< whether pieces are bounded by their cut lines, if they have any
};

}  // namespace toile
