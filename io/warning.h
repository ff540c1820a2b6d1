// A warning of a program, for people and for scripts.
#pragma once

#include <string>

namespace toile {

/// What looks wrong though the program could go on. Scripts go by `code`, which stays the same
/// while `text` may change.
struct Warning {
  std::string code;   ///< lower case and underscores, as docs/report.md lists them
  std::string place;  ///< the panel, seam, part or level that it is about; empty: the whole
  std::string text;   ///< for people, with what to do
};

}  // namespace toile
