#include "io/json_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "geometry/error.h"
#include "io/text.h"

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

/// Throws Error where the nesting is too deep. It comes before the parsing, which is recursive.
void refuse_deep_nesting(const std::string& text, const std::string& name) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++i;
    if (quoted) continue;
    if (c == '}' || c == ']') --depth;
    if ((c == '{' || c == '[') && ++depth > max_json_depth) {
      throw Error(name + ":" + line_and_column(text, i + 1),
                  "more than " + std::to_string(max_json_depth) +
                      " lists and objects are within one another here",
                  "is it really a file for Toile?");
    }
  }
}

/// Watches the parsing for objects that are too large or have a key twice.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& name) : name_(name) {}

  bool operator()(int, nlohmann::ordered_json::parse_event_t event,
                  const nlohmann::ordered_json& parsed) {
    using Event = nlohmann::ordered_json::parse_event_t;
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key) add(parsed.get_ref<const std::string&>());
    return true;
  }

 private:
  void add(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      throw Error(name_, "an object has the key '" + shown_text(key) + "' twice",
                  "remove or rename one of the two");
    }
    if (keys_.back().size() > max_json_keys) {
      throw Error(name_, "an object has more than " + std::to_string(max_json_keys) + " keys",
                  "is it really a file for Toile?");
    }
  }

  const std::string& name_;
  std::vector<std::unordered_set<std::string>> keys_;
};

/// Finds the byte and the word at which the parser stops. The parser's exceptions know no byte
/// where a number is too large.
struct StopFinder : nlohmann::json_sax<nlohmann::ordered_json> {
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string& word,
                   const nlohmann::detail::exception&) override {
    byte = position;
    last = word;
    return false;
  }

  std::size_t byte = 0;
  std::string last;
};

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
  return JsonValue(*found, place_ + ", " + shown_text(key));
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

nlohmann::ordered_json parse_json(const std::string& text, const std::string& name) {
  using Json = nlohmann::ordered_json;
  refuse_deep_nesting(text, name);
  KeyWatch watch(name);
  try {
    return Json::parse(text, std::ref(watch));
  } catch (const Json::exception&) {
  }
  StopFinder stop;
  Json::sax_parse(text, &stop);
  const std::string place = name + ":" + line_and_column(text, stop.byte);
  if (const auto number = parse_number(stop.last); number && !std::isfinite(*number)) {
    throw Error(place, "a number is too large", "correct it");
  }
  throw Error(place, "is not JSON here",
              "look for a missing or extra comma, quote or bracket at or before this place");
}

JsonDocument::JsonDocument(const std::string& text, const std::string& name)
    : json_(std::make_unique<nlohmann::ordered_json>(parse_json(text, name))), name_(name) {}

JsonDocument::~JsonDocument() = default;

JsonValue JsonDocument::root() const { return {*json_, name_}; }

}  // namespace toile
