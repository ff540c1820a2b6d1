#include "io/view/sample_grid.h"

#include <cmath>

#include "geometry/parallel.h"

namespace toile {

namespace {

std::uint8_t byte_of(double light) {
  return static_cast<std::uint8_t>(std::lround(255 * from_light(light)));
}

}  // namespace

Light light_of(const Colour& colour) {
  return {to_light(colour.red), to_light(colour.green), to_light(colour.blue)};
}

SampleGrid::SampleGrid(int width, int height, const Colour& background)
    : width_(width), height_(height) {
  const Light light = light_of(background);
  samples_.assign(index(0, 2 * height),
                  {static_cast<float>(light.red), static_cast<float>(light.green),
                   static_cast<float>(light.blue), -1});
}

void SampleGrid::draw_borders() {
  std::vector<char> border(samples_.size(), 0);
  const auto part = [&](std::size_t a, std::size_t b) {
    const std::int32_t first = samples_[a].region;
    const std::int32_t second = samples_[b].region;
    if (first != second && first >= 0 && second >= 0) border[a] = border[b] = 1;
  };
  for (int row = 0; row < 2 * height_; ++row) {
    for (int column = 0; column < 2 * width_; ++column) {
      if (column + 1 < 2 * width_) part(index(column, row), index(column + 1, row));
      if (row + 1 < 2 * height_) part(index(column, row), index(column, row + 1));
    }
  }
  constexpr float darkness = 0.35F;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (border[i] == 0) continue;
    samples_[i].red *= darkness;
    samples_[i].green *= darkness;
    samples_[i].blue *= darkness;
  }
}

Image SampleGrid::image() const {
  Image image{width_, height_, {}};
  image.bytes.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
  parallel_for_items(height_, [&](int y) {
    std::uint8_t* byte =
        image.bytes.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    for (int x = 0; x < width_; ++x) {
      Light sum;
      for (const int row : {2 * y, 2 * y + 1}) {
        for (const int column : {2 * x, 2 * x + 1}) {
          const Sample& sample = samples_[index(column, row)];
          sum.red += sample.red;
          sum.green += sample.green;
          sum.blue += sample.blue;
        }
      }
      *byte++ = byte_of(sum.red / 4);
      *byte++ = byte_of(sum.green / 4);
      *byte++ = byte_of(sum.blue / 4);
    }
  });
  return image;
}

}  // namespace toile
