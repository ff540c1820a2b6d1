#include "io/floor_height.h"

#include <cmath>

#include "io/text.h"

namespace toile {

std::string floor_height(double height, int decimals) {
  const std::string text = centimetres(height, decimals);
  return text.starts_with('-') ? text.substr(1) + " below the floor" : text + " above the floor";
}

std::string floor_heights(double low, double high) {
  const auto is_below = [](double height) {
    return fixed_number(100 * height, 0).starts_with('-');
  };
  if (is_below(low) != is_below(high)) return floor_height(low) + " to " + floor_height(high);
  return fixed_number(100 * std::abs(low), 0) + " to " + floor_height(high);
}

}  // namespace toile
