#include "study/stability_class.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fissure {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kRows = 201, kRest = 121;

CellCurve constant(const std::string& name, bool is_force, double value) {
  return {name, is_force, std::vector<double>(kRows, value)};
}

/// A good run: contact from step 20 on, 0.1 mm deep, a steady force.
CellRun goodRun() {
  CellRun run;
  run.step_s = 0.001;
  run.rest_from = kRest;
  run.thickness_m = 0.002;
  run.summary = {
      {"contact_steps", 180LL}, {"passed_through_samples", 0LL}, {"max_inversion_aware_depth_m", 0.0001},
      {"unsound_steps", 0LL},   {"uncertified_steps", 0LL},      {"first_uncertified", std::string()}};
  run.curves = {constant("kinetic_energy", false, 1e-6), constant("penetration_depth", false, 0.0001),
                constant("contact_count", false, 3), constant("capped_count", false, 0),
                constant("reaction", true, 2.0)};
  for (std::size_t row = 0; row < 20; ++row) run.curves[2].values[row] = 0;
  return run;
}

CellCurve& curve(CellRun& run, const std::string& name) {
  for (CellCurve& one : run.curves)
    if (one.name == name) return one;
  run.curves.push_back(constant(name, true, 0));
  return run.curves.back();
}

void set(CellRun& run, const std::string& name, const std::variant<double, long long, std::string>& value) {
  for (SummaryValue& one : run.summary)
    if (one.name == name) {
      one.value = value;
      return;
    }
  run.summary.push_back({name, value});
}

CellClass classOf(const CellRun& run) {
  return classify(run, {});
}

