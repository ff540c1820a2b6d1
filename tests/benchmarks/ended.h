// How a benchmark's program ends.
#pragma once

#include <boost/program_options/errors.hpp>
#include <exception>
#include <iostream>
#include <string>

namespace toile {

/// The exit code of `run()`: what it returns, 2 for wrong options, 1 for an error, which is said.
template <typename Run>
int ended(const std::string& program, const Run& run) {
  try {
    return run();
  } catch (const boost::program_options::error& error) {
    std::cerr << program << ": " << error.what() << "; see --help\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << "\n";
    return 1;
  }
}

}  // namespace toile
