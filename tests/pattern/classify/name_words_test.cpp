#include "pattern/classify/name_words.h"

#include <gtest/gtest.h>

namespace toile {
namespace name_words_test {

std::vector<std::string> texts(const std::string& name) {
  std::vector<std::string> all;
  for (const NameWord& word : words_in(name)) all.push_back(word.text);
  return all;
}

TEST(NameWords, PartAtCapitalsDigitsAndMarks) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(texts("leftSleeve_12b"), (Words{"left", "sleeve", "12", "b"}));
  EXPECT_EQ(texts("Ärmel, rückwärts"), (Words{"armel", "ruckwarts"}));
  EXPECT_EQ(texts(" -/ "), Words{});
  EXPECT_TRUE(words_in("no 7")[1].number);
}

TEST(NameWords, ShortBeginningsHaveToBeTheWordLongOnesMayStandInIt) {
  EXPECT_TRUE(any_fits(words_in("Vorderhose"), {"hose"}));
  EXPECT_TRUE(any_fits(words_in("Hemdkragen"), {"kragen"}));
  EXPECT_TRUE(any_fits(words_in("legs leg"), {"leg"}));
  EXPECT_FALSE(any_fits(words_in("collegiate"), {"leg", "col"}));
  EXPECT_FALSE(any_fits(words_in("Innenhosenbund"), {"hose"}));
}

}  // namespace name_words_test
}  // namespace toile
