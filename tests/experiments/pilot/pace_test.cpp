#include "pilot/pace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/scripted_motion.h"
#include "pilot/paced_motion.h"

namespace fissure::pace_test {

namespace {

TEST(Pace, GoesTheWholeWayInFewerSteps) {
  for (const std::int64_t steps : {1, 5, 36, 72, 73, 100, 559, 560, 5000, 123457}) {
    for (const int one_in : {2, 3, 10, 100}) {
      const Pace pace = paceOf(steps, one_in);
      SCOPED_TRACE(std::to_string(steps) + " steps, one in " + std::to_string(one_in));
      EXPECT_EQ(pace.run_steps.front(), 0);
      EXPECT_EQ(pace.stepsOfRun(), steps);
      for (std::size_t i = 1; i < pace.run_steps.size(); ++i)
        ASSERT_GT(pace.run_steps[i], pace.run_steps[i - 1]);
      for (const auto& window : pace.windows) {
        ASSERT_FALSE(window.empty());
        for (const std::int64_t step : window)
          EXPECT_EQ(pace.run_steps[static_cast<std::size_t>(step)],
                    pace.run_steps[static_cast<std::size_t>(step - 1)] + 1)
              << "at the run's own speed";
      }
      if (steps > 108) {
        EXPECT_LE(static_cast<double>(pace.steps()),
                  std::max(54.0, 1.1 * static_cast<double>(steps) / one_in));
      }
    }
  }
}

TEST(Pace, KnowsHowTheSpeedOfTheToolsChanges) {
  const Pace pace{{0, 5, 11, 12, 13, 17}, {{3, 4}}, {false, false, false, true, true, false}};
  EXPECT_EQ(pace.speedChangeAfter(0), 5);
  EXPECT_EQ(pace.speedChangeAfter(1), 1) << "one jump";
  EXPECT_DOUBLE_EQ(pace.speedChangeAfter(2), 1.0 / 6);
  EXPECT_EQ(pace.speedChangeAfter(3), 1);
  EXPECT_EQ(pace.speedChangeAfter(4), 4);
  EXPECT_EQ(pace.speedChangeAfter(5), 1) << "no step follows";
  for (const std::int64_t steps : {40, 318, 357, 395, 560}) {  // jumps of one and two steps among them
    const Pace whole = paceOf(steps, 2);
    std::size_t slower = 0;
    for (std::int64_t step = 0; step <= whole.steps(); ++step) slower += whole.speedChangeAfter(step) < 1;
    EXPECT_LE(slower, whole.windows.size()) << steps;
    if (steps == 40) {
      EXPECT_EQ(slower, 0u);
    }
  }
}

TEST(Pace, ARunOfFewStepsIsItsOwnPilot) {
  const Pace pace = paceOf(40, 10);
  EXPECT_EQ(pace.steps(), 40);
  std::vector<double> costs(41, 0.5);
  costs[7] = 3;
  EXPECT_DOUBLE_EQ(costOfRun(pace, costs), 22.5);
}

// Constant, linear and a wave of two periods: what lies between windows is linear.
TEST(Pace, CostsOfTheRunAreThoseOfItsWindows) {
  const Pace pace = paceOf(1000, 10);
  EXPECT_LE(pace.steps(), 100);
  const auto costs = [&](auto cost) {
    std::vector<double> all;
    for (const std::int64_t step : pace.run_steps) all.push_back(cost(static_cast<double>(step)));
    // Steps that jump cost what they like.
    for (std::size_t i = 1; i < all.size(); ++i)
      if (pace.run_steps[i] > pace.run_steps[i - 1] + 1) all[i] = 1e6;
    all[1] = all.back() = 0;
    return all;
  };
  EXPECT_NEAR(costOfRun(pace, costs([](double) { return 2.0; })), 1996, 1e-9);
  const auto rising = costs([](double step) { return step; });
  EXPECT_NEAR(costOfRun(pace, rising), 500500, 0.02 * 500500);
  EXPECT_NEAR(costOfRun(pace, rising, 2, 0), 500500, 0.2 * 500500);
  const auto wave = costs([](double step) { return 2 + std::sin(4 * std::numbers::pi * step / 1000); });
  EXPECT_NEAR(costOfRun(pace, wave), 2000, 100);
}

TEST(PacedMotion, ShowsTheSamePlacesEarlier) {
  ScriptMotion script;
  script.segments = {MotionSegment{.move_to_m = Vec3(0, 0.1, 0), .duration_s = 0.5},
                     MotionSegment{.hold_s = 0.1},
                     MotionSegment{.move_to_m = Vec3(0.2, 0.1, 0), .duration_s = 0.4}};
  const ScriptedMotion whole(script, "m");
  const Pace pace = paceOf(1000, 10);
  const PacedMotion paced(std::make_unique<ScriptedMotion>(script, "m"), pace, 0.001);
  EXPECT_NEAR(paced.duration_s(), 0.001 * static_cast<double>(pace.steps()), 1e-12);
  for (std::int64_t step = 0; step <= pace.steps(); ++step) {
    const double in_run_s = 0.001 * static_cast<double>(pace.run_steps[static_cast<std::size_t>(step)]);
    EXPECT_LT((paced.poseAt(0.001 * static_cast<double>(step)).position_m - whole.poseAt(in_run_s).position_m)
                  .norm(),
              1e-9)
        << step;
  }
  EXPECT_EQ(paced.poseAt(10).position_m, whole.poseAt(10).position_m);
  EXPECT_EQ(paced.poseAt(-1).position_m, whole.poseAt(-1).position_m);
}

}  // namespace
}  // namespace fissure::pace_test
