#include "study/tradeoff_file.h"

#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "study/tradeoff_points.h"

namespace fissure::tradeoff_file_test {

namespace {

const std::string kStudy = R"(format: 1
name: some
base: scene.yaml
pipelines: [swept]
axes:
  - {path: time.step_s, values: [0.001, 0.002, 0.004]}
  - zip:
      - {path: tools.blade.nodes.resolution.0, values: [16, 8]}
      - {path: tools.blade.nodes.resolution.1, values: [16, 8]}
reference:
  pipeline: swept
  ladder: {path: time.step_s, values: [0.004, 0.002, 0.001]}
errors:
  - {quantity: depth, tolerance: 0.1mm}
  - {quantity: force, law: hc, tolerance: 2%, measure: worst}
)";

TradeoffStudy load(const std::string& text) {
  const TemporaryFolder folder;
  writeFile(folder.path() / "study.yaml", text);
  return loadTradeoff(folder.path() / "study.yaml");
}

/// The study with the first `from` replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = kStudy;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// What is wrong, from the line number on.
std::string studyErrorFor(const std::string& text) {
  try {
    load(text);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("study.yaml") + 10);
  }
  return "";
}

}  // namespace

TEST(TradeoffFile, ReadsAStudy) {
  const TradeoffStudy study = load(kStudy);
  EXPECT_EQ(study.name, "some");
  EXPECT_EQ(study.reference.pipeline, "swept");
  EXPECT_EQ(study.reference.sizes, (std::vector<double>{0.004, 0.002, 0.001}));
  EXPECT_DOUBLE_EQ(study.errors[0].size.value, 1e-4);
  EXPECT_TRUE(study.errors[1].size.relative);
  EXPECT_EQ(study.errors[1].measure, ErrorMeasure::worst);
  EXPECT_EQ(study.repeats, 3);
}

TEST(TradeoffFile, AStarVariesOneGroupAboutTheFirstSetting) {
  const StudyPoints points = settingsOf(load(kStudy));
  using Row = std::vector<std::string>;
  EXPECT_EQ(points.paths[1], "tools.blade.nodes.resolution.0");
  EXPECT_EQ(points.values,
            (std::vector<Row>{
                {"0.001", "16", "16"}, {"0.002", "16", "16"}, {"0.004", "16", "16"}, {"0.001", "8", "8"}}));
}

TEST(TradeoffFile, AGridHasEveryCombination) {
  const StudyPoints points = settingsOf(load(with("pipelines: [swept]", "design: grid")));
  using Row = std::vector<std::string>;
  ASSERT_EQ(points.values.size(), 6u);
  EXPECT_EQ(points.values[1], (Row{"0.001", "8", "8"}));
  EXPECT_EQ(points.values[5], (Row{"0.004", "8", "8"}));
}

TEST(TradeoffFile, RungsLeaveOtherAxesAtTheirFirstValue) {
  const StudyPoints rungs = rungsOf(load(kStudy));
  using Row = std::vector<std::string>;
  EXPECT_EQ(rungs.values,
            (std::vector<Row>{{"0.004", "16", "16"}, {"0.002", "16", "16"}, {"0.001", "16", "16"}}));
}

TEST(TradeoffFile, RefusesWithLineAndWhatWasExpected) {
  EXPECT_EQ(studyErrorFor("# nothing\n"), ":1: empty, expected a study");
  EXPECT_NE(studyErrorFor("format: 1\naxes: []\n").find("a sweep"), std::string::npos);
  EXPECT_NE(studyErrorFor("format: 1\nbodies: []\n").find("a scenario"), std::string::npos);
  EXPECT_NE(studyErrorFor(with("reference:", "referenz:")).find("a sweep"), std::string::npos);
  EXPECT_NE(studyErrorFor(with("  pipeline: swept", "  pipelin: swept")).find("did you mean \"pipeline\""),
            std::string::npos);
  EXPECT_EQ(studyErrorFor(with("[0.004, 0.002, 0.001]}\nerr", "[0.004, 0.002]}\nerr")),
            ":12: reference.ladder has 2 rungs, expected at least three: fewer tell no order");
  EXPECT_NE(studyErrorFor(with("[0.004, 0.002, 0.001]}\nerr", "[0.001, 0.002, 0.004]}\nerr"))
                .find(":12: reference"),
            std::string::npos);
  EXPECT_NE(
      studyErrorFor(with("errors:", "  sizes: [2, 1]\nerrors:")).find(":13: reference.sizes has 2 values"),
      std::string::npos);
  EXPECT_NE(studyErrorFor(with("errors:", "  sizes: [4, 2, .nan]\nerrors:")), "");
  EXPECT_EQ(studyErrorFor(with("0.1mm", "0.1N")),
            ":14: depth is \"0.1N\", expected a size above 0 with its unit, as 0.1mm or 2%");
  EXPECT_EQ(studyErrorFor(with("quantity: force, law: hc", "quantity: depth")),
            ":15: depth again, expected each quantity once");
  EXPECT_EQ(studyErrorFor(with("quantity: force,", "quantity: reaction,")),
            ":15: a law for reaction, expected it only for force");
  EXPECT_NE(studyErrorFor(with("[16, 8]", "[16, 8, 4]")).find("expected as many of zipped axes"),
            std::string::npos);
  EXPECT_NE(studyErrorFor(with("name: some", "name: some\nrepeats: 0")), "");
  EXPECT_NE(studyErrorFor(with("tools.blade.nodes.resolution.0", "force.hc.k"))
                .find("force.hc.k is of a force law, which moves nothing"),
            std::string::npos);
}

}  // namespace fissure::tradeoff_file_test
