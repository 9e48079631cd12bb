// What is said to somebody who has typed the wrong thing: one line each, with what to type instead.
#include <gtest/gtest.h>

#include <sstream>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::misuse_test {
namespace {

/// press.yaml, speeds.yaml (a sweep over it), press.h5 (its result), curve.csv.
class Misuse : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder;
    folder->write("press.yaml", pressScenario());
    folder->write("speeds.yaml",
                  "format: 1\n"
                  "name: pressing_speeds\n"
                  "base: press.yaml\n"
                  "axes:\n"
                  "  - {path: tools.spatula.motion.segments.0.speed_m_s, values: [0.4, 0.5]}\n");
    folder->write("curve.csv", "depth_mm,force_N\n0,0\n1,1\n2,3\n3,5\n");
    ASSERT_EQ(runFissure(*folder, {"run", "press.yaml", "-o", "press.h5"}).code, 0);
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static Folder* folder;
};

Folder* Misuse::folder = nullptr;

struct Slip {
  std::vector<std::string> words;
  std::string said;  ///< all of standard error, without the line end
};

TEST_F(Misuse, IsAnsweredInOneLine) {
  const std::string a_sweep =
      "speeds.yaml:4: a sweep (it has axes), expected a scenario; type: fissure sweep speeds.yaml (with "
      "--dry-run it only says what it would run)";
  const std::vector<Slip> slips = {
      {{"run", "speeds.yaml"}, a_sweep},
      {{"validate", "speeds.yaml"}, a_sweep},
      {{"plan", "speeds.yaml"}, a_sweep},
      {{"sweep", "press.yaml"},
       "press.yaml:6: a scenario (it has bodies and no axes), expected a sweep; type: fissure run "
       "press.yaml"},
      {{"fit", "press.yaml"},
       "press.yaml: a scenario, expected a table of measured points; type: fissure run press.yaml"},
      {{"fit", "speeds.yaml"},
       "speeds.yaml: a sweep, expected a table of measured points; type: fissure sweep speeds.yaml"},
      {{"fit", "curve.csv", "--sweep", "speeds.yaml"},
       "--sweep speeds.yaml: a sweep, expected the folder of a sweep that has run; type: fissure sweep "
       "speeds.yaml"},
      {{"fit", "curve.csv", "--result", "press.yaml"},
       "--result press.yaml: a scenario, expected the result of one; type: fissure run press.yaml"},
      {{"run", "press.h5"},
       "press.h5: is an HDF5 file, as results are, expected YAML; type: fissure info press.h5"},
      {{"sweep", "press.h5"},
       "press.h5: is an HDF5 file, as results are, expected YAML; type: fissure info press.h5"},
      {{"runn"}, "fissure: no command \"runn\", did you mean \"run\"? (see fissure --help)"},
      {{"raport", "press.h5"},
       "fissure: no command \"raport\", did you mean \"report\"? (see fissure --help)"},
      {{"sweep", "statu", "d"}, "fissure sweep: no file \"statu\", did you mean \"status\"?"},
      {{"list", "laws"}, "fissure list: \"laws\" was not expected (see fissure list --help)"},
      {{"run", "--forc", "press.yaml"},
       "fissure run: no option --forc, did you mean --force? (see fissure run --help)"},
      {{"run", "--forc"}, "fissure run: no option --forc, did you mean --force? (see fissure run --help)"},
      {{"run", "press.yaml", "--outptu=x.h5"},
       "fissure run: no option --outptu, did you mean --output? (see fissure run --help)"},
      {{"validate", "press.yaml", "--pipe", "fukuhara"},
       "fissure validate: no option --pipe, did you mean --pipeline? (see fissure validate --help)"},
      {{"sweep", "--dryrun", "speeds.yaml"},
       "fissure sweep: no option --dryrun, did you mean --dry-run? (see fissure sweep --help)"},
      {{"plan", "press.yaml", "--zzz"}, "fissure plan: no option --zzz (see fissure plan --help)"},
      {{"plan", "press.yaml", "-Z"}, "fissure plan: no option -Z (see fissure plan --help)"},
      {{"plan"}, "fissure plan: SCENARIO is required (see fissure plan --help)"},
      {{"init", "a", "--template", "pres"},
       "fissure init: --template: \"pres\" is no choice, did you mean \"press\"? (see fissure init --help)"},
      {{"completion", "zsh"},
       "fissure completion: SHELL: \"zsh\" is no choice, expected one of bash (see fissure completion "
       "--help)"},
  };
  for (const Slip& slip : slips) {
    std::string typed = "fissure";
    for (const std::string& word : slip.words) typed += " " + word;
    const Outcome outcome = runFissure(*folder, slip.words);
    EXPECT_EQ(outcome.code, 2) << typed;
    EXPECT_EQ(outcome.err, slip.said + "\n") << typed;
    EXPECT_EQ(outcome.out, "") << typed;
  }
}

