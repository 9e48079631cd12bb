#include "text/lists.h"

#include <gtest/gtest.h>

namespace fissure::lists_test {

namespace {

TEST(Lists, AreWordsOfASentence) {
  EXPECT_EQ(inWords({}), "");
  EXPECT_EQ(inWords({"a"}), "a");
  EXPECT_EQ(inWords({"a", "b"}), "a and b");
  EXPECT_EQ(inWords({"a", "b", "c"}, "or"), "a, b or c");
  EXPECT_EQ(withNoun("model", {"a"}), "model a");
  EXPECT_EQ(withNoun("model", {"a", "b"}), "models a and b");
}

}  // namespace
}  // namespace fissure::lists_test
