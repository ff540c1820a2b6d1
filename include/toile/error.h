// The one exception of Toile: the caller's input, or a result of it, cannot be used.
#pragma once

#include <stdexcept>
#include <string>

/// What the shared library shows.
#define TOILE_API __attribute__((visibility("default")))

namespace toile {

/// `place` names a file, "file:line", or a panel and edge. `problem` says what is wrong there.
/// `remedy` says what the user can do; it may be empty. what() joins the three to one line.
/// Programs print what() and end with exit code 1. Python has it as toile.Error.
class TOILE_API Error : public std::runtime_error {
 public:
  Error(const std::string& place, const std::string& problem, const std::string& remedy)
      : std::runtime_error(place + ": " + problem + (remedy.empty() ? "" : "; " + remedy)) {}
};

}  // namespace toile
