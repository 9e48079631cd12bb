// A comment that cites a METHOD.md names a room that has one, and headings that stand in it: read from the
// sources and the books themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fissure::citations_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FISSURE_SOURCE_DIR;
const std::string kBook = "METHOD.md";

/// The numbers of the headings of each book, "3" and "6.1", by the room it stands in.
using Books = std::map<std::string, std::set<std::string>>;

std::string readAll(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool isNumber(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
}

/// "## 6.1 Friction" and "## 6. Response" begin with 6.1 and 6; empty where a heading has no number.
std::string numberOf(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isNumber(text[end])) ++end;
  while (end > at && text[end - 1] == '.') --end;
  return text.substr(at, end - at);
}

Books books() {
  Books found;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "src")) {
    if (entry.path().filename() != kBook) continue;
    std::set<std::string>& headings = found[entry.path().parent_path().filename().string()];
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with("##")) continue;
      const std::string number = numberOf(line, line.find_first_not_of("# "));
      if (!number.empty()) headings.insert(number);
    }
  }
  return found;
}

/// `code` with line breaks and the comment marks after them as one blank, so that a citation may wrap.
std::string unwrapped(const std::string& code) {
  std::string text;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i] != '\n') {
      text += code[i];
      continue;
    }
    while (i + 1 < code.size() && (code[i + 1] == ' ' || code[i + 1] == '/' || code[i + 1] == '<')) ++i;
    text += ' ';
  }
  return text;
}

/// What is wrong with the citations in `code`, one line each: "contact/METHOD.md 3", "3 to 6", "1 and 2" are
/// those that are understood, and METHOD alone is none.
std::vector<std::string> complaints(const std::string& code, const Books& known, int& citations) {
  std::vector<std::string> found;
  const std::string text = unwrapped(code);
  for (std::size_t at = text.find("METHOD"); at != std::string::npos; at = text.find("METHOD", at + 1)) {
    std::size_t end = at + kBook.size();
    const std::string around = text.substr(at, 40);
    ++citations;
    std::size_t begin = at;
    while (begin > 0 && (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '/'))
      --begin;
    const std::string room = text.substr(begin, at - begin);
    const auto book = room.empty() ? known.end() : known.find(room.substr(0, room.size() - 1));
    if (text.compare(at, kBook.size(), kBook) != 0 || book == known.end()) {
      found.push_back(room + around + ": no book of a room");
      continue;
    }
    bool any = false;
    for (const std::string_view before : {" ", " to ", " and "}) {
      if (text.compare(end, before.size(), before) != 0) continue;
      const std::string number = numberOf(text, end + before.size());
      if (number.empty()) continue;
      any = true;
      end += before.size() + number.size();
      if (!book->second.contains(number)) found.push_back(room + around + ": no heading " + number);
    }
    if (!any) found.push_back(room + around + ": no heading is named");
  }
  return found;
}

TEST(Citations, EachNamesAHeadingOfABook) {
  const Books known = books();
  ASSERT_GE(known.size(), 4u);
  for (const auto& [room, headings] : known) EXPECT_GE(headings.size(), 5u) << room;
  int citations = 0;
  for (const char* part : {"src", "tests", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / part)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".h" && file.extension() != ".cpp") continue;
      if (file.filename() == "citations_test.cpp") continue;
      for (const std::string& complaint : complaints(readAll(file), known, citations))
        ADD_FAILURE() << file << ": " << complaint;
    }
  EXPECT_GT(citations, 25) << "the comments were not understood";
}

TEST(Citations, WhatNamesNothingIsSeen) {
  const Books known = {{"contact", {"1", "2", "3", "6.1"}}};
  int citations = 0;
  const auto wrong = [&](const std::string& code) { return complaints(code, known, citations).size(); };
  EXPECT_EQ(wrong("/// Rays (contact/METHOD.md 3).\n/// Slip (contact/METHOD.md\n  /// 6.1).\n"), 0u);
  EXPECT_EQ(wrong("// (contact/METHOD.md 1 to 3) (contact/METHOD.md 1 and 2)\n"), 0u);
  EXPECT_EQ(wrong("// (contact/METHOD.md 4)\n"), 1u);
  EXPECT_EQ(wrong("// (contact/METHOD.md 1 to 9)\n"), 1u);
  EXPECT_EQ(wrong("// (contact/METHOD.md)\n"), 1u);
  EXPECT_EQ(wrong("// (engine/METHOD.md 1)\n"), 1u);
  EXPECT_EQ(wrong("// (METHOD: force) (METHOD section 3) (METHOD.md 3)\n"), 3u);
  EXPECT_EQ(citations, 11);
}

}  // namespace

}  // namespace fissure::citations_test
