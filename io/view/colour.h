// Colours, and ramps that turn numbers into colours.
#pragma once

#include <vector>

namespace toile {

/// sRGB as screens take it, each in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// A colour by lightness in [0, 1], chroma (0 is grey, 0.15 is strong) and hue in degrees, in the
/// perceptually even OKLCh space [Ottosson 2020]. What a screen can't show is clipped.
Colour oklch(double lightness, double chroma, double hue_degrees);

/// One channel's light (0 to 1, linear) from its sRGB value, and back.
double to_light(double srgb);
double from_light(double light);

/// Values from `low` to `high` in even steps of colour; a colour of its own for what lies below.
struct ColourRamp {
  double low = 0;
  double high = 1;            ///< more than `low`; values above it get the last step
  std::vector<Colour> steps;  ///< two or more, `low`'s colour first
  Colour below;

  Colour at(double value) const;
};

/// The project's ramp for distances and other magnitudes: light and warm at `low`, dark and cool at
/// `high`, with lightness falling evenly so that it also reads in grey; red below `low`.
ColourRamp magnitude_ramp(double low, double high);

/// `index`-th of a row of quiet colours that are easily told apart.
Colour quiet_colour(int index);

/// Round values (1, 2 or 5 times a power of ten apart) within [low, high], about `wanted` of
/// them. `high` has to be more than `low`.
std::vector<double> round_ticks(double low, double high, int wanted);

/// Decimal places, 0 to 9, that show the step between `ticks`; 1 for fewer than two ticks.
int tick_decimals(const std::vector<double>& ticks);

/// The smallest of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten that is not below `value`,
/// which has to be positive.
double round_up(double value);

}  // namespace toile