TEST_F(Misuse, BrokenYamlIsExplainedInPlainWords) {
  struct Broken {
    const char* text;
    const char* said;
  };
  const std::vector<Broken> texts = {
      {"format: 1\nbodies: [a, b\ntools: 1\n",
       "s.yaml:3: column 6: a list that [ has begun is not closed, expected \",\" or \"]\""},
      {"x: {a: 1, b: 2\ntools: 1\n",
       "s.yaml:2: column 6: a map that { has begun is not closed, expected \",\" or \"}\""},
      {"a: {b: [1, 2}\n",
       "s.yaml:1: column 13: a bracket that closes none, expected \"]\" for each [ and \"}\" for each {"},
      {"format: 1\n name: x\n",
       "s.yaml:2: column 6: a \":\" that follows no key, expected one `key: value` in a line, the keys of a "
       "map "
       "below each other, and texts with \": \" in quotes"},
      {"a:\n  b: 1\n c: 2\n",
       "s.yaml:3: column 2: this does not go on with the map above it, expected `key: value` lines that "
       "begin "
       "below each other, or the end of a text where its second quote stands"},
      {"key: - a\n",
       "s.yaml:1: column 6: \"- \" where no item can stand, expected items in lines below their key"},
      {"name: \"abc\nformat: 1\n",
       "s.yaml:2: column 10: a text in quotes is not closed, expected its second quote"},
      {"x: \"a\\qb\"\n",
       "s.yaml:1: column 8: a backslash before what it cannot change, expected \\\\ or a text in single "
       "quotes"},
      {"a: %b\n",
       "s.yaml:1: column 4: a value that begins with a character which YAML keeps for itself, expected it in "
       "quotes"},
  };
  for (const Broken& broken : texts) {
    folder->write("s.yaml", broken.text);
    for (const char* verb : {"run", "validate", "sweep"}) {
      const Outcome outcome = runFissure(*folder, {verb, "s.yaml"});
      EXPECT_EQ(outcome.code, 2) << broken.text;
      EXPECT_EQ(outcome.err, std::string(broken.said) + "\n") << broken.text;
    }
  }
}

// A reader who has what it wanted closes the pipe.
TEST_F(Misuse, AClosedPipeIsNoError) {
  for (const std::string words : {"list", "explain --all", "schema", "info press.h5", "plan press.yaml"}) {
    const Outcome outcome = runTool(
        *folder,
        {"bash", "-c", fissureProgram() + " " + words + " | (exec 0<&-; sleep 0.3); echo ${PIPESTATUS[0]}"});
    EXPECT_EQ(outcome.out, "0\n") << words;
    EXPECT_EQ(outcome.err, "") << words;
  }
}

// Whoever reads help looks for something to copy.
TEST_F(Misuse, EveryHelpEndsWithAnExample) {
  const std::string help = runFissure(*folder, {"--help"}).out;
  std::vector<std::string> verbs;
  std::istringstream lines(help.substr(help.find("ubcommands:")));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ") && line[2] != ' ') verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  EXPECT_GE(verbs.size(), 16u) << help;
  for (const std::string& verb : verbs) {
    const std::string text = runFissure(*folder, {verb, "--help"}).out;
    const std::size_t at = text.find("\nExample: ");
    ASSERT_NE(at, std::string::npos) << verb;
    EXPECT_NE(text.find("fissure " + verb, at), std::string::npos) << verb;
    EXPECT_EQ(text.find('\n', at + 1), text.size() - 1) << verb;
  }
}

