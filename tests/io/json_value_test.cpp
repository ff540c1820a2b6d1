#include "io/json_value.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "geometry/error.h"

namespace toile {
namespace json_value_test {

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(JsonValue, ReadsWhatIsThere) {
  const JsonDocument document(R"({"b": 1.5, "a": [3, true], "nothing": null, "text": "t"})",
                              "f.json");
  const JsonValue root = document.root();
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"b", "a", "nothing", "text"}));
  EXPECT_EQ(root.get("b").number(), 1.5);
  EXPECT_EQ(root.get("a").size(), 2u);
  EXPECT_EQ(root.get("a").item(0).index(), 3);
  EXPECT_TRUE(root.get("a").item(1).flag());
  EXPECT_EQ(root.get("text").text(), "t");
  EXPECT_FALSE(root.find("nothing"));
  EXPECT_FALSE(root.find("absent"));
}

TEST(JsonValue, NamesThePlaceOfWhatIsWrong) {
  const JsonDocument document(R"({"a": [1, -2, 1.5, "x", 12345678901234567890]})", "f.json");
  const JsonValue a = document.root().get("a");
  EXPECT_EQ(error_of([&] { a.item(1).index(); }), "f.json, a[1]: -2 is not in 0 to 2147483646");
  EXPECT_EQ(error_of([&] { a.item(0).index(1); }), "f.json, a[0]: 1 is not in 0 to 0");
  EXPECT_EQ(error_of([&] { a.item(2).index(); }), "f.json, a[2]: is not a whole number");
  EXPECT_EQ(error_of([&] { a.item(3).number(); }), "f.json, a[3]: is not a number");
  EXPECT_NE(error_of([&] { a.item(4).index(); }), "");
  EXPECT_EQ(error_of([&] { a.item(0).text(); }), "f.json, a[0]: is not text");
  EXPECT_EQ(error_of([&] { a.item(0).keys(); }), "f.json, a[0]: is not an object");
  EXPECT_EQ(error_of([&] { a.item(0).size(); }), "f.json, a[0]: is not a list");
  EXPECT_EQ(error_of([&] { a.size(2, 2); }), "f.json, a: has 5 entries, not 2");
  EXPECT_EQ(error_of([&] { a.size(6); }), "f.json, a: has 5 entries, not 6 or more");
  EXPECT_EQ(error_of([&] { document.root().get("b"); }), "f.json: has no 'b'");
  EXPECT_EQ(error_of([&] { a.called("edge 3").get("b"); }), "edge 3: is not an object");
}

TEST(JsonValue, SaysWhereTextIsNotJson) {
  const auto message = [](const std::string& text) {
    return error_of([&] { const JsonDocument document(text, "f.json"); });
  };
  EXPECT_EQ(message("{\n \"a\": ]").substr(0, 31), "f.json:2:7: is not JSON here; l");
  EXPECT_NE(message(""), "");
  EXPECT_EQ(message("[1,\n1e999]").substr(0, 33), "f.json:2:5: a number is too large");
  EXPECT_NE(message("\"\xff\""), "");
  EXPECT_NE(message(std::string(100000, '[')), "");
  EXPECT_EQ(message("{}"), "");
}

TEST(JsonValue, DeepNestingAndDoubledKeysAreRefused) {
  const auto message = [](const std::string& text) {
    return error_of([&] { const JsonDocument document(text, "f.json"); });
  };
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(message(nested(max_json_depth)), "");
  EXPECT_EQ(message("\n" + nested(max_json_depth + 1)).substr(0, 37),
            "f.json:2:101: more than 100 lists and");
  EXPECT_NE(message(nested(140000)), "");
  EXPECT_EQ(message("[\"\\\"" + std::string(200, '[') + "\"]"), "");  // text, not lists
  EXPECT_EQ(message(R"({"a": 1, "b": {"a": 2}})"), "");
  EXPECT_EQ(message(R"({"a": 1, "a": 2})"),
            "f.json: an object has the key 'a' twice; remove or rename one of the two");
  std::string many = "{\"k\": 0";
  for (std::size_t i = 0; i < max_json_keys; ++i) many += ",\"k" + std::to_string(i) + "\": 0";
  EXPECT_NE(message(many + "}").find("more than 10000 keys"), std::string::npos);
}

TEST(ParseJson, KeepsTheOrderOfKeysAndHasTheBoundsOfADocument) {
  EXPECT_EQ(parse_json(R"({"b": 1, "a": [2]})", "f.json").dump(), R"({"b":1,"a":[2]})");
  const auto message = [](const std::string& text) {
    return error_of([&] { parse_json(text, "f.json"); });
  };
  EXPECT_EQ(message(std::string(200000, '[')).substr(0, 37),
            "f.json:1:101: more than 100 lists and");
  EXPECT_EQ(message("{\"a\": 1,}").substr(0, 30), "f.json:1:9: is not JSON here; ");
}

}  // namespace json_value_test
}  // namespace toile
