#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace fissure::utf8_test {

namespace {

using Kind = Utf8Start::Kind;

TEST(Utf8, CharactersOfEachLengthAreRead) {
  EXPECT_EQ(utf8Start("a").character, 0x61u);
  EXPECT_EQ(utf8Start("\xc3\xa9x").character, 0xe9u);
  EXPECT_EQ(utf8Start("\xe2\x82\xac").character, 0x20acu);
  EXPECT_EQ(utf8Start("\xf0\x9f\x98\x80").character, 0x1f600u);
  EXPECT_EQ(utf8Start("\xf4\x8f\xbf\xbf").character, 0x10ffffu);
  EXPECT_EQ(utf8Start("\xf0\x9f\x98\x80z").bytes, 4u);
}

TEST(Utf8, WhatIsNoneIsTold) {
  for (const char* bad : {"\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xc3z", "\xe2\x82z"})
    EXPECT_EQ(utf8Start(bad).kind, Kind::bad_byte) << bad;
  for (const char* begun : {"\xc3", "\xe2", "\xe2\x82", "\xf0\x9f\x98"})
    EXPECT_EQ(utf8Start(begun).kind, Kind::unfinished) << begun;
}

TEST(Utf8, APlainLineShowsWhatItSays) {
  for (const char* plain : {"", "run_1", "Z\xc3\xbcrich \xe2\x82\xac \xf0\x9f\x98\x80"})
    EXPECT_TRUE(isPlainLine(plain)) << plain;
  for (const char* not_plain : {"a\nb", "a\tb", "\x1b[2J", "\x7f",
                                "\xc2\x9b"
                                "2J",
                                "\xe2\x80\xae"
                                "gnp.exe",
                                "\xe2\x81\xa6", "\xe2\x80\xa8", "\xff"})
    EXPECT_FALSE(isPlainLine(not_plain)) << not_plain;
}

}  // namespace
}  // namespace fissure::utf8_test
