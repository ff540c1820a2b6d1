#include "io/line_scanner.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/error.h"
#include "io/limits.h"
#include "io/text.h"

namespace toile {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

bool LineScanner::next_line(char comment) {
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    line_ = text_.substr(at_, end - at_);
    at_ = end;
    if (at_ < text_.size()) at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++number_;
    if (comment != 0) line_ = line_.substr(0, line_.find(comment));
    while (!line_.empty() && is_space(line_.front())) line_.remove_prefix(1);
    if (!line_.empty()) return true;
  }
  line_ = {};
  return false;
}

void LineScanner::need_line(const std::string& what, char comment) {
  if (!next_line(comment)) fail("the file ends before " + what, "is it cut off?");
}

std::string_view LineScanner::word() {
  while (!line_.empty() && is_space(line_.front())) line_.remove_prefix(1);
  std::size_t end = 0;
  while (end < line_.size() && !is_space(line_[end])) ++end;
  const std::string_view word = line_.substr(0, end);
  line_.remove_prefix(end);
  return word;
}

double LineScanner::number(const std::string& what) {
  const std::string_view given = word();
  if (given.empty()) fail(what + " is missing", "");
  const std::optional<double> value = parse_number(given);
  if (!value) fail(what + " is " + shown(given) + ", which is not a number", "");
  if (!std::isfinite(*value)) {
    fail(what + " is " + shown(given) + ", which is not a finite number", "export the body again");
  }
  return *value;
}

double LineScanner::coordinate() {
  const double value = number("a coordinate");
  const std::string problem = coordinate_problem(value);
  if (!problem.empty()) fail(problem, coordinate_remedy);
  return value;
}

long long LineScanner::integer(const std::string& what, long long low, long long high) {
  const std::string_view given = word();
  if (given.empty()) fail(what + " is missing", "");
  long long value = 0;
  const auto read = std::from_chars(given.data(), given.data() + given.size(), value);
  if (read.ec != std::errc() || read.ptr != given.data() + given.size()) {
    fail(what + " is " + shown(given) + ", which is not a whole number", "");
  }
  if (value < low || value > high) {
    fail(what + " is " + std::to_string(value) + ", outside " + std::to_string(low) + " to " +
             std::to_string(high),
         "");
  }
  return value;
}

std::string LineScanner::place() const { return name_ + ":" + std::to_string(number_); }

void LineScanner::fail(const std::string& problem, const std::string& remedy) const {
  throw Error(place(), problem, remedy);
}

std::string shown(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c < 127 ? c : '?';
  return text + (word.size() > 40 ? "...'" : "'");
}

}  // namespace toile
