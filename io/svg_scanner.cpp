#include "io/svg_scanner.h"

#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr double inch = 0.0254;

/// Metres of the units that are the same on every screen.
constexpr std::array<std::pair<std::string_view, double>, 6> physical_units = {{{"mm", 1e-3},
                                                                                {"cm", 1e-2},
                                                                                {"in", inch},
                                                                                {"pt", inch / 72},
                                                                                {"pc", inch / 6},
                                                                                {"Q", 0.25e-3}}};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The value of a length and its unit; nothing for what does not begin with a finite number.
std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  std::size_t end = 0;
  while (end < text.size() &&
         (is_digit(text[end]) || text[end] == '.' || text[end] == '-' || text[end] == '+')) {
    ++end;
  }
  // The e of an exponent, not of em.
  if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E') &&
      (is_digit(text[end + 1]) || text[end + 1] == '-' || text[end + 1] == '+')) {
    end += 2;
    while (end < text.size() && is_digit(text[end])) ++end;
  }
  const std::optional<double> value = parse_number(text.substr(0, end));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  std::string_view unit = text.substr(end);
  while (!unit.empty() && is_blank(unit.front())) unit.remove_prefix(1);
  return std::pair(*value, unit);
}

}  // namespace

void SvgScanner::skip() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == ',')) ++at_;
}

bool SvgScanner::at_end() {
  skip();
  return at_ == text_.size();
}

bool SvgScanner::at_number() {
  skip();
  if (at_ == text_.size()) return false;
  const char c = text_[at_];
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

double SvgScanner::number() {
  skip();
  const std::size_t start = at_;
  std::size_t end = at_;
  const auto digits = [&] {
    const std::size_t first = end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    return end - first;
  };
  if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
  std::size_t count = digits();
  if (end < text_.size() && text_[end] == '.') {
    ++end;
    count += digits();
  }
  if (count == 0) fail("a number is missing");
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    const std::size_t mantissa_end = end;
    ++end;
    if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
    if (digits() == 0) end = mantissa_end;
  }
  const std::optional<double> value = parse_number(text_.substr(start, end - start));
  if (!value || !std::isfinite(*value)) fail("a number is out of range");
  at_ = end;
  return *value;
}

bool SvgScanner::flag() {
  skip();
  if (at_ == text_.size() || (text_[at_] != '0' && text_[at_] != '1')) {
    fail("a flag of an arc is neither 0 nor 1");
  }
  return text_[at_++] == '1';
}

char SvgScanner::letter() {
  skip();
  return at_ == text_.size() ? '\0' : text_[at_++];
}

std::string_view SvgScanner::word() {
  skip();
  const std::size_t start = at_;
  while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  return text_.substr(start, at_ - start);
}

void SvgScanner::fail(const std::string& problem) const {
  throw Error(place_, problem + " at character " + std::to_string(at_ + 1),
              "open the drawing and save it again");
}

double svg_length(std::string_view text, double whole, const std::string& place) {
  const auto parts = number_and_unit(text);
  if (!parts) {
    throw Error(place, "'" + shown_text(text) + "' is no length",
                "use a number, or one with a unit");
  }
  const auto& [value, unit] = *parts;
  if (unit.empty() || unit == "px") return value;
  if (unit == "%") return value / 100 * whole;
  if (unit == "em" || unit == "rem") return value * 16;
  if (unit == "ex") return value * 8;
  for (const auto& [name, metres] : physical_units) {
    if (unit == name) return value * metres / inch * 96;
  }
  throw Error(place, "'" + shown_text(text) + "' has an unknown unit", "use mm, cm, in, pt or px");
}

std::optional<double> svg_physical_length(std::string_view text) {
  const auto parts = number_and_unit(text);
  if (!parts) return std::nullopt;
  for (const auto& [name, metres] : physical_units) {
    if (parts->second == name) return parts->first * metres;
  }
  return std::nullopt;
}

}  // namespace toile
