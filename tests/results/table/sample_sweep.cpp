#include "sample_sweep.h"

#include <limits>

#include "table/sweep_table_writer.h"
#include "text/scalars.h"

namespace fissure {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SweepTableLayout sampleSweep(std::size_t runs, std::size_t times) {
  SweepTableLayout layout;
  layout.title = "sample";
  layout.description = "Größen of a law.";
  layout.design = "grid";
  layout.axes = {{"k", "force.hc.k", true}, {"n", "force.hc.n", true}, {"shape", "tools.blade.shape", false}};
  layout.laws = {"hc", "linear"};
  layout.metrics = {{"max_penetration_depth_m"}, {"steps"}, {"timing/step_time_us"}};
  layout.curves = {{"depth", "m", "penetration depth", false}, {"force", "N", "force on the tools", true}};
  for (std::size_t i = 0; i < times; ++i) layout.curve_time_s.push_back(static_cast<double>(i) / 64);
  layout.runs = runs;
  layout.sweep_source = "# größer\nformat: 1\n";
  layout.provenance = {{"version", "0.1.0"}, {"command_line", "fissure sweep sample.yaml"}};
  return layout;
}

SweepRun sampleSweepRun(const SweepTableLayout& layout, std::size_t run) {
  const auto number = static_cast<double>(run);
  const std::size_t times = layout.curve_time_s.size();
  SweepRun made;
  made.point = static_cast<long long>(run / 2);
  made.pipeline = run % 2 == 0 ? "default" : "full";
  made.end = run % 7 == 3 ? RunEnd::non_finite : RunEnd::ok;
  made.detail = run % 7 == 3 ? "at step " + std::to_string(run) + ", \"late\"\nor not" : "";
  made.file = "runs/größe " + std::to_string(run) + ".h5";
  made.values = {formatReal(100 * (static_cast<double>(made.point % 5) + 1)),
                 formatReal(1 + static_cast<double>(made.point / 5) / 10), "[0.1, blade, \"a,b\"]"};
  made.metrics = {run == 1 ? missing : number / 1000, 3 * number, number / 8};
  for (std::size_t i = 0; i < times; ++i)
    made.curves.push_back(run % 3 == 2 && 2 * i >= times ? missing : number + static_cast<double>(i) / 128);
  for (int law = 0; law < 2; ++law)
    for (std::size_t i = 0; i < times; ++i)
      made.curves.push_back(1000 * law + number + static_cast<double>(i) / 128);
  return made;
}

void writeSampleSweep(const std::filesystem::path& path, const SweepTableLayout& layout, bool complete) {
  SweepTableWriter writer(path, layout);
  for (std::size_t run = 0; run < layout.runs; ++run) writer.append(sampleSweepRun(layout, run));
  writer.finish(complete);
}

}  // namespace fissure
