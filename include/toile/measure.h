// Takes the measures of a body that tailors need.
#pragma once

#include <string>
#include <vector>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

struct MeasureChoices {
  std::vector<std::string> freehand = {};  ///< "girth plane=bust": see docs/your-body.md
  std::string unit = "cm";                 ///< of the measures: "cm" or "inch"
};

/// Landmarks and measures as JSON, as measure-body writes them. Throws Error for a body that is not
/// closed and for a freehand measure that says nothing.
TOILE_API std::string measure(const Body& body, const MeasureChoices& choices = {});

}  // namespace library
}  // namespace toile
