// Heights as messages state them.
#pragma once

#include <string>

namespace toile {

/// A height over y = 0, in metres, as people read it: "12 cm above the floor", or below it.
std::string floor_height(double height, int decimals = 0);

/// The same of a range: "5 to 12 cm above the floor".
std::string floor_heights(double low, double high);

}  // namespace toile
