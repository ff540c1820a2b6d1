#include "io/dxf_groups.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geometry/error.h"
#include "io/text.h"

namespace toile {

namespace {

/// Units of a drawing: beyond, products of coordinates lose their digits.
constexpr double max_dxf_coordinate = 1e9;

/// Values of one entity: a polyline has some five for each vertex.
constexpr std::size_t max_groups = 2'000'000;

}  // namespace

std::string_view dxf_trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

DxfGroups::DxfGroups(std::string_view text, const std::string& name) : text_(text), name_(name) {
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
}

bool DxfGroups::is(int code, std::string_view value) const {
  return now_.code == code && dxf_trimmed(now_.value) == value;
}

void DxfGroups::next() {
  do {
    const std::string_view code = dxf_trimmed(line("a group code"));
    const char* end = code.data() + code.size();
    const auto [stop, problem] = std::from_chars(code.data(), end, now_.code);
    if (problem != std::errc() || stop != end) {
      fail("'" + shown_text(code.substr(0, 20)) + "' is no group code",
           "the file is damaged or no DXF; save it again");
    }
    now_.value = line("the value of a group");
    now_.line = line_;
  } while (now_.code == 999);  // a comment
}

DxfRecord DxfGroups::record() {
  DxfRecord record{dxf_trimmed(now().value), now().line, {}};
  for (next(); now().code != 0; next()) {
    if (record.groups.size() == max_groups) {
      fail_at(record.line, "an entity has more than " + std::to_string(max_groups) + " values");
    }
    record.groups.push_back(now());
  }
  return record;
}

double DxfGroups::number(const DxfGroup& group) const {
  const auto value = parse_number(dxf_trimmed(group.value));
  if (!value || !std::isfinite(*value)) {
    fail_at(group.line, "'" + shown_text(group.value.substr(0, 40)) + "' is no number",
            "the file is damaged; save it again");
  }
  return *value;
}

double DxfGroups::coordinate(const DxfGroup& group) const {
  const double value = number(group);
  if (std::abs(value) > max_dxf_coordinate) {
    fail_at(group.line, "a coordinate is " + number_text(value) + ", beyond 1,000,000,000 units");
  }
  return value;
}

int DxfGroups::integer(const DxfGroup& group) const {
  return static_cast<int>(std::clamp(number(group), -1e9, 1e9));
}

void DxfGroups::fail(const std::string& problem, const std::string& remedy) const {
  fail_at(line_, problem, remedy);
}

void DxfGroups::fail_at(int line, const std::string& problem, const std::string& remedy) const {
  throw Error(name_ + ":" + std::to_string(line), problem, remedy);
}

std::string_view DxfGroups::line(const char* what) {
  if (at_ >= text_.size()) {
    fail("the file ends before " + std::string(what) + ", without an EOF",
         "it is cut off; save or copy it again");
  }
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view found = text_.substr(at_, end - at_);
  at_ = end + 1;
  if (end < text_.size() && text_[end] == '\r' && at_ < text_.size() && text_[at_] == '\n') ++at_;
  ++line_;
  return found;
}

}  // namespace toile
