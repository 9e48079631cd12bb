// What a run pays a step for being measured, written and drawn: a whole run as configured, with a stop-watch
// on everything that it hands out.
#include <unistd.h>

#include <filesystem>

#include "batch.h"
#include "cases.h"
#include "measure/probes.h"
#include "render/offscreen_renderer.h"
#include "run/run.h"
#include "store/part_file.h"

namespace fissure::bench {

namespace {

/// All probes as one.
class TimedProbes : public Probe {
 public:
  TimedProbes(std::vector<std::unique_ptr<Probe>> probes, Batch& samples)
      : probes_(std::move(probes)), samples_(samples) {}
  void declare(RecordLayout& layout) override {
    for (const auto& probe : probes_) probe->declare(layout);
  }
  void sample(const State& state, RecordRow& row) override {
    samples_.time([&] {
      for (const auto& probe : probes_) probe->sample(state, row);
    });
  }
  void summarize(Summary& summary) const override {
    for (const auto& probe : probes_) probe->summarize(summary);
  }

 private:
  std::vector<std::unique_ptr<Probe>> probes_;
  Batch& samples_;
};

class TimedSink : public RecordSink {
 public:
  TimedSink(std::unique_ptr<RecordSink> sink, Batch& writes) : sink_(std::move(sink)), writes_(writes) {}
  void forceInputs(const State& state) override {
    writes_.time([&] { sink_->forceInputs(state); });
  }
  void append(const RecordRow& row) override {
    writes_.time([&] { sink_->append(row); });
  }
  void snapshot(const State& state) override {
    writes_.time([&] { sink_->snapshot(state); });
  }
  void frame(double time_s, const Image& image) override {
    writes_.time([&] { sink_->frame(time_s, image); });
  }
  void finish(const RunStatus& status, const Summary& summary) override {
    writes_.time([&] { sink_->finish(status, summary); });
  }

 private:
  std::unique_ptr<RecordSink> sink_;
  Batch& writes_;
};

class TimedFrames : public FrameSource {
 public:
  TimedFrames(std::unique_ptr<FrameSource> frames, Batch& draws)
      : frames_(std::move(frames)), draws_(draws) {}
  Image draw(const State& state, const std::vector<std::string>& text) override {
    Image image;
    draws_.time([&] { image = frames_->draw(state, text); });
    return image;
  }
  std::vector<std::pair<std::string, std::string>> versions() const override { return frames_->versions(); }

 private:
  std::unique_ptr<FrameSource> frames_;
  Batch& draws_;
};

double measureRecording(benchmark::State& out, const Scenario& scenario, const PipelineSettings& pipeline) {
  const auto part =
      std::filesystem::temp_directory_path() / ("fissure-bench-" + std::to_string(getpid()) + "-record.part");
  Run run(scenario, pipeline, prepareScenario(scenario, pipeline.usesNodes()));
  Batch samples, writes, draws;
  std::vector<std::unique_ptr<Probe>> probes;
  probes.push_back(std::make_unique<TimedProbes>(makeProbes(scenario, run.scene()), samples));
  const RecordLayout layout = declareLayout(probes);
  TimedSink sink(createPartFile(part, {.scenario = scenario,
                                       .pipeline = pipeline,
                                       .scene = run.scene(),
                                       .layout = layout,
                                       .expected_steps = run.stepCount(),
                                       .flush_every_s = 1e9}),
                 writes);
  const auto timed_frames = [&](const State& first) {
    return std::make_unique<TimedFrames>(makeOffscreenRenderer(run.scene(), *scenario.record.frames, first),
                                         draws);
  };
  run.execute({.sink = sink,
               .probes = probes,
               .layout = layout,
               .make_frame_source = timed_frames,
               .progress = nullptr});
  std::filesystem::remove(part);

  // Blocks are written, and frames drawn, in few of the steps: their mean.
  const double measure_s = samples.median_s();
  const double write_s = writes.mean_s() * writes.size() / samples.size();
  const double draw_s = draws.mean_s() * draws.size() / samples.size();
  out.counters["measure_us"] = 1e6 * measure_s;
  out.counters["write_us"] = 1e6 * write_s;
  out.counters["draw_us"] = 1e6 * draw_s;
  out.counters["allocations"] = (samples.allocationCount() + writes.allocationCount()) / samples.size();
  out.counters["frames"] = draws.size();
  return measure_s + write_s + draw_s;
}

}  // namespace

void addRecordCases() {
  for (const std::string name : {"spatula_press", "plate_press"}) {
    const Scenario scenario = configuredScenario(name);
    for (const PipelineSettings& pipeline : scenario.pipelines) {
      if (pipeline.name != "default_tuned" && pipeline.name != "fukuhara" && pipeline.name != "swept")
        continue;
      addCase("record/" + name + "/" + pipeline.name,
              [=](benchmark::State& out) { return measureRecording(out, scenario, pipeline); });
    }
  }
}

}  // namespace fissure::bench
