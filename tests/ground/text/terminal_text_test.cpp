#include "text/terminal_text.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

namespace fissure::terminal_text_test {

namespace {

/// What comes out behind a PlainOutput when `write` writes to the stream.
template <class Write>
std::string behind(Write write) {
  std::ostringstream stream;
  {
    const PlainOutput plain(stream);
    write(stream);
  }
  return stream.str();
}

std::string shown(const std::string& text) {
  return behind([&](std::ostream& out) { out << text; });
}

TEST(PlainOutput, OrdinaryTextStaysAsItIs) {
  const std::string text = "run\t1: Z\xc3\xbcrich, 3 \xe2\x82\xac \xf0\x9f\x98\x80\n";
  EXPECT_EQ(shown(text), text);
}

TEST(PlainOutput, WhatControlsATerminalIsWrittenOut) {
  EXPECT_EQ(shown("\x1b]0;owned\x07"), "\\u001b]0;owned\\u0007");
  EXPECT_EQ(shown("a\rb\x7f"), "a\\u000db\\u007f");
  EXPECT_EQ(shown("\xc2\x9b"
                  "2J"),
            "\\u009b2J");
  EXPECT_EQ(shown("\xe2\x80\xae"
                  "txt\xe2\x81\xa9"),
            "\\u202etxt\\u2069");
  EXPECT_EQ(shown(std::string("a\0b", 3)), "a\\u0000b");
}

TEST(PlainOutput, BytesThatAreNoUtf8AreWrittenOut) {
  EXPECT_EQ(shown("a\x9b"
                  "b\xff\n"),
            "a\\x9bb\\xff\n");
  EXPECT_EQ(shown("cut \xe2\x82"), "cut \\xe2\\x82");
  EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80");
}

TEST(PlainOutput, ACharacterMayComeInPieces) {
  EXPECT_EQ(behind([](std::ostream& out) {
              out << '\xc2' << std::flush << '\x9b' << "\xe2\x82" << std::flush << "\xac";
              out.put('\x1b');
            }),
            "\\u009b\xe2\x82\xac\\u001b");
  EXPECT_EQ(behind([](std::ostream& out) {
              out << std::setw(4) << "\xc3\xa9"
                  << ".";
            }),
            "  \xc3\xa9.");
}

TEST(PlainOutput, AStreamThatCannotWriteSaysSo) {
  struct Full : std::streambuf {
  } full;
  std::ostream stream(&full);
  {
    const PlainOutput plain(stream);
    stream << "text";
    EXPECT_FALSE(stream.good());
  }
  EXPECT_EQ(stream.rdbuf(), &full);
}

}  // namespace
}  // namespace fissure::terminal_text_test
