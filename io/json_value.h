// Checked reading of JSON from users. Every value knows its place in the file.
#pragma once

#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace toile {

/// A value inside a JsonDocument, which has to outlive it. Reading a value of another type throws
/// an Error that names its place. Keys with the value null count as absent.
class JsonValue {
 public:
  JsonValue(const nlohmann::ordered_json& json, std::string place)
      : json_(&json), place_(std::move(place)) {}

  /// The same value with another place, for messages that say "edge 3" instead of "edges[3]".
  JsonValue called(std::string place) const { return {*json_, std::move(place)}; }
  const std::string& place() const { return place_; }
  /// Throws Error with the value's place.
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "") const;

  bool is_object() const;
  bool is_array() const;
  bool is_text() const;
  bool is_flag() const;  ///< true or false

  /// The keys of an object, in the file's order.
  std::vector<std::string> keys() const;
  /// The value of an object's key. When it is absent, find() returns nothing and get() throws
  /// Error.
  std::optional<JsonValue> find(const std::string& key) const;
  JsonValue get(const std::string& key) const;

  /// The number of a list's entries. Throws Error when it is not `min` to `max`.
  std::size_t size(std::size_t min = 0,
                   std::size_t max = std::numeric_limits<std::size_t>::max()) const;
  /// Entry `i` of a list, i < size().
  JsonValue item(std::size_t i) const;

  /// A finite number.
  double number() const;
  /// A whole number in [0, below).
  int index(int below = std::numeric_limits<int>::max()) const;
  /// True or false. A number counts as true unless it is 0.
  bool flag() const;
  std::string text() const;

 private:
  const nlohmann::ordered_json* json_;
  std::string place_;
};

/// Lists and objects within one another. Patterns have some ten.
inline constexpr int max_json_depth = 100;

/// Keys of one object. Searching an object takes time linear in them.
inline constexpr std::size_t max_json_keys = 10'000;

/// The only way from a text to JSON: nlohmann's own parser has no bounds, and deep nesting ends the
/// program.
///
/// Throws Error with the place "name:line:column" for text that is not JSON and for a number too
/// large for a double. Nesting deeper than max_json_depth is an Error, too. A key that an object
/// has twice, and more keys than max_json_keys, are Errors with the place "name".
nlohmann::ordered_json parse_json(const std::string& text, const std::string& name);

/// A JSON text, parsed.
class JsonDocument {
 public:
  /// Throws Error as parse_json() does.
  JsonDocument(const std::string& text, const std::string& name);
  ~JsonDocument();
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;

  JsonValue root() const;

 private:
  std::unique_ptr<nlohmann::ordered_json> json_;
  std::string name_;
};

}  // namespace toile
