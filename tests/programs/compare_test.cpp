// fissure compare, on results of its own runs.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::compare_test {
namespace {

namespace fs = std::filesystem;

const std::string two_runs = "[{pipeline: default}, {pipeline: fukuhara}]";
const std::string record =
    "force: [{name: hc, model: hunt_crossley}]\n"
    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.02, size_px: [64, 48]}}\n";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Compare : public testing::Test {
 protected:
  Compare() {
    folder_.write("s.yaml", pressScenario(two_runs, "0.03", record));
    EXPECT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "a.h5"}).code, 0);
  }
  Outcome compare(std::vector<std::string> words) {
    words.insert(words.begin(), "compare");
    return runFissure(folder_, std::move(words));
  }
  void copy(const std::string& to) { fs::copy_file(folder_ / "a.h5", folder_ / to); }

  Folder folder_;
};

TEST_F(Compare, AResultAgreesWithItselfAndWithARerun) {
  ASSERT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "b.h5", "-j", "2"}).code, 0);
  for (const std::string b : {"a.h5", "b.h5"}) {
    const Outcome outcome = compare({"a.h5", b, "--exact"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "fukuhara: 0 quantities differ") && has(outcome.out, "A agrees with B"));
    EXPECT_EQ(outcome.err, "");
  }
}

TEST_F(Compare, EachDamageIsFoundAndNamed) {
  const std::string python = pythonWith("h5py, numpy");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"nan", "penetration_depth DIFFERS: NaN in A at step 7 (7 ms)"},
      {"missing", "only in B: contact_count"},
      {"unit", "penetration_depth DIFFERS: unit mm against m"},
      {"micrometre", "snapshot 2 (20 ms), vertex 3, y"}};
  for (const auto& [damage, words] : damages) {
    copy(damage + ".h5");
    const std::string script = FISSURE_SOURCE_DIR "/tests/programs/edit_result.py";
    ASSERT_EQ(runTool(folder_, {python, script, damage + ".h5", damage}).code, 0);
    const Outcome outcome = compare({damage + ".h5", "a.h5"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(has(outcome.out, words)) << damage << "\n" << outcome.out;
    EXPECT_TRUE(has(outcome.out, "default: 0 quantities differ")) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "1 quantity differs") && has(outcome.out, "A differs from B"))
        << outcome.out;
  }
}

TEST_F(Compare, TruncatedAndMissingFilesAreOneLine) {
  copy("cut.h5");
  fs::resize_file(folder_ / "cut.h5", fs::file_size(folder_ / "cut.h5") / 2);
  folder_.write("empty.h5", "");
  for (const std::string nothing : {"", "a.h5:"}) {
    EXPECT_EQ(compare({nothing, "a.h5"}).code, 2) << nothing;
    EXPECT_EQ(compare({"a.h5", nothing}).code, 2) << nothing;
  }
  for (const std::string bad : {"cut.h5", "empty.h5", "missing.h5", "s.yaml", "."}) {
    const Outcome as_result = compare({bad, "a.h5"});
    EXPECT_EQ(as_result.code, 2) << bad;
    EXPECT_TRUE(isOneLine(as_result.err) && has(as_result.err, bad)) << as_result.err;
    const Outcome as_reference = compare({"a.h5", bad});
    EXPECT_EQ(as_reference.code, 1) << bad;
    EXPECT_TRUE(isOneLine(as_reference.err) && has(as_reference.err, bad)) << as_reference.err;
  }
}

TEST_F(Compare, TwoRunsOfOneResult) {
  const Outcome outcome = compare({"a.h5:default", ":fukuhara"});
  EXPECT_EQ(outcome.code, 1);
  for (const char* words : {"A  a.h5:default", "B  a.h5:fukuhara", "summary/max_force_N", "penetration_depth",
                            "only in B: ", "largest: of absolute values"})
    EXPECT_TRUE(has(outcome.out, words)) << words << "\n" << outcome.out;
  EXPECT_EQ(compare({"a.h5:fukuhara", "a.h5"}).code, 0);
  const Outcome unknown = compare({"a.h5:fukuhra", "a.h5"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(isOneLine(unknown.err) && has(unknown.err, "expected one of default, fukuhara")) << unknown.err;
}

TEST_F(Compare, ARunThatOneSideLacksFails) {
  ASSERT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "one.h5", "--pipeline", "default"}).code, 0);
  const Outcome outcome = compare({"one.h5", "a.h5"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(has(outcome.out, "DIFFERS: run fukuhara is missing in A")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "note: the resolved scenarios differ, first in line ")) << outcome.out;
}

