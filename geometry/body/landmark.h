// A named point of a body that tailors measure from: plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A point of the skin, or the reason why the body does not show it.
struct Landmark {
  std::string name;
  std::optional<Vec3> place;  ///< metres, in the body's frame
  double confidence = 0;      ///< 0 to 1; 0 where there is no place
  std::string reason;         ///< why there is no place, or why the confidence is low; may be empty
};

/// Landmarks by name, each once.
using Landmarks = std::vector<Landmark>;

/// The place of the landmark of that name; nothing where it is missing or has none.
inline std::optional<Vec3> place_of(const Landmarks& landmarks, const std::string& name) {
  for (const Landmark& landmark : landmarks) {
    if (landmark.name == name) return landmark.place;
  }
  return std::nullopt;
}

}  // namespace toile
