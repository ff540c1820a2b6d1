#include "pattern/measure/spec_sheet.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "io/csv.h"
#include "io/text.h"
#include "pattern/measure/measuring_rule.h"

namespace toile {

namespace {

/// Metres: a longer measure is a slip of the unit.
constexpr double longest_measure = 20;

/// Metres: less is rounding of what was written in centimetres.
constexpr double rounding = 1e-9;

/// The columns of a specification.
struct SpecColumns {
  std::optional<std::size_t> name, rule, tolerance, spec;
};

SpecColumns columns_of(const CsvRow& header, const std::string& file, const std::string& size) {
  const std::string place = file + ":" + std::to_string(header.line);
  SpecColumns columns;
  std::vector<std::string> sizes;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const std::string& title = header.fields[i];
    if (title == "name") {
      columns.name = i;
    } else if (title == "measured") {
      columns.rule = i;
    } else if (title == "tolerance_cm") {
      columns.tolerance = i;
    } else if (title != "actual_cm" && title != "difference_cm" && title != "result") {
      sizes.push_back(title);
      if (title == size || size.empty()) columns.spec = i;
    }
  }
  std::string all;
  for (const std::string& title : sizes) {
    if (!all.empty()) all += ", ";
    all += shown_text(title);
  }
  if (!columns.name) {
    throw Error(place, "there is no column 'name'",
                "the first line names the columns: name, spec_cm or one a size, and if wanted "
                "tolerance_cm, measured");
  }
  if (!size.empty() && !columns.spec) {
    throw Error(place, "there is no size '" + shown_text(size) + "'",
                all.empty() ? "add a column of that name" : "give one of " + all);
  }
  // What else the table tells of a point is no size.
  const auto single = std::ranges::find(header.fields, "spec_cm");
  if (size.empty() && single != header.fields.end()) {
    columns.spec = static_cast<std::size_t>(single - header.fields.begin());
  } else if (size.empty() && sizes.size() > 1) {
    throw Error(place, "there are several sizes", "give --size, one of " + all);
  }
  return columns;
}

/// The points of a name, with or without a side.
std::vector<PointOfMeasure> points_named(const std::vector<PointOfMeasure>& points,
                                         const std::string& name) {
  std::vector<PointOfMeasure> named;
  for (const PointOfMeasure& point : points) {
    if (point.name == name || point.name == "left " + name || point.name == "right " + name) {
      named.push_back(point);
    }
  }
  return named;
}

}  // namespace

std::vector<SpecRow> read_spec_sheet(std::string_view text, const std::string& file,
                                     const std::string& size) {
  const std::vector<CsvRow> rows = parse_csv(text, file);
  if (rows.empty()) throw Error(file, "is empty", "write a header and a row for each measure");
  const SpecColumns columns = columns_of(rows.front(), file, size);
  std::vector<SpecRow> spec;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const std::string place = file + ":" + std::to_string(row->line);
    const auto field = [&](const std::optional<std::size_t>& column) {
      return column && *column < row->fields.size() ? row->fields[*column] : std::string();
    };
    const auto metres = [&](const std::optional<std::size_t>& column) -> std::optional<double> {
      const std::string words = field(column);
      if (words.empty()) return std::nullopt;
      const std::optional<double> centimetres = parse_number(words);
      if (!centimetres || !(*centimetres >= 0) || !(*centimetres <= 100 * longest_measure)) {
        throw Error(place, "'" + shown_text(words) + "' is no length in centimetres",
                    "write a number from 0 to 2000");
      }
      return *centimetres / 100;
    };
    SpecRow read{row->line, field(columns.name), field(columns.rule), metres(columns.spec),
                 metres(columns.tolerance)};
    if (std::ranges::all_of(row->fields, &std::string::empty)) continue;
    if (read.name.empty()) throw Error(place, "has no name", "name what is measured");
    spec.push_back(std::move(read));
  }
  return spec;
}

std::string MeasuredPoint::result() const {
  if (!actual) return "not found";
  if (!spec) return "";
  if (std::abs(*difference()) <= tolerance + rounding) return "in tolerance";
  return *difference() < 0 ? "too small" : "too large";
}

std::vector<MeasuredPoint> measure_to_spec(const SewnPanels& panels,
                                           const std::vector<SpecRow>& spec,
                                           const std::string& file, double tolerance) {
  const std::vector<PointOfMeasure> known = points_of_measure(panels);
  std::vector<MeasuredPoint> measured;
  for (const SpecRow& row : spec) {
    std::vector<PointOfMeasure> points = points_named(known, row.name);
    if (!row.rule.empty()) points = {{row.name, row.rule}};
    const double allowed = row.tolerance.value_or(tolerance);
    if (points.empty()) measured.push_back({row.name, "", {}, row.spec, allowed});
    for (const PointOfMeasure& point : points) {
      try {
        measured.push_back(
            {point.name, point.rule, measure_by_rule(panels, point.rule), row.spec, allowed});
      } catch (const Error& error) {
        if (!row.rule.empty()) {
          throw Error(file + ":" + std::to_string(row.line), error.what(), "mend this row");
        }
        measured.push_back({point.name, point.rule, {}, row.spec, allowed});
      }
    }
  }
  return measured;
}

std::vector<MeasuredPoint> measure_all_points(const SewnPanels& panels) {
  std::vector<MeasuredPoint> measured;
  for (const PointOfMeasure& point : points_of_measure(panels)) {
    try {
      measured.push_back({point.name, point.rule, measure_by_rule(panels, point.rule), {}, 0});
    } catch (const Error&) {
      // No line leads there on these panels.
    }
  }
  return measured;
}

}  // namespace toile
