#include "io/view/page_template.h"

#include <gtest/gtest.h>

namespace toile {
namespace page_template_test {

TEST(PageTemplate, FillsGapsOnce) {
  const auto name_twice = [](std::string_view name) {
    return "{{" + std::string(name) + "}}" + std::string(name);
  };
  EXPECT_EQ(filled("a {{b}} c {{d}}", name_twice), "a {{b}}b c {{d}}d");
  EXPECT_EQ(filled("", name_twice), "");
  EXPECT_EQ(filled("no gap }}", name_twice), "no gap }}");
}

TEST(PageTemplate, NoTextOfJsonEndsItsElement) {
  EXPECT_EQ(json_in_html(R"({"a": "</script><b>"})"), R"({"a": "\u003c/script>\u003cb>"})");
}

}  // namespace page_template_test
}  // namespace toile
