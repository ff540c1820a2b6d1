#include "io/view/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "io/text.h"

namespace toile {

double to_light(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double from_light(double light) {
  light = std::clamp(light, 0.0, 1.0);
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

Colour oklch(double lightness, double chroma, double hue_degrees) {
  const double hue = to_radians(hue_degrees);
  const double a = chroma * std::cos(hue);
  const double b = chroma * std::sin(hue);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {from_light(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          from_light(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          from_light(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Colour ColourRamp::at(double value) const {
  if (value < low) return below;
  if (above && value > high) return *above;
  const double place = (value - low) / (high - low) * static_cast<double>(steps.size() - 1);
  const double last = static_cast<double>(steps.size() - 1);
  // The comparison takes a value that is not a number to the first step.
  const double inside = place > 0 ? std::min(place, last) : 0;
  const auto from = static_cast<std::size_t>(inside);
  const std::size_t to = std::min(from + 1, steps.size() - 1);
  const double part = inside - static_cast<double>(from);
  const auto mix = [part](double a, double b) { return a + part * (b - a); };
  return {mix(steps[from].red, steps[to].red), mix(steps[from].green, steps[to].green),
          mix(steps[from].blue, steps[to].blue)};
}

ColourRamp magnitude_ramp(double low, double high) {
  ColourRamp ramp;
  ramp.low = low;
  ramp.high = high;
  constexpr int count = 65;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    // Yellow through green and teal to deep blue. The chroma stays within sRGB, as clipped colours
    // would show as a band.
    const double chroma =
        0.100 + 0.045 * std::max(0.0, std::sin(2 * std::numbers::pi * t)) + 0.045 * std::pow(t, 8);
    ramp.steps.push_back(oklch(0.94 - 0.54 * t, chroma, 100 + 175 * t));
  }
  ramp.below = oklch(0.55, 0.22, 20);
  return ramp;
}

namespace {

ColourRamp one_sided(double high, double chroma, double hue, double turns) {
  ColourRamp ramp;
  ramp.high = high;
  constexpr int count = 33;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    // The chroma stays within sRGB, as clipped colours would show as a band.
    ramp.steps.push_back(oklch(0.97 - 0.52 * t, chroma * std::min(1.0, 1.6 * t), hue + turns * t));
  }
  ramp.below = ramp.steps.front();
  return ramp;
}

}  // namespace

ColourRamp warm_ramp(double high) { return one_sided(high, 0.13, 60, -25); }

ColourRamp cool_ramp(double high) { return one_sided(high, 0.12, 250, 0); }

ColourRamp two_sided_ramp(double size, bool warm_is_below) {
  ColourRamp below = warm_is_below ? warm_ramp(size) : cool_ramp(size);
  ColourRamp ramp = warm_is_below ? cool_ramp(size) : warm_ramp(size);
  ramp.low = -size;
  std::ranges::reverse(below.steps);
  below.steps.pop_back();
  ramp.steps.insert(ramp.steps.begin(), below.steps.begin(), below.steps.end());
  ramp.below = beyond_colour();
  return ramp;
}

Colour beyond_colour() { return oklch(0.2, 0.03, 320); }

Colour quiet_colour(int index) {
  // Neighbours in this list are far apart in hue. The second eight colours are darker.
  static constexpr std::array<double, 8> hues = {245, 70, 155, 20, 300, 110, 200, 345};
  const auto place = static_cast<std::size_t>(index) % hues.size();
  const bool second = (static_cast<std::size_t>(index) / hues.size()) % 2 == 1;
  return oklch(second ? 0.62 : 0.76, 0.075, hues[place] + (second ? 22 : 0));
}

std::vector<double> round_ticks(double low, double high, int wanted) {
  const double rough = (high - low) / std::max(wanted - 1, 1);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.75) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> ticks;
  const double slack = 1e-9 * step;
  for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i) {
    ticks.push_back(i * step);
  }
  return ticks;
}

int tick_decimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 1;
  return std::clamp(-static_cast<int>(std::floor(std::log10(ticks[1] - ticks[0]) + 1e-9)), 0, 9);
}

std::vector<BarMark> marks_of(const ColourBar& bar) {
  if (!bar.marks.empty()) return bar.marks;
  std::vector<BarMark> marks;
  const std::vector<double> ticks = round_ticks(bar.ramp.low, bar.ramp.high, 7);
  const int decimals = tick_decimals(ticks);
  marks.reserve(ticks.size());
  for (const double tick : ticks) marks.push_back({tick, fixed_number(tick, decimals)});
  return marks;
}

double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace toile
