#include "text/wrapped_text.h"

#include <gtest/gtest.h>

namespace fissure::wrapped_text_test {

namespace {

TEST(WrappedText, LinesHaveAtMostAHundredCharacters) {
  EXPECT_EQ(wrappedText({}, 2), "  \n");
  EXPECT_EQ(wrappedText({"one", "two"}, 2), "  one two\n");
  const std::string word(47, 'w');
  EXPECT_EQ(wrappedText({word, word, word}, 2), "  " + word + " " + word + "\n      " + word + "\n")
      << "97 characters, and 4 blanks more";
  const std::string full(50, 'f');
  EXPECT_EQ(wrappedText({word, full, "x"}, 2), "  " + word + " " + full + "\n      x\n") << "100 fit";
  const std::string longest(200, 'l');
  EXPECT_EQ(wrappedText({longest, "x"}, 0), longest + "\n    x\n") << "a word is not cut";
}

}  // namespace

}  // namespace fissure::wrapped_text_test
