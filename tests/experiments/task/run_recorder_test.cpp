#include "task/run_recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "measure/statistics.h"
#include "task/curves.h"

namespace fissure::run_recorder_test {

namespace {

/// time, depth, two laws' force and elastic term, the tool's place, contacts.
RecordLayout layoutOfTwoLaws() {
  RecordLayout layout;
  layout.addAxis({"law", {"hc", "lin"}});
  layout.addAxis(xyzAxis());
  layout.addAxis({"tool", {"blade"}});
  layout.add({.name = "time", .units = "s", .long_name = "time"});
  layout.add({.name = "penetration_depth", .units = "m", .long_name = "depth"});
  layout.add({.name = "force", .units = "N", .long_name = "force", .axes = {"law", "xyz"}});
  layout.add({.name = "force_elastic", .units = "N", .long_name = "elastic", .axes = {"law"}});
  layout.add({.name = "tool_position", .units = "m", .long_name = "place", .axes = {"tool", "xyz"}});
  layout.add({.name = "contact_count", .units = "1", .long_name = "contacts"});
  layout.add({.name = "timing/step_time_us", .units = "us", .long_name = "wall time"});
  return layout;
}

RecordRow rowAt(double time_s, double depth_m, double force_N, double tool_x_m, double contacts) {
  return {time_s, depth_m, 0, force_N, 0, 3 * force_N, 4 * force_N, 0, 7, 8, tool_x_m, 0, 0, contacts, 5};
}

std::string complaint(const std::vector<std::string>& names) {
  try {
    curveQuantities(names, layoutOfTwoLaws(), "s.yaml:3");
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(CurveQuantities, AreWhatTheRecordHasWithOneValueAStep) {
  const auto curves = curveQuantities({"force", "penetration_depth", "indentation"}, layoutOfTwoLaws(), "");
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_TRUE(curves[0].per_law);
  EXPECT_EQ(curves[0].units, "N");
  EXPECT_FALSE(curves[1].per_law);
  EXPECT_EQ(curves[2].units, "m");
  EXPECT_EQ(complaint({"depth"}).substr(0, 54), "s.yaml:3: no quantity \"depth\" with one value a step, e");
  EXPECT_EQ(complaint({"force", "force"}), "s.yaml:3: \"force\" twice, expected each quantity once");
  for (const char* no_curve : {"time", "tool_position", "timing/step_time_us"})
    EXPECT_NE(complaint({no_curve}), "nothing") << no_curve;
}

TEST(CurveTimes, EndWithTheLastThatFits) {
  EXPECT_EQ(curveTimes_s({{}, 0.1, 0.3}), (std::vector<double>{0, 0.1, 0.2, 0.1 * 3}));
  EXPECT_EQ(curveTimes_s({{}, 0.25, 0.6}), (std::vector<double>{0, 0.25, 0.5}));
  EXPECT_EQ(curveTimes_s({{}, 0.25, 0.25}).size(), 2u);
}

class Recorder : public testing::Test {
 protected:
  TaskNumbers record(const std::vector<RecordRow>& rows, const std::vector<double>& times_s) {
    RunRecorder recorder(
        layout_, {.curves = curveQuantities({"force", "penetration_depth", "indentation"}, layout_, ""),
                  .times_s = times_s});
    for (const RecordRow& row : rows) recorder.append(row);
    recorder.finish({RunEnd::non_finite, "at step 3"}, {{"max_force_N", 2.5},
                                                        {"steps", 3LL},
                                                        {"hash", std::string("abc")},
                                                        {"timing/mean_us", 9.0},
                                                        {"provenance/engine", std::string("x")}});
    record_ = recorder.record();
    return decodeNumbers(record_.numbers);
  }
  RecordLayout layout_ = layoutOfTwoLaws();
  TaskRecord record_;
};

// Steps of 0.1 s; values in tenths, so that interpolation is exact to rounding.
TEST_F(Recorder, KeepsCurvesAtTheirTimes) {
  const std::vector<double> times_s = {0, 0.05, 0.1, 0.3, 0.35};
  const TaskNumbers numbers = record({rowAt(0, 1, 10, 0.5, 0), rowAt(0.1, 2, 20, 0.7, 3),
                                      rowAt(0.2, 3, 40, 0.8, 0), rowAt(0.1 * 3, 4, 80, 1.2, 1)},
                                     times_s);
  const std::vector<double> expected = {10, 15,  20,  80,  kMissing,   // force of hc: its magnitude
                                        50, 75,  100, 400, kMissing,   // of lin
                                        1,  1.5, 2,   4,   kMissing,   // depth
                                        0,  0,   0,   0.5, kMissing};  // from where it touched first
  ASSERT_EQ(numbers.curves.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::isnan(numbers.curves[i]), std::isnan(expected[i])) << i;
    if (!std::isnan(expected[i])) {
      EXPECT_NEAR(numbers.curves[i], expected[i], 1e-12) << i;
    }
  }
}

TEST_F(Recorder, KeepsNumbersTextsAndTimingsApart) {
  const TaskNumbers numbers = record({}, {});
  EXPECT_EQ(numbers.names, (std::vector<std::string>{"max_force_N", "steps"}));
  EXPECT_EQ(numbers.values, (std::vector<double>{2.5, 3}));
  EXPECT_EQ(numbers.texts, (std::map<std::string, std::string>{{"hash", "abc"}}));
  EXPECT_EQ(record_.timing, (std::map<std::string, double>{{"timing/mean_us", 9}}));
  EXPECT_EQ(nameOf(record_.status.end), "non_finite");
}

TEST_F(Recorder, AValueThatIsMissingStaysMissing) {
  const TaskNumbers numbers = record({rowAt(0, kMissing, 10, 0, 0), rowAt(0.1, 2, 20, 0, 0)}, {0, 0.05, 0.1});
  EXPECT_TRUE(std::isnan(numbers.curves[6]) && std::isnan(numbers.curves[7]));
  EXPECT_EQ(numbers.curves[8], 2);
}

}  // namespace
}  // namespace fissure::run_recorder_test
