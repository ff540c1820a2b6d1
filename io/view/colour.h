// Colours, and ramps that turn numbers into colours.
#pragma once

#include <optional>
#include <string>
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
  double high = 1;                ///< above `low`
  std::vector<Colour> steps;      ///< two or more, `low`'s colour first
  Colour below;                   ///< for values below `low`
  std::optional<Colour> above{};  ///< for values above `high`; none: they get the last step

  Colour at(double value) const;
};

/// The project's ramp for distances and other magnitudes, from light and warm at `low` to dark and
/// cool at `high`. Lightness falls evenly, so the ramp can be read in grey, too. Values below `low`
/// are red.
ColourRamp magnitude_ramp(double low, double high);

/// Colours for values from 0 to `high`, from almost white to a dark warm or a dark cool colour.
/// Lightness falls evenly. The two hues are told apart by those who can't tell red from green.
/// Values below 0 get the first colour.
ColourRamp warm_ramp(double high);
ColourRamp cool_ramp(double high);

/// The two side by side, from `-size` to `size`: warm below zero and cool above it, or the other
/// way around. Values below are almost black.
ColourRamp two_sided_ramp(double size, bool warm_is_below);

/// Almost black, with which a ramp shows what no value should be.
Colour beyond_colour();

/// One of a series of quiet colours that are easy to distinguish. `index` is 0 or more; the colours
/// repeat after 16.
Colour quiet_colour(int index);

/// About `wanted` round values in [low, high], 1, 2 or 5 times a power of ten apart. `high` has to
/// be above `low`.
std::vector<double> round_ticks(double low, double high, int wanted);

/// Decimal places, 0 to 9, that show the step between `ticks`; 1 for fewer than two ticks.
int tick_decimals(const std::vector<double>& ticks);

/// A text beside a colour bar.
struct BarMark {
  double value = 0;
  std::string text;
};

/// A ramp with what is written beside it.
struct ColourBar {
  std::string title;  ///< with the unit, as in "gap, mm"
  ColourRamp ramp;
  std::string below{};           ///< meaning of the colour below the ramp; empty: not shown
  std::string above{};           ///< meaning of the colour above the ramp; empty: not shown
  std::vector<BarMark> marks{};  ///< upwards; empty: round numbers
};

/// The marks of a bar, or round numbers where it has none.
std::vector<BarMark> marks_of(const ColourBar& bar);

/// The smallest number that is not below `value` and is 1, 1.5, 2, 3, 4, 5, 6, 8 or 10 times a
/// power of ten. `value` has to be positive.
double round_up(double value);

}  // namespace toile
