// What a run pays for being written and drawn.
#include <unistd.h>

#include <cmath>

#include "cases.h"
#include "measure/probes.h"
#include "render/offscreen_renderer.h"
#include "run/build_scene.h"
#include "run/run.h"
#include "store/part_file.h"

namespace fissure::bench {

namespace {

constexpr std::size_t kRows = 20'000;

void append(benchmark::State& state) {
  const Scenario scenario = configuredScenario("spatula_press");
  const PipelineSettings& pipeline = scenario.pipelines.back();
  const Scene scene = buildScene(scenario, pipeline.usesNodes());
  auto probes = makeProbes(scenario, scene);
  const RecordLayout layout = Run::declareLayout(probes);
  std::vector<RecordRow> table(1000, RecordRow(layout.columns()));  // values that no filter can squeeze away
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table[i].size(); ++j) {
      table[i][j] = std::round(1e9 * std::sin(static_cast<double>(i * i + j)));
    }
  }
  const auto part =
      std::filesystem::temp_directory_path() / ("fissure-bench-" + std::to_string(getpid()) + ".part");
  const auto sink = createPartFile(part, {.scenario = scenario,
                                          .pipeline = pipeline,
                                          .scene = scene,
                                          .layout = layout,
                                          .expected_rows = kRows,
                                          .flush_every_s = 1e9});  // blocks by their size alone
  std::size_t row = 0;
  for (auto _ : state) sink->append(table[row++ % table.size()]);
  sink->finish({}, {});
  state.counters["columns"] = static_cast<double>(layout.columns());
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(part)) / kRows;
  std::filesystem::remove(part);
}

void render(benchmark::State& state) {
  const Scenario scenario = configuredScenario("spatula_press");
  const Scene scene = buildScene(scenario, true);
  State first{.positions_m = scene.bodies[0].rest.vertices_m, .tools = {ToolState{}}};
  first.tools[0].pose.position_m = {0, 0.05, 0};  // in the sphere: the cut is drawn too
  const auto renderer = makeOffscreenRenderer(scene, *scenario.record.frames, first);
  Image image;
  for (auto _ : state) image = renderer->draw(first, {"fukuhara", "t = 0.160 s"});
  state.counters["bytes"] = static_cast<double>(image.rgb.size());
}

}  // namespace

void addOutputCases() {
  addCase("store/append", append)->Iterations(kRows);
  addCase("render/640x480", render);
}

}  // namespace fissure::bench
