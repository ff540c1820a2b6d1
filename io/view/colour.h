// Colours, and ramps that turn numbers into colours.
#pragma once

#include <vector>

namespace toile {

/// An sRGB colour, each channel in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// The colour of given lightness, chroma and hue in the perceptually even OKLCh space
/// [Ottosson 2020]. Lightness is in [0, 1]. A chroma of 0 is grey, 0.15 is strong. Channels that
/// sRGB can't show are clipped.
Colour oklch(double lightness, double chroma, double hue_degrees);

/// A channel's linear light, in [0, 1], from its sRGB value.
double to_light(double srgb);
/// A channel's sRGB value from its linear light, which is clipped to [0, 1].
double from_light(double light);

/// Colours for values from `low` to `high`, in even steps, and one colour for values below `low`.
struct ColourRamp {
  double low = 0;
  double high = 1;            ///< above `low`; values above it get the last step
  std::vector<Colour> steps;  ///< two or more, `low`'s colour first
  Colour below;               ///< for values below `low`

  Colour at(double value) const;
};

/// The project's ramp for distances and other magnitudes, from light and warm at `low` to dark and
/// cool at `high`. Lightness falls evenly, so the ramp can be read in grey, too. Values below `low`
/// are red.
ColourRamp magnitude_ramp(double low, double high);

/// One of a series of quiet colours that are easy to distinguish. `index` is 0 or more; the colours
/// repeat after 16.
Colour quiet_colour(int index);

/// About `wanted` round values in [low, high], 1, 2 or 5 times a power of ten apart. `high` has to
/// be above `low`.
std::vector<double> round_ticks(double low, double high, int wanted);

/// Decimal places, 0 to 9, that show the step between `ticks`; 1 for fewer than two ticks.
int tick_decimals(const std::vector<double>& ticks);

/// The smallest number that is not below `value` and is 1, 1.5, 2, 3, 4, 5, 6, 8 or 10 times a
/// power of ten. `value` has to be positive.
double round_up(double value);

}  // namespace toile
