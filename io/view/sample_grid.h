// Samples of rays, four to a pixel, that make an image.
#pragma once

#include <cstdint>
#include <vector>

#include "io/view/colour.h"

namespace toile {

/// Pixels in rows from the top, three bytes each (red, green, blue).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

/// A colour as linear light, which can be added and scaled.
struct Light {
  double red = 0;
  double green = 0;
  double blue = 0;
};

Light light_of(const Colour& colour);

/// The result of one ray.
struct Sample {
  float red = 0;  ///< linear light, as green and blue
  float green = 0;
  float blue = 0;
  std::int32_t region = -1;  ///< of the surface that the ray met; -1: none
};

/// The samples of an image. A pixel has one in each quarter: 0 and 1 are above, 2 and 3 below.
class SampleGrid {
 public:
  /// Sizes are in pixels, positive. All samples start as `background`.
  SampleGrid(int width, int height, const Colour& background);

  Sample& at(int x, int y, int quarter) {
    return samples_[index(2 * x + quarter % 2, 2 * y + quarter / 2)];
  }

  /// Darkens the samples on either side of a border between regions. The edge of the background is
  /// no border.
  void draw_borders();

  /// The mean of each pixel's samples.
  Image image() const;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(2 * width_) +
           static_cast<std::size_t>(column);
  }

  int width_;
  int height_;
  std::vector<Sample> samples_;
};

}  // namespace toile
