// What the proof of a step costs, beside the step that it proves: a whole run as configured.
#include "batch.h"
#include "cases.h"
#include "measure/certifier.h"
#include "run/run.h"

namespace fissure::bench {

namespace {

class TimedCertifier : public Probe {
 public:
  explicit TimedCertifier(const Scene& scene) : certifier_(scene) {}
  void declare(RecordLayout&) override {}
  void sample(const State& state, RecordRow&) override {
    std::optional<Objection> objection;
    proofs_.time([&] { objection = certifier_.certify(state); });
    if (!objection) ++certified_;
    if (state.step > 0) steps_us_.push_back(state.timing.step_us);
  }
  void summarize(Summary&) const override {}

  double report(benchmark::State& out) const {
    out.counters["step_us"] = median(steps_us_);
    out.counters["pairs"] = static_cast<double>(certifier_.pairsAsked()) / proofs_.size();
    out.counters["certified"] = certified_;
    return proofs_.median_s();
  }

 private:
  Certifier certifier_;
  Batch proofs_;
  double certified_ = 0;
  std::vector<double> steps_us_;
};

/// Keeps nothing.
class NoRecord : public RecordSink {
 public:
  void forceInputs(const State&) override {}
  void append(const RecordRow&) override {}
  void snapshot(const State&) override {}
  void frame(double, const Image&) override {}
  void finish(const RunStatus&, const Summary&) override {}
};

double measureProofs(benchmark::State& out, const Scenario& scenario, const PipelineSettings& pipeline) {
  Run run(scenario, pipeline, prepareScenario(scenario, pipeline.usesNodes()));
  std::vector<std::unique_ptr<Probe>> probes;
  probes.push_back(std::make_unique<TimedCertifier>(run.scene()));
  const RecordLayout layout = declareLayout(probes);
  NoRecord sink;
  run.execute(
      {.sink = sink, .probes = probes, .layout = layout, .make_frame_source = {}, .progress = nullptr});
  return dynamic_cast<const TimedCertifier&>(*probes.front()).report(out);
}

}  // namespace

void addCertificateCases() {
  for (const std::string name : {"spatula_press", "plate_press", "convex_spatula"}) {
    Scenario scenario = configuredScenario(name);
    scenario.record = {};
    for (const PipelineSettings& pipeline : scenario.pipelines)
      if (pipeline.name == "default_tuned" || pipeline.name == "fukuhara" || pipeline.name == "swept")
        addCase("certify/" + name + "/" + pipeline.name,
                [=](benchmark::State& out) { return measureProofs(out, scenario, pipeline); });
  }
}

}  // namespace fissure::bench