TEST_F(Compare, TolerancesComeFromAFile) {
  ASSERT_EQ(
      runFissure(folder_, {"run", "s.yaml", "-o", "b.h5", "--set", "bodies.sphere.mass_kg=0.1000001"}).code,
      0);
  EXPECT_EQ(compare({"b.h5", "a.h5"}).code, 1);
  folder_.write("t.yaml",
                "format: 1\n"
                "tolerances:\n"
                "  - {quantity: '*', relative: 1e-3}\n"
                "  - {quantity: summary/final_state_hash, ignore: true}\n"
                "  - {quantity: frames, ignore: true}\n");
  const Outcome outcome = compare({"b.h5", "a.h5", "--tolerance", "t.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "within their tolerance")) << outcome.out;
  EXPECT_EQ(compare({"b.h5", "a.h5", "--tolerance", "t.yaml", "--exact"}).code, 1);
  folder_.write("bad.yaml", "format: 1\ntolerances:\n  - {quantity: force, relativ: 1}\n");
  const Outcome bad = compare({"b.h5", "a.h5", "--tolerance", "bad.yaml"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(isOneLine(bad.err) && has(bad.err, "bad.yaml:3: ")) << bad.err;
}

TEST_F(Compare, UpdateMakesAReferenceAndLeavesAnEqualOneAlone) {
  const Outcome made = compare({"a.h5", "r.h5", "--update"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(has(made.out, "reference: r.h5 written from a.h5")) << made.out;
  EXPECT_EQ(compare({"a.h5", "r.h5", "--exact"}).code, 0);
  EXPECT_TRUE(has(runFissure(folder_, {"info", "r.h5"}).out, "command_line"));
  const std::string bytes = folder_.read("r.h5");
  ASSERT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "a.h5", "--force"}).code, 0);
  EXPECT_TRUE(has(compare({"a.h5", "r.h5", "--update"}).out, "r.h5 is up to date"));
  EXPECT_EQ(folder_.read("r.h5"), bytes);

  ASSERT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "b.h5", "--set", "bodies.sphere.mass_kg=0.11"}).code,
            0);
  EXPECT_EQ(compare({"b.h5", "r.h5"}).code, 1);
  const Outcome changed = compare({"b.h5", "r.h5", "--update"});
  EXPECT_EQ(changed.code, 0) << changed.err;
  EXPECT_TRUE(has(changed.out, "positions") && has(changed.out, "reference: r.h5 written from b.h5"))
      << changed.out;
  EXPECT_EQ(compare({"b.h5", "r.h5"}).code, 0);
}

TEST_F(Compare, UpdateRefusesWhatIsNoReference) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"a.h5", "a.h5"}, {"a.h5:default", "r.h5"}, {"a.h5", "r.h5:default"}, {"missing.h5", "r.h5"}};
  for (const auto& [a, b] : bad) {
    const Outcome outcome = compare({a, b, "--update"});
    EXPECT_EQ(outcome.code, 2) << a << " " << b;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  }
  copy("result.h5");
  const std::string bytes = folder_.read("result.h5");
  const Outcome over_result = compare({"a.h5", "result.h5", "--update"});
  EXPECT_EQ(over_result.code, 2);
  EXPECT_TRUE(isOneLine(over_result.err) && has(over_result.err, "is no reference")) << over_result.err;
  EXPECT_EQ(folder_.read("result.h5"), bytes);
}

TEST_F(Compare, JsonIsForMachines) {
  const Outcome outcome = compare({"a.h5:default", ":fukuhara", "--json"});
  EXPECT_EQ(outcome.code, 1);
  for (const char* words : {"\"exit_code\": 1", "\"agrees\": false", "\"quantity\": \"penetration_depth\"",
                            "\"largest_difference\": ", "\"problem\": \"missing in A\""})
    EXPECT_TRUE(has(outcome.out, words)) << words;
  const std::string python = pythonWith("json");
  if (python.empty()) GTEST_SKIP() << "no python3 here";
  folder_.write("c.json", outcome.out);
  EXPECT_EQ(runTool(folder_, {python, "-m", "json.tool", "c.json", "out.json"}).code, 0);
}

TEST(CompareOptions, AShiftThatIsNoNumberIsRefused) {
  const Folder folder;
  const Outcome outcome = runFissure(folder, {"compare", "a.h5", "b.h5", "--max-shift", "nan"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(
      outcome.err,
      "fissure compare: --max-shift: nan: expected a number from 0 to 1e+06 (see fissure compare --help)\n");
}

}  // namespace
}  // namespace fissure::programs::compare_test
