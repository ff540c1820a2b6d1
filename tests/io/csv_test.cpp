#include "io/csv.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/error.h"

namespace toile {
namespace csv_test {

using Fields = std::vector<std::string>;

std::string message_of(const std::string& text) {
  try {
    parse_csv(text, "table.csv");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Csv, FieldsAndLines) {
  const std::vector<CsvRow> rows = parse_csv(
      "\xEF\xBB\xBF"
      "name , note\r\n\r\na,\"one, \"\"two\"\"\nthree\"\r\nb,\n\"\nx\",y\nlast,",
      "table.csv");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].fields, (Fields{"name", "note"}));
  EXPECT_EQ(rows[1].fields, (Fields{"a", "one, \"two\"\nthree"}));
  EXPECT_EQ(rows[2].fields, (Fields{"b", ""}));
  EXPECT_EQ(rows[3].fields, (Fields{"\nx", "y"}));
  EXPECT_EQ(rows[4].fields, (Fields{"last", ""}));
  const int lines[] = {1, 3, 5, 6, 8};
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].line, lines[i]) << i;
  EXPECT_TRUE(parse_csv("", "table.csv").empty());
}

TEST(Csv, WrongQuotesAreNamedByLine) {
  EXPECT_EQ(message_of("a,b\n1,2\n"), "");
  EXPECT_NE(message_of("a\nx\"y\n").find("table.csv:2: "), std::string::npos);
  EXPECT_NE(message_of("a\n\"x\"y\n").find("table.csv:2: "), std::string::npos);
  EXPECT_NE(message_of("a\nb\n\"x\n\nz\n").find("table.csv:3: "), std::string::npos);
}

TEST(Csv, WhatIsWrittenIsRead) {
  std::mt19937 random(1);
  const std::string letters = "a, \"\r\n\t;\xC3\xA9";
  for (int trial = 0; trial < 2000; ++trial) {
    Fields fields(1 + random() % 4);
    for (std::string& field : fields) {
      for (std::size_t n = random() % 6; n > 0; --n) field += letters[random() % letters.size()];
    }
    fields.front() += 'x';  // a line of nothing is no row
    const std::vector<CsvRow> rows = parse_csv(csv_line(fields), "table.csv");
    ASSERT_EQ(rows.size(), 1U) << csv_line(fields);
    EXPECT_EQ(rows[0].fields, fields) << csv_line(fields);
  }
}

TEST(Csv, AnyBytesAreReadOrRefused) {
  std::mt19937 random(2);
  const std::string letters = std::string("a,\"\r\n ") + '\0' + "\xFF";
  int read = 0, refused = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    std::string text;
    for (std::size_t n = random() % 40; n > 0; --n) text += letters[random() % letters.size()];
    (message_of(text).empty() ? read : refused) += 1;
  }
  EXPECT_GT(read, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace csv_test
}  // namespace toile
