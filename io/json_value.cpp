#include "io/json_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "geometry/error.h"

namespace toile {

namespace {

/// "line:column" of a byte, both counted from 1.
std::string line_and_column(const std::string& text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const auto line =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
  const std::size_t start = byte == 0 ? std::string::npos : text.rfind('\n', byte - 1);
  const std::size_t column = start == std::string::npos ? byte : byte - start - 1;
  return std::to_string(line + 1) + ":" + std::to_string(std::max<std::size_t>(column, 1));
}

}  // namespace

void JsonValue::fail(const std::string& problem, const std::string& remedy) const {
  throw Error(place_, problem, remedy);
}

bool JsonValue::is_object() const { return json_->is_object(); }
bool JsonValue::is_array() const { return json_->is_array(); }
bool JsonValue::is_text() const { return json_->is_string(); }
bool JsonValue::is_flag() const { return json_->is_boolean(); }

std::vector<std::string> JsonValue::keys() const {
  if (!is_object()) fail("is not an object");
  std::vector<std::string> keys;
  for (const auto& [key, ignored] : json_->items()) keys.push_back(key);
  return keys;
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  if (!is_object()) fail("is not an object");
  const auto found = json_->find(key);
  if (found == json_->end() || found->is_null()) return std::nullopt;
  return JsonValue(*found, place_ + ", " + key);
}

JsonValue JsonValue::get(const std::string& key) const {
  auto value = find(key);
  if (!value) fail("has no '" + key + "'");
  return *value;
}

std::size_t JsonValue::size(std::size_t min, std::size_t max) const {
  if (!is_array()) fail("is not a list");
  const std::size_t size = json_->size();
  if (size >= min && size <= max) return size;
  std::string wanted = std::to_string(min);
  if (max == std::numeric_limits<std::size_t>::max()) {
    wanted += " or more";
  } else if (max != min) {
    wanted += " to " + std::to_string(max);
  }
  fail("has " + std::to_string(size) + " entries, not " + wanted);
}

JsonValue JsonValue::item(std::size_t i) const {
  return {json_->at(i), place_ + "[" + std::to_string(i) + "]"};
}

double JsonValue::number() const {
  if (!json_->is_number()) fail("is not a number");
  const double value = json_->get<double>();
  if (!std::isfinite(value)) fail("is not a finite number");
  return value;
}

int JsonValue::index(int below) const {
  if (!json_->is_number_integer()) fail("is not a whole number");
  const auto value = json_->get<std::int64_t>();
  if (value < 0 || value >= below) {
    fail(std::to_string(value) + " is not in 0 to " + std::to_string(below - 1));
  }
  return static_cast<int>(value);
}

bool JsonValue::flag() const { return json_->is_boolean() ? json_->get<bool>() : number() != 0; }

std::string JsonValue::text() const {
  if (!is_text()) fail("is not text");
  return json_->get<std::string>();
}

JsonDocument::JsonDocument(const std::string& text, const std::string& name) : name_(name) {
  try {
    json_ = std::make_unique<nlohmann::ordered_json>(nlohmann::ordered_json::parse(text));
  } catch (const nlohmann::ordered_json::parse_error& error) {
    throw Error(name + ":" + line_and_column(text, error.byte), "is not JSON here",
                "look for a missing or extra comma, quote or bracket at or before this place");
  } catch (const nlohmann::ordered_json::exception& error) {
    throw Error(name, std::string("is not JSON (") + error.what() + ")", "");
  }
}

JsonDocument::~JsonDocument() = default;

JsonValue JsonDocument::root() const { return {*json_, name_}; }

}  // namespace toile
