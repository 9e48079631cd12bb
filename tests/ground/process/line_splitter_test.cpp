#include "process/line_splitter.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fissure::line_splitter_test {

namespace {

std::vector<std::string> linesOf(LineSplitter& splitter, const std::vector<std::string>& pieces) {
  std::vector<std::string> lines;
  for (const std::string& piece : pieces)
    splitter.feed(piece, [&](std::string_view line) { lines.emplace_back(line); });
  return lines;
}

TEST(LineSplitter, JoinsPiecesAndCutsAtLineEnds) {
  LineSplitter splitter(100);
  EXPECT_EQ(linesOf(splitter, {"pro", "gress 1 2\npro", "gress 2 2\r\n\nrest"}),
            (std::vector<std::string>{"progress 1 2", "progress 2 2", ""}));
  std::string last;
  splitter.finish([&](std::string_view line) { last = line; });
  EXPECT_EQ(last, "rest");
}

TEST(LineSplitter, NothingPendingIsNoLastLine) {
  LineSplitter splitter(100);
  linesOf(splitter, {"a\n"});
  splitter.finish([](std::string_view) { FAIL() << "no line was begun"; });
}

TEST(LineSplitter, KeepsOnlyTheBeginningOfALongLine) {
  LineSplitter splitter(4);
  EXPECT_EQ(linesOf(splitter, {"abcdefgh", std::string(1000000, 'x'), "\nok\n"}),
            (std::vector<std::string>{"abcd", "ok"}));
}

TEST(PrintableLine, KeepsTextAndReplacesTheRest) {
  EXPECT_EQ(printableLine("no space: gr\xC3\xB6\xC3\x9F"
                          "e"),
            "no space: gr\xC3\xB6\xC3\x9F"
            "e");
  EXPECT_EQ(printableLine(std::string_view("a\0b\x1b[2Jc\x7f", 9)), "a?b?[2Jc?");
  EXPECT_EQ(printableLine("\xC0\xAF \xED\xA0\x80 \xF5\x80\x80\x80 \xE2\x82"), "?? ??? ???? ??");
}

}  // namespace
}  // namespace fissure::line_splitter_test
