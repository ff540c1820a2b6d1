#include "pattern/import/drawing_unit.h"

#include <utility>

#include "geometry/error.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr double metres_in_inch = 0.0254;
constexpr double min_piece_length = 0.02;  ///< metres
constexpr double max_piece_length = 5;     ///< metres
constexpr double max_asked_length = 100;
/// Metres: the largest piece of a garment is in between. In 24 of 26 drawings it is 21 to 112 cm
/// long; one is a test square, one says "metric" of centimetres. With half of the least the square
/// is not questioned; double of it questions three small ones. Half or double of the most changes
/// nothing.
constexpr double usual_least = 0.15;
constexpr double usual_most = 4;
constexpr const char* unit_remedy = "say the unit: --unit mm, cm or inch";

std::string unit_name(double metres) {
  // A width through a viewBox is a millimetre but for a rounding.
  const std::string millimetres = number_text(metres * 1000);
  if (millimetres == "1") return "millimetres";
  if (millimetres == "10") return "centimetres";
  if (millimetres == "25.4") return "inches";
  if (millimetres == "1000") return "metres";
  return "units of " + millimetres + " mm";
}

/// The unit that makes the largest piece one of a garment; 0: none does.
double unit_of_size(double largest, bool english) {
  if (largest >= 100 && largest <= max_piece_length * 1000) return 1e-3;
  if (largest >= 25 && largest < 100) return english ? metres_in_inch : 1e-2;
  if (largest >= 8 && largest < 25) return metres_in_inch;
  if (largest >= 0.1 && largest <= max_piece_length) return 1;
  return 0;
}

bool makes_garment(double size) { return size >= usual_least && size <= usual_most; }

/// The stated unit, or what else the file allows where that makes no garment. Warns of one that
/// makes none, or that another statement contradicts.
double unit_as_stated(const UnitEvidence& evidence, const std::string& source,
                      std::vector<Remark>& remarks) {
  const double stated = *evidence.stated;
  const bool contradicted = evidence.other && *evidence.other != stated;
  const auto makes_one = [&](double unit) { return makes_garment(evidence.largest * unit); };
  if (makes_one(stated) && !contradicted) return stated;
  std::optional<double> instead = evidence.metric ? std::optional(1e-2) : std::nullopt;
  if (evidence.other && !(evidence.metric && evidence.other == metres_in_inch)) {
    instead = evidence.other;
  }
  const double unit = !makes_one(stated) && instead && makes_one(*instead) ? *instead : stated;
  std::string text = source + ": the largest piece is " +
                     centimetres(evidence.largest * stated, 1) + " long in " + unit_name(stated) +
                     ", by " + evidence.stated_by;
  if (contradicted) text += ", though " + evidence.other_by + " says " + unit_name(*evidence.other);
  std::string fitting;
  for (const auto& [other, word] :
       {std::pair(1e-3, "mm"), {1e-2, "cm"}, {metres_in_inch, "inch"}}) {
    if (other == stated || other == unit || !makes_one(other)) continue;
    fitting += (fitting.empty() ? "" : ", ") + centimetres(evidence.largest * other, 1) +
               " with --unit " + word;
  }
  if (unit != stated) {
    text += "; " + unit_name(unit) + " are taken, which makes it " +
            centimetres(evidence.largest * unit, 1);
  }
  text += fitting.empty() ? "; --unit settles it" : "; it would be " + fitting;
  remarks.push_back({true, text});
  return unit;
}

}  // namespace

double drawing_unit(const UnitEvidence& evidence, const std::string& source,
                    std::vector<Remark>& remarks) {
  const double largest = evidence.largest;
  if (evidence.asked) {
    const double size = largest * *evidence.asked;
    if (size < 1e-3 || size > max_asked_length) {
      throw Error(source,
                  "the largest piece would be " + centimetres(size, 1) + " long in " +
                      unit_name(*evidence.asked),
                  "give another --unit");
    }
    return *evidence.asked;
  }
  if (evidence.stated) {
    const double unit = unit_as_stated(evidence, source, remarks);
    const double size = largest * unit;
    if (size < min_piece_length || size > max_piece_length) {
      throw Error(source,
                  "the largest piece would be " + centimetres(size, 1) + " long in " +
                      unit_name(unit) + ", by " + evidence.stated_by,
                  unit_remedy);
    }
    return unit;
  }
  const double unit = unit_of_size(largest, evidence.english);
  if (unit == 0) {
    throw Error(source,
                "states no unit, and the largest piece is " + number_text(largest) + " units long",
                unit_remedy);
  }
  const bool unsure = unit == 1e-2 || unit == metres_in_inch;
  remarks.push_back({unsure, source + ": states no unit; lengths are taken as " + unit_name(unit) +
                                 ", so that the largest piece is " +
                                 centimetres(largest * unit, 1) + " long" +
                                 (unsure ? "; if that is wrong, give --unit" : "")});
  return unit;
}

std::string unit_with_source(const UnitEvidence& evidence, double unit) {
  std::string by = evidence.stated_by;
  if (evidence.asked) {
    by = "--unit";
  } else if (evidence.stated && unit != *evidence.stated && unit == evidence.other) {
    by = evidence.other_by;
  } else if (unit != evidence.stated) {
    by = "the size of the largest piece";
  }
  return unit_name(unit) + ", by " + by;
}

}  // namespace toile