TEST_F(Misuse, BashCompletesVerbsAndOptions) {
  const Outcome script = runFissure(*folder, {"completion", "bash"});
  ASSERT_EQ(script.code, 0);
  folder->write("completion.sh", script.out);
  const auto completed = [&](const std::string& words, int at) {
    return runTool(*folder, {"bash", "-c",
                             ". ./completion.sh; COMP_WORDS=(" + words +
                                 "); COMP_CWORD=" + std::to_string(at) + "; _fissure; echo ${COMPREPLY[@]}"})
        .out;
  };
  EXPECT_EQ(completed("fissure va", 1), "validate\n");
  EXPECT_EQ(completed("fissure re", 1), "render report\n");
  EXPECT_EQ(completed("fissure run press.yaml --pi", 3), "--pipeline\n");
  EXPECT_EQ(completed("fissure sweep --dr", 2), "--dry-run\n");
  EXPECT_EQ(completed("fissure run pre", 2), "\n");  // files, by bash itself
}

TEST_F(Misuse, ASweepGoesIntoTheFolderOfItsName) {
  ASSERT_EQ(runFissure(*folder, {"sweep", "speeds.yaml"}).code, 0);
  const Outcome again = runFissure(*folder, {"sweep", "status", "out/pressing_speeds"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("to do: 0 of 2 simulations"), std::string::npos) << again.out;
}

TEST_F(Misuse, AnAxisThatChangesNothingIsToldBefore) {
  const auto saidOf = [&](const std::string& path, const std::string& values, const std::string& pipelines) {
    folder->write("all.yaml", pressScenario("[{pipeline: fukuhara}, {pipeline: swept}]"));
    folder->write("idle.yaml", "format: 1\nname: idle\nbase: all.yaml\npipelines: " + pipelines +
                                   "\naxes: [{path: " + path + ", values: " + values + "}]\n");
    return runFissure(*folder, {"sweep", "idle.yaml", "--dry-run"}).out;
  };
  const std::string warning = "    warning: changes nothing in any run: ";
  const std::string nodes = "tools.spatula.nodes.resolution";
  EXPECT_NE(saidOf(nodes, "[[4, 4], [5, 5]]", "[swept]").find(warning + "no run has nodes\n"),
            std::string::npos);
  EXPECT_EQ(saidOf(nodes, "[[4, 4], [5, 5]]", "[fukuhara, swept]").find("warning"), std::string::npos);
  EXPECT_NE(saidOf("record.snapshots_every_s", "[0.01, 0.02]", "[]").find(warning), std::string::npos);
  EXPECT_NE(saidOf("bodies.sphere.clusters.count", "[0, 8]", "[]").find(warning), std::string::npos);
  EXPECT_EQ(saidOf("tools.spatula.friction", "[0, 0.3]", "[]").find("warning"), std::string::npos);
}

// A table wider than the terminal is cut into parts below each other.
TEST_F(Misuse, TablesFitTheTerminal) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"run", "press.yaml", "-o", "press.h5", "--force"}, {"list"}, {"explain", "--all"}}) {
    std::vector<std::string> typed = {fissureProgram()};
    typed.insert(typed.end(), words.begin(), words.end());
    Program program(*folder, typed, {.file_bytes = {}, .error_is_terminal = true, .out_is_terminal = true});
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, 0);
    std::istringstream lines(outcome.err);  // of the terminal
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);) {
      while (!line.empty() && line.back() == '\r') line.pop_back();
      line.erase(0, line.rfind("\x1b[K") == std::string::npos ? 0 : line.rfind("\x1b[K") + 3);
      if (!line.starts_with("reaction: ") && !line.starts_with("fukuhara: "))
        longest = std::max(longest, line.size());  // sentences
    }
    EXPECT_LE(longest, 100u) << words[0] << "\n" << outcome.err;
    EXPECT_GT(longest, 60u) << words[0] << "\n" << outcome.err;
  }
  const std::string piped = runFissure(*folder, {"run", "press.yaml", "-o", "press.h5", "--force"}).out;
  EXPECT_NE(piped.find("contacts"), std::string::npos);
  EXPECT_NE(piped.find("over all"), std::string::npos);
  EXPECT_EQ(piped.find("\n\n"), std::string::npos) << piped;
}

}  // namespace
}  // namespace fissure::programs::misuse_test
