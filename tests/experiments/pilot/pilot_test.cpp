#include "pilot/pilot.h"

#include <gtest/gtest.h>

#include <ctime>

#include "base/error.h"
#include "scenario/load.h"

namespace fissure::pilot_test {

namespace {

const char* const press =
    "format: 1\nname: press\ndescription: A plate on a ball.\n"
    "time: {step_s: 0.001, settle_s: 0.02}\nbodies:\n"
    "  - name: ball\n    shape: {type: sphere, radius_m: 0.03, subdivisions: 1}\n    mass_kg: 0.1\n"
    "tools:\n"
    "  - name: plate\n    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
    "    motion:\n      type: script\n      start_m: [0, 0.06, 0]\n"
    "      segments: [{move_to_m: [0, 0.04, 0], duration_s: 0.6}, {hold_s: 0.4}]\n"
    "pipelines: [{pipeline: default}]\n"
    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.5}}\n";

/// Counts what it is handed.
class Counting : public RecordSink {
 public:
  void forceInputs(const State&) override {}
  void append(const RecordRow&) override { ++rows; }
  void snapshot(const State&) override { ++snapshots; }
  void frame(double, const Image&) override { ++frames; }
  void finish(const RunStatus&, const Summary&) override { finished = true; }

  int rows = 0, snapshots = 0, frames = 0;
  bool finished = false;
};

TEST(Pilot, ThinsTheScenarioAndKeepsTheWay) {
  Scenario scenario = parseScenario(press, "press.yaml").scenario;
  PreparedScenario prepared = prepareScenario(scenario, false);
  const Pose first = prepared.motions[0]->poseAt(0), last = prepared.motions[0]->poseAt(1);
  const Pilot pilot(scenario, prepared, 10);
  EXPECT_LE(*scenario.time.duration_s, 0.1 + 1e-12);
  EXPECT_GE(*scenario.time.duration_s, 0.08);
  EXPECT_DOUBLE_EQ(scenario.time.step_s, 0.001);
  EXPECT_DOUBLE_EQ(scenario.time.settle_s, 0.02);
  EXPECT_EQ(prepared.motions[0]->poseAt(0).position_m, first.position_m);
  EXPECT_EQ(prepared.motions[0]->poseAt(*scenario.time.duration_s).position_m, last.position_m);
  EXPECT_NEAR(prepared.longestMotion_s(), *scenario.time.duration_s, 1e-12);
  EXPECT_GE(*scenario.record.snapshots_every_s, 0.02) << "fewer than in the run, at their cost";
  EXPECT_LE(scenario.record.frames->every_s, *scenario.time.duration_s) << "some all the same";
}

TEST(Pilot, ForetellsWhatItsStepsCost) {
  Scenario scenario = parseScenario(press, "press.yaml").scenario;
  PreparedScenario prepared = prepareScenario(scenario, false);
  Pilot pilot(scenario, prepared, 10);
  Counting counting;
  RecordSink& sink = pilot.watched(counting);
  const int steps = static_cast<int>(*scenario.time.duration_s / scenario.time.step_s + 0.5);
  // Settling steps, then steps of a tenth of a millisecond or more, by what the processor does.
  double busy = 0;
  const auto work = [&] {
    for (int i = 0; i < 100000; ++i) busy += 1 / (1 + busy);
  };
  const auto processor_s = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  int slower = 0, faster = 0;
  const double before_s = processor_s();
  pilot.begin();
  for (int step = 1; step <= 20 + steps; ++step) {
    work();
    sink.append({});
    if (step % 10 == 0) sink.snapshot({});
    const double speed_change = pilot.stepped();
    if (step < 20) {
      EXPECT_EQ(speed_change, 1) << "tools rest while tissue settles";
    }
    if (speed_change < 1) ++slower;
    if (speed_change > 1) ++faster;
  }
  EXPECT_EQ(slower, 5) << "one a window";
  EXPECT_EQ(faster, 6) << "the first before any step";
  sink.finish({}, {});
  EXPECT_EQ(counting.rows, 20 + steps);
  EXPECT_TRUE(counting.finished);
  const double took_s = processor_s() - before_s;
  const Forecast forecast = pilot.forecast();
  EXPECT_EQ(forecast.pilot_steps, steps);
  EXPECT_EQ(forecast.run_steps, 1000);
  EXPECT_LE(forecast.low_s, forecast.run_s);
  EXPECT_GE(forecast.high_s, forecast.run_s);
  // 1,020 steps instead of 20 + steps; and what this process had done before, which is no part of a worker.
  EXPECT_GT(forecast.run_s, 4 * took_s);
  EXPECT_LT(forecast.run_s, 20 * took_s + before_s);
}

TEST(Forecast, SurvivesItsFile) {
  const Forecast forecast{56, 560, 12.5, 11.75, 1e-9 + 13};
  const Forecast read = parseForecast(forecastText(forecast));
  EXPECT_EQ(read.pilot_steps, 56);
  EXPECT_EQ(read.run_steps, 560);
  EXPECT_EQ(read.run_s, forecast.run_s);
  EXPECT_EQ(read.low_s, forecast.low_s);
  EXPECT_EQ(read.high_s, forecast.high_s);
  EXPECT_THROW(parseForecast("56 560 1.25"), RunError);
}

}  // namespace
}  // namespace fissure::pilot_test
