// What rays saw, four to a pixel, on its way to an image.
#pragma once

#include <cstdint>
#include <vector>

#include "io/view/colour.h"

namespace toile {

/// Rows from the top, three bytes a pixel (red, green, blue).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

/// A colour as linear light, which may be added up and scaled.
struct Light {
  double red = 0;
  double green = 0;
  double blue = 0;
};

Light light_of(const Colour& colour);

struct Sample {
  float red = 0;  ///< light
  float green = 0;
  float blue = 0;
  std::int32_t region = -1;  ///< of the surface that was met; -1: none was
};

/// A pixel has a sample in each of its quarters: 0 and 1 in the upper row, 2 and 3 in the lower.
class SampleGrid {
 public:
  /// Sizes in pixels, positive. All samples are `background`.
  SampleGrid(int width, int height, const Colour& background);

  Sample& at(int x, int y, int quarter) {
    return samples_[index(2 * x + quarter % 2, 2 * y + quarter / 2)];
  }

  /// Darkens the samples on either side of a border between regions; a border with the background
  /// is none.
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