#define EXPECT_CLASS(run, wanted)                                                          \
  EXPECT_EQ(stabilityClasses()[static_cast<std::size_t>(classOf(run).kind)].name, #wanted) \
      << classOf(run).reason

TEST(StabilityClass, AGoodRunIsStable) {
  EXPECT_CLASS(goodRun(), stable);
  CellRun run = goodRun();
  curve(run, "reaction").values.assign(kRows, kNan);  // Bullet's own contact does not report it
  EXPECT_CLASS(run, stable);
  curve(run, "reaction").values[0] = 0;  // but for the initial state
  EXPECT_CLASS(run, stable);
  curve(run, "reaction").values[1] = 0;
  EXPECT_CLASS(run, non_finite);
  run = goodRun();
  set(run, "uncertified_steps", kNan);  // not asked for
  EXPECT_CLASS(run, stable);
}

TEST(StabilityClass, WhatIsRefusedWasNotRun) {
  CellRun run;
  run.refused = "a step needs more than 10000 substeps";
  EXPECT_CLASS(run, refused);
  run.status = {RunEnd::missing, ""};
  EXPECT_CLASS(run, refused);
  EXPECT_EQ(classOf(run).reason, run.refused);
  run.refused.clear();
  EXPECT_CLASS(run, crashed);
}

TEST(StabilityClass, AWorkerThatEndsOtherwiseCrashed) {
  for (const RunEnd end : {RunEnd::crashed, RunEnd::failed, RunEnd::incomplete, RunEnd::missing}) {
    CellRun run;
    run.status = {end, "signal 11"};
    EXPECT_CLASS(run, crashed);
    EXPECT_NE(classOf(run).reason.find("signal 11"), std::string::npos);
  }
}

TEST(StabilityClass, ARunThatWasStoppedIsTooSlowWhateverElse) {
  CellRun run;
  run.status = {RunEnd::timeout, "after 5 s"};
  EXPECT_CLASS(run, too_slow);
  EXPECT_EQ(classOf(run).reason, "timeout: after 5 s");
  run = goodRun();
  run.status = {RunEnd::timeout, ""};
  EXPECT_CLASS(run, too_slow);
  run.alone = "inside out";
  EXPECT_CLASS(run, too_slow);
}

TEST(StabilityClass, NonFiniteNamesStepAndFirstQuantity) {
  CellRun run;
  run.status = {RunEnd::non_finite, "sphere at step 7 (t = 0.007 s)"};
  EXPECT_CLASS(run, non_finite);
  EXPECT_EQ(classOf(run).reason, "sphere at step 7 (t = 0.007 s)");
  run = goodRun();
  curve(run, "reaction").values[50] = std::numeric_limits<double>::infinity();
  curve(run, "kinetic_energy").values[60] = kNan;
  EXPECT_CLASS(run, non_finite);
  EXPECT_EQ(classOf(run).reason, "reaction at step 50");
  run = goodRun();
  set(run, "force_non_finite_at_step_hc", 12LL);
  EXPECT_CLASS(run, non_finite);
  run = goodRun();
  run.curves.erase(run.curves.begin() + 1);  // no depth
  EXPECT_CLASS(run, non_finite);
  run = goodRun();
  curve(run, "kinetic_energy").values.assign(kRows, kNan);
  EXPECT_CLASS(run, non_finite);
  run = goodRun();
  run.curves.clear();
  EXPECT_CLASS(run, non_finite);
}

TEST(StabilityClass, TissueIsUnsoundByItselfBeforeContactOrWithoutTheTool) {
  CellRun run = goodRun();
  set(run, "unsound_steps", 5LL);
  set(run, "unsound_tissue", std::string("sphere: inside out"));
  set(run, "first_unsound_step", 19LL);
  EXPECT_CLASS(run, unsound_alone);
  set(run, "first_unsound_step", 20LL);  // the first contact's step: the tool may be the cause
  EXPECT_CLASS(run, penetrating);
  curve(run, "contact_count").values.assign(kRows, 0);
  EXPECT_CLASS(run, unsound_alone);
  run = goodRun();
  run.alone = "sphere: three times as long";
  set(run, "passed_through_samples", 3LL);
  EXPECT_CLASS(run, unsound_alone);
}

TEST(StabilityClass, PassingThroughComesBeforeDepth) {
  CellRun run = goodRun();
  set(run, "passed_through_samples", 1LL);
  EXPECT_CLASS(run, passed_through);
  curve(run, "penetration_depth").values[150] = 0.01;
  EXPECT_CLASS(run, passed_through);
  set(run, "passed_through_samples", 0LL);
  EXPECT_CLASS(run, penetrating);
}

TEST(StabilityClass, DepthIsLimitedByTheThinnerOfTwoBounds) {
  CellRun run = goodRun();
  curve(run, "penetration_depth").values[150] = 0.0005;
  EXPECT_CLASS(run, stable);
  curve(run, "penetration_depth").values[150] = 0.00051;
  EXPECT_CLASS(run, penetrating);
  run = goodRun();
  run.thickness_m = 0.0003;  // a quarter is 75 um
  EXPECT_CLASS(run, penetrating);
  run = goodRun();
  set(run, "max_inversion_aware_depth_m", 0.002);
  EXPECT_CLASS(run, penetrating);
  run = goodRun();
  set(run, "uncertified_steps", 2LL);
  EXPECT_CLASS(run, penetrating);
  EXPECT_EQ(classify(run, {.proved = false}).kind, StabilityClass::stable);
  run = goodRun();
  run.thickness_m = kNan;  // no depth is small enough
  EXPECT_CLASS(run, penetrating);
}

TEST(StabilityClass, EnergyThatGrowsAtRest) {
  CellRun run = goodRun();
  for (std::size_t row = kRest; row < kRows; ++row)
    curve(run, "kinetic_energy").values[row] = 1e-6 * std::exp(0.1 * static_cast<double>(row - kRest));
  EXPECT_CLASS(run, energy_growing);
  CellRun slow = goodRun();
  for (std::size_t row = kRest; row < kRows; ++row)
    curve(slow, "kinetic_energy").values[row] = 1e-6 * std::exp(0.02 * static_cast<double>(row - kRest));
  EXPECT_CLASS(slow, stable);
  CellRun pressed = goodRun();
  for (std::size_t row = 0; row < kRest; ++row)
    curve(pressed, "kinetic_energy").values[row] = 1e-6 * std::exp(0.1 * static_cast<double>(row));
  EXPECT_CLASS(pressed, stable);  // the tool does work while it moves
}

TEST(StabilityClass, ForcesThatChatter) {
  CellRun run = goodRun();
  for (std::size_t row = kRest; row < kRows; ++row) curve(run, "reaction").values[row] = row % 2 == 0 ? 1 : 3;
  EXPECT_CLASS(run, chattering);
  EXPECT_NEAR(classOf(run).frequency_Hz, 500, 1);
  curve(run, "hc").values.assign(kRows, 2);  // where there are laws they are judged
  EXPECT_CLASS(run, stable);
  EXPECT_EQ(classify(run, {.forces = {"reaction"}}).kind, StabilityClass::chattering);
  CellRun coupled = goodRun();
  for (std::size_t row = kRest; row < kRows; ++row)
    curve(coupled, "coupling of blade").values[row] = row % 4 < 2 ? 1 : 3;
  EXPECT_CLASS(coupled, chattering);
  EXPECT_NEAR(classOf(coupled).frequency_Hz, 250, 10);
}

TEST(StabilityClass, AToolThatIsThrownOffAndComesBackChatters) {
  const auto bounces = [](std::size_t every, std::size_t until) {
    CellRun run = goodRun();
    for (std::size_t row = kRest; row < kRows; ++row)
      curve(run, "reaction").values[row] = row < until && (row - kRest) % every == every - 1 ? 90 : 0;
    return run;
  };
  EXPECT_CLASS(bounces(20, kRows), chattering);  // four strikes
  EXPECT_NEAR(classOf(bounces(20, kRows)).frequency_Hz, 50, 1e-9);
  EXPECT_CLASS(bounces(30, kRows), stable);       // two
  EXPECT_CLASS(bounces(14, kRest + 50), stable);  // none in the last third
}

TEST(StabilityClass, ForcesOutOfRangeAndClampedOnes) {
  CellRun run = goodRun();
  curve(run, "reaction").values[70] = 1000;
  EXPECT_CLASS(run, stable);
  curve(run, "reaction").values[70] = 1001;
  EXPECT_CLASS(run, force_out_of_range);
  run = goodRun();
  set(run, "saturated_steps", 1LL);
  EXPECT_CLASS(run, force_out_of_range);
  run = goodRun();
  curve(run, "capped_count").values[80] = 1;
  EXPECT_CLASS(run, force_out_of_range);
}

TEST(StabilityClass, ARunInWhichNothingTouchesIsNotStable) {
  CellRun run = goodRun();
  set(run, "contact_steps", 0LL);
  EXPECT_CLASS(run, untouched);
  set(run, "contact_steps", kNan);
  EXPECT_CLASS(run, untouched);
  set(run, "contact_steps", 1LL);
  EXPECT_CLASS(run, stable);
}

TEST(StabilityClass, WhatIsWrongWithoutTheTool) {
  CellRun run = goodRun();
  run.curves.erase(run.curves.begin() + 1);  // without tools there is no depth
  EXPECT_EQ(problemAlone(run, {}), "");
  set(run, "unsound_steps", 3LL);
  set(run, "unsound_tissue", std::string("sphere: inside out"));
  EXPECT_EQ(problemAlone(run, {}), "sphere: inside out");
  run.status = {RunEnd::non_finite, "sphere at step 3"};
  EXPECT_EQ(problemAlone(run, {}), "sphere at step 3");
  run.status = {RunEnd::timeout, ""};
  EXPECT_EQ(problemAlone(run, {}), "timeout");
}

TEST(StabilityClass, EveryClassHasItsRowInTheTable) {
  EXPECT_EQ(stabilityClasses().size(), static_cast<std::size_t>(StabilityClass::stable) + 1);
  EXPECT_EQ(stabilityClasses()[static_cast<std::size_t>(StabilityClass::chattering)].name, "chattering");
}

}  // namespace
}  // namespace fissure
