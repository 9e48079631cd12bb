// What a run pays for being written and drawn.
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "batch.h"
#include "cases.h"
#include "measure/probes.h"
#include "render/offscreen_renderer.h"
#include "run/run.h"
#include "scene/build_scene.h"
#include "store/part_file.h"

namespace fissure::bench {

namespace {

constexpr std::size_t kBlock = 4096;  ///< rows that a part file writes at once
constexpr std::size_t kBlocks = 5;
constexpr std::size_t kOutputRows = kBlock * kBlocks;

double append(benchmark::State& out) {
  const Scenario scenario = configuredScenario("spatula_press");
  const PipelineSettings& pipeline =
      *std::find_if(scenario.pipelines.begin(), scenario.pipelines.end(),
                    [](const PipelineSettings& entry) { return entry.pipeline == PipelineKind::fukuhara; });
  const Scene scene = buildScene(scenario, pipeline.usesNodes());
  auto probes = makeProbes(scenario, scene);
  const RecordLayout layout = declareLayout(probes);
  std::vector<RecordRow> table(1000, RecordRow(layout.columns()));  // values that no filter can squeeze away
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table[i].size(); ++j) {
      table[i][j] = std::round(1e9 * std::sin(static_cast<double>(i * i + j)));
    }
  }
  for (const Series& series : layout.series())
    for (std::size_t i = 0; series.type == ValueType::flag && i < table.size(); ++i)
      for (std::size_t c = 0; c < series.columns; ++c) table[i][series.first_column + c] = i % 2 == 0 ? 0 : 1;
  const auto part =
      std::filesystem::temp_directory_path() / ("fissure-bench-" + std::to_string(getpid()) + ".part");
  const auto sink = createPartFile(part, {.scenario = scenario,
                                          .pipeline = pipeline,
                                          .scene = scene,
                                          .layout = layout,
                                          .expected_steps = static_cast<std::int64_t>(kOutputRows) - 1,
                                          .flush_every_s = 1e9});  // blocks by their size alone
  Batch blocks;
  for (std::size_t row = 0; row < kOutputRows; row += kBlock) {
    blocks.time([&] {
      for (std::size_t i = row; i < row + kBlock; ++i) sink->append(table[i % table.size()]);
    });
  }
  sink->finish({}, {});
  out.counters["columns"] = static_cast<double>(layout.columns());
  out.counters["bytes"] = static_cast<double>(std::filesystem::file_size(part)) / kOutputRows;
  out.counters["allocations"] = blocks.allocationCount() / kOutputRows;
  std::filesystem::remove(part);
  return blocks.median_s() / kBlock;
}

double render(benchmark::State& out) {
  const Scenario scenario = configuredScenario("spatula_press");
  const Scene scene = buildScene(scenario, true);
  State first{.positions_m = scene.bodies[0].rest.vertices_m, .tools = {ToolState{}}};
  first.tools[0].pose.position_m = {0, 0.05, 0};  // in the sphere: the cut is drawn too
  const auto renderer = makeOffscreenRenderer(scene, *scenario.record.frames, first);
  const std::vector<std::string> text = {"fukuhara", "t = 0.160 s"};
  Image image = renderer->draw(first, text);  // Mesa compiles what the first frame needs
  Batch frames;
  for (int i = 0; i < 15; ++i) frames.time([&] { image = renderer->draw(first, text); });
  out.counters["bytes"] = static_cast<double>(image.rgb.size());
  out.counters["allocations"] = frames.allocationCount() / frames.size();
  return frames.median_s();
}

}  // namespace

void addOutputCases() {
  addCase("store/append", append);
  addCase("render/640x480", render);
}

}  // namespace fissure::bench
