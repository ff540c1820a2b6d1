// The headline plot: error against processor time on logarithmic axes, a frame for each scene.
#include <algorithm>
#include <cmath>

#include "cloth/dressing/quality.h"
#include "io/text.h"
#include "tests/benchmarks/work_precision/findings.h"

namespace toile::precision {

namespace {

constexpr double frame_width = 380, frame_height = 250;  // pixels
constexpr double left = 62, top = 62, between_x = 74, between_y = 82;
constexpr int frames_across = 2;

/// A logarithmic axis from pixel `begin` to `end`.
class Axis {
 public:
  Axis(const std::vector<double>& values, double begin, double end) : begin_(begin), end_(end) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    constexpr double margin = 0.08;  // decades
    first_ = std::log10(*least) - margin;
    last_ = std::log10(*most) + margin;
  }
  double at(double value) const {
    return begin_ + (end_ - begin_) * (std::log10(value) - first_) / (last_ - first_);
  }
  /// Powers of ten; on short axes, twice and five times them too.
  std::vector<double> ticks() const {
    constexpr double few = 2;  // decades
    std::vector<double> all;
    for (double decade = std::floor(first_); decade <= last_; ++decade) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double at = decade + std::log10(factor);
        if (at < first_ || at > last_ || (factor > 1 && last_ - first_ > few)) continue;
        all.push_back(factor * std::pow(10, decade));
      }
    }
    return all;
  }

 private:
  double begin_, end_;
  double first_, last_;
};

std::string px(double value) { return fixed_number(value, 1); }

std::string text(double x, double y, const std::string& words, const std::string& style) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + style + ">" + html_escaped(words) +
         "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& colour) {
  return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) +
         "\" stroke=\"" + colour + "\"/>\n";
}

std::string colour_of(const std::string& method) {
  return method == "paper" ? "#a8501e" : "#20558a";
}

bool drawn(const Row& row) {
  return row.outcome.sewn && row.error.rms > 0 && row.outcome.processor > 0;
}

/// All runs as dots; the best that can be had for a time as a line; the presets named.
std::string method_svg(const std::vector<const Row*>& rows, const Axis& x, const Axis& y) {
  if (rows.empty()) return "";
  const std::string colour = colour_of(rows.front()->method);
  std::vector<const Row*> by_time = rows;
  std::sort(by_time.begin(), by_time.end(),
            [](const Row* a, const Row* b) { return a->outcome.processor < b->outcome.processor; });
  std::string svg, best;
  double least = 0;
  for (const Row* row : by_time) {
    if (!drawn(*row)) continue;
    const double at_x = x.at(row->outcome.processor), at_y = y.at(1e3 * row->error.rms);
    if (best.empty() || row->error.rms < least) {
      best += px(at_x) + "," + px(at_y) + " ";
      least = row->error.rms;
    }
    const bool named = row->knob == "quality" || row->knob == "default";
    svg += "<circle cx=\"" + px(at_x) + "\" cy=\"" + px(at_y) + "\" r=\"" +
           (named ? "4.5" : "2.5") + "\" fill=\"" + colour + "\"/>\n";
    if (named) {
      // Presets can be next to each other.
      const bool below = row->value == qualities.back().name;
      svg +=
          text(at_x + 7, at_y + (below ? 13 : -5), row->knob == "default" ? "default" : row->value,
               "fill=\"" + colour + "\" font-size=\"11\"");
    }
  }
  if (best.empty()) return "";
  return "<polyline points=\"" + best + "\" fill=\"none\" stroke=\"" + colour +
         "\" stroke-width=\"1.4\"/>\n" + svg;
}

std::string frame_svg(const Results& results, const MeshedScene& scene, double x0, double y0) {
  const auto rows = rows_of(results.rows, scene, "");
  std::vector<double> times, errors;
  for (const Row* row : rows) {
    if (!drawn(*row)) continue;
    times.push_back(row->outcome.processor);
    errors.push_back(1e3 * row->error.rms);
  }
  if (times.empty()) return "";
  const double x1 = x0 + frame_width, y1 = y0 + frame_height;
  const Axis x(times, x0, x1), y(errors, y1, y0);
  std::string svg =
      text(x0, y0 - 10, scene.name + ", " + std::to_string(rows.front()->nodes) + " nodes",
           "font-weight=\"bold\"");
  for (const double tick : x.ticks()) {
    svg += line(x.at(tick), y0, x.at(tick), y1, "#e0e0e0");
    svg += text(x.at(tick), y1 + 16, number(tick), "text-anchor=\"middle\"");
  }
  for (const double tick : y.ticks()) {
    svg += line(x0, y.at(tick), x1, y.at(tick), "#e0e0e0");
    svg += text(x0 - 6, y.at(tick) + 4, number(tick), "text-anchor=\"end\"");
  }
  svg += text((x0 + x1) / 2, y1 + 33, "processor time, s", "text-anchor=\"middle\"");
  const std::string middle = px(x0 - 44) + " " + px((y0 + y1) / 2);
  svg += "<text transform=\"translate(" + middle +
         ") rotate(-90)\" text-anchor=\"middle\">distance from rest, rms, mm</text>\n";
  for (const char* method : {"paper", "relaxation"}) {
    svg += method_svg(rows_of(results.rows, scene, method), x, y);
  }
  return svg;
}

}  // namespace

std::string headline_plot(const Results& results) {
  std::vector<MeshedScene> shown;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    if (!rows_of(results.rows, scene, "paper").empty()) shown.push_back(scene);
  }
  const std::size_t rows = (shown.size() + frames_across - 1) / frames_across;
  const double width = left + frames_across * (frame_width + between_x) - between_x + 30;
  const double height =
      top + static_cast<double>(rows) * (frame_height + between_y) - between_y + 50;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px(width) +
                    "\" height=\"" + px(height) + "\" viewBox=\"0 0 " + px(width) + " " +
                    px(height) +
                    "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\" fill=\"#222\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  double key = left;
  for (const std::string method : {"relaxation", "paper"}) {
    svg += "<circle cx=\"" + px(key) + "\" cy=\"18\" r=\"4.5\" fill=\"" + colour_of(method) +
           "\"/>\n" +
           text(key + 9, 22,
                method == "paper" ? "--method paper"
                                  : "relaxation, with "
                                    "its presets",
                "");
    key += 190;
  }
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto across = static_cast<double>(i % frames_across);
    const auto down = static_cast<double>(i / frames_across);
    svg += frame_svg(results, shown[i], left + across * (frame_width + between_x),
                     top + down * (frame_height + between_y));
  }
  return svg + "</svg>\n";
}

}  // namespace toile::precision
