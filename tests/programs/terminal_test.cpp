// Texts of foreign files on the terminal.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::terminal_test {
namespace {

/// Bytes that a terminal obeys: all C0 but line ends and tabs, DEL, and what begins a C1 character or is one.
bool commands(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f) return true;
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) return true;
  }
  return false;
}

TEST(Terminal, NamesInAForeignResultCannotCommandIt) {
  const std::string python = pythonWith("h5py, numpy");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "a.h5"}).code, 0);
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "b.h5"}).code, 0);
  const std::string script = FISSURE_SOURCE_DIR "/tests/programs/edit_result.py";
  ASSERT_EQ(runTool(folder, {python, script, "b.h5", "escape"}).code, 0);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"info", "b.h5"},
                                                {"info", "b.h5", "--json"},
                                                {"compare", "a.h5", "b.h5"},
                                                {"compare", "b.h5", "a.h5", "--all"},
                                                {"compare", "b.h5", "b.h5", "--json"},
                                                {"render", "b.h5"},
                                                {"export", "b.h5"},
                                                {"report", "b.h5", "--force"}}) {
    const Outcome outcome = runFissure(folder, words);
    EXPECT_EQ(outcome.signal, 0) << words[0];
    EXPECT_FALSE(commands(outcome.out)) << words[0] << "\n" << outcome.out;
    EXPECT_FALSE(commands(outcome.err)) << words[0] << "\n" << outcome.err;
  }
  EXPECT_NE(runFissure(folder, {"info", "b.h5"}).out.find("\\u001b]0;owned\\u0007\\u009b2J"),
            std::string::npos)
      << runFissure(folder, {"info", "b.h5"}).out;
}

TEST(Terminal, AMistakeInAScenarioCannotCommandIt) {
  const Folder folder;
  folder.write("s.yaml",
               "format: 1\nname: \"a\xc2\x9b"
               "2J\"\n");
  const Outcome name = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(name.code, 2);
  EXPECT_EQ(name.err,
            "s.yaml:2: name is the text \"a\\u009b2J\", expected one line without control characters\n");
  const Outcome file = runFissure(folder, {"validate", "\x1b]0;owned\x07.yaml"});
  EXPECT_EQ(file.code, 2);
  EXPECT_FALSE(commands(file.err)) << file.err;
}

}  // namespace
}  // namespace fissure::programs::terminal_test
