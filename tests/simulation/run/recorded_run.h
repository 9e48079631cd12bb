#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "measure/probes.h"
#include "run/run.h"

namespace fissure {

/// What a run recorded and said, and where the tissue was at the end of each step.
struct Seen : RecordSink {
  std::vector<RecordRow> rows;
  std::map<std::string, SummaryValue> summary;
  RunStatus status;
  void forceInputs(const State&) override {}
  void append(const RecordRow& row) override { rows.push_back(row); }
  void snapshot(const State&) override {}
  void frame(double, const Image&) override {}
  void finish(const RunStatus& s, const Summary& values) override {
    status = s;
    for (const SummaryValue& value : values) summary[value.name] = value;
  }
  double number(const std::string& name) const { return std::get<double>(summary.at(name).value); }
};

struct StateProbe : Probe {
  std::vector<State> states;
  void declare(RecordLayout&) override {}
  void sample(const State& state, RecordRow&) override { states.push_back(state); }
  void summarize(Summary&) const override {}
};

inline MotionSegment moves(const Vec3& to_m, double duration_s) {
  MotionSegment segment;
  segment.move_to_m = to_m;
  segment.duration_s = duration_s;
  segment.timing = Timing::minimum_jerk;
  return segment;
}

inline MotionSegment holds(double hold_s) {
  MotionSegment segment;
  segment.hold_s = hold_s;
  return segment;
}

/// 30 mm in radius, 128 triangles, 100 g, about the origin.
inline BodySettings softSphere() {
  BodySettings body;
  body.name = "sphere";
  body.shape = SphereShape{.radius_m = 0.03, .subdivisions = 2};
  body.mass_kg = 0.1;
  body.material.linear_stiffness = 0.5;
  body.solver.pose_matching = 0.02;
  body.solver.damping = 0.01;
  body.solver.dynamic_friction = 0.5;
  body.solver.position_iterations = 10;
  return body;
}

/// A scenario, run through its first pipeline with every probe.
class RecordedRun : public testing::Test {
 protected:
  void execute() {
    fissure::Run run(scenario, scenario.pipelines[0],
                     prepareScenario(scenario, scenario.pipelines[0].usesNodes()));
    std::vector<std::unique_ptr<Probe>> probes = makeProbes(scenario, run.scene());
    auto states = std::make_unique<StateProbe>();
    StateProbe& kept = *states;
    probes.push_back(std::move(states));
    layout = declareLayout(probes);
    run.execute({.sink = seen, .probes = probes, .layout = layout, .make_frame_source = {}, .progress = {}});
    ASSERT_EQ(nameOf(seen.status.end), "ok") << seen.status.detail;
    states_ = kept.states;
  }

  Scenario scenario;
  Seen seen;
  RecordLayout layout;
  std::vector<State> states_;
};

}  // namespace fissure
