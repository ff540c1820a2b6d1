// JSON from outside, read with distrust: every value knows its place in the file.
#pragma once

#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace toile {

/// A value inside a JsonDocument, which has to outlive it. Reading something of another form throws
/// an Error that names the place. Keys with the value null count as absent.
class JsonValue {
 public:
  JsonValue(const nlohmann::ordered_json& json, std::string place)
      : json_(&json), place_(std::move(place)) {}

  /// The same value under another name, for messages that should say "edge 3", not "edges[3]".
  JsonValue called(std::string place) const { return {*json_, std::move(place)}; }
  const std::string& place() const { return place_; }
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "") const;

  bool is_object() const;
  bool is_array() const;
  bool is_text() const;
  bool is_flag() const;  ///< true or false

  /// Of an object: its keys in the file's order, the value of one, or nothing.
  std::vector<std::string> keys() const;
  std::optional<JsonValue> find(const std::string& key) const;
  JsonValue get(const std::string& key) const;

  /// Of a list of `min` to `max` entries: their number, and each one.
  std::size_t size(std::size_t min = 0,
                   std::size_t max = std::numeric_limits<std::size_t>::max()) const;
  JsonValue item(std::size_t i) const;

  double number() const;                                         ///< finite
  int index(int below = std::numeric_limits<int>::max()) const;  ///< whole, in [0, below)
  bool flag() const;  ///< true or false, or a number that is 0 or not
  std::string text() const;

 private:
  const nlohmann::ordered_json* json_;
  std::string place_;
};

class JsonDocument {
 public:
  /// Throws Error with "name:line:column" for text that is not JSON.
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
