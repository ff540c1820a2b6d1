// The lines of docs/validation.md: what was measured, beside what it should be.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

namespace toile::test {

struct Figure {
  std::string what;        ///< case and quantity
  std::string method;      ///< relaxation, release, springs; or a plain function
  std::string resolution;  ///< elements, step, what it was measured at
  std::string unit = "";
  /// The bound that was asked for, where a measured reason keeps the test from asserting it: the
  /// row says whether it was kept. 0: it is what is asserted.
  double asked = 0;
  std::string reason = "";  ///< why it is not met, or what else is to be known
};

inline std::string number(double value, int digits = 4, const std::string& unit = "") {
  std::ostringstream out;
  out.precision(digits);
  out << value << (unit.empty() ? "" : " ") << unit;
  return out.str();
}

inline std::string asked_for(const Figure& figure, double error, const std::string& bound) {
  if (figure.asked == 0) return "";
  return "; asked " + bound + (std::abs(error) > figure.asked ? ": missed" : ": kept");
}

/// One row of Markdown, and the same as a property of the test.
inline void print_figure(const Figure& figure, double measured, const std::string& reference,
                         const std::string& error, const std::string& bound) {
  const std::string row = "| " + figure.what + " | " + figure.method + " | " + figure.resolution +
                          " | " + number(measured, 6, figure.unit) + " | " + reference + " | " +
                          error + " | " + bound + " | " + figure.reason + " |";
  std::cout << row << std::endl;
  testing::Test::RecordProperty(figure.what + ", " + figure.method + ", " + figure.resolution, row);
}

/// Of the reference, as a fraction.
inline void expect_relative(const Figure& figure, double measured, double reference, double bound) {
  const double error = measured / reference - 1;
  const std::string allowed =
      number(100 * bound) + " %" + asked_for(figure, error, number(100 * figure.asked) + " %");
  print_figure(figure, measured, number(reference, 6, figure.unit), number(100 * error, 3) + " %",
               allowed);
  EXPECT_LE(std::abs(error), bound) << figure.what << ", " << figure.resolution;
}

/// In the figure's unit.
inline void expect_near(const Figure& figure, double measured, double reference, double bound) {
  const double error = measured - reference;
  const std::string allowed =
      number(bound, 4, figure.unit) + asked_for(figure, error, number(figure.asked));
  print_figure(figure, measured, number(reference, 6, figure.unit), number(error, 3, figure.unit),
               allowed);
  EXPECT_LE(std::abs(error), bound) << figure.what << ", " << figure.resolution;
}

/// For information: no bound is due. `reference` may be empty.
inline void state(const Figure& figure, double measured, const std::string& reference = "",
                  const std::string& error = "") {
  print_figure(figure, measured, reference, error, "reported");
}

}  // namespace toile::test
