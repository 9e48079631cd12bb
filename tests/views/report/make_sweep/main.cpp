// Writes a made-up sweep's table for looking at its page: make_sweep FILE grid|sobol|line|failed|lost RUNS;
// a line has one axis, one pipeline and no curves; failed and lost are grids whose runs have all failed, at
// once or after all of their curves
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>

#include "table/sweep_table_writer.h"
#include "text/scalars.h"

namespace {

using namespace fissure;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t times = 120;
const std::array<const char*, 3> pipelines = {"default_tuned", "raycast", "fukuhara"};

/// Even in 0..1, the same everywhere; looks random.
double share(std::size_t run, std::size_t what) {
  std::uint64_t bits = (run * 8 + what + 1) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 29)) * 0xbf58476d1ce4e5b9u;
  return static_cast<double>((bits ^ (bits >> 32)) >> 11) * 0x1p-53;
}

struct Point {
  double k, n, speed_m_s, thickness_m;
};

Point pointOf(std::size_t point, bool grid) {
  if (!grid)
    return {100 * std::pow(100, share(point, 0)), 1 + share(point, 1), 0.02 * std::pow(50, share(point, 2)),
            0.001 + 0.003 * share(point, 3)};
  const std::array<double, 3> thickness_m = {0.001, 0.002, 0.004};
  return {100 * std::pow(10, static_cast<double>(point % 9) / 4),
          1 + 0.2 * static_cast<double>(point / 9 % 6),
          0.02 * std::pow(50, static_cast<double>(point / 54 % 7) / 6), thickness_m[point / 378 % 3]};
}

SweepTableLayout layoutOf(bool grid, std::size_t runs) {
  SweepTableLayout layout;
  layout.title = "spatula_law";
  layout.description =
      "A spatula pressed into a soft sphere: </script><b>which</b> pipeline holds, over law and speed.";
  layout.design = grid ? "grid" : "sobol";
  layout.axes = {{"k", "force.hc.k"},
                 {"n", "force.hc.n"},
                 {"speed_m_s", "tools.spatula.motion.speed_m_s"},
                 {"thickness_m", "tools.spatula.shape.thickness_m"},
                 {"rate", "force.hc.rate", false},
                 {"segments_0", "tools.spatula.motion.segments.0", false}};
  layout.laws = {"hc", "linear"};
  layout.metrics = {
      {"max_penetration_depth_m"}, {"max_force_N"},          {"max_force_hc_N"}, {"force_roughness"},
      {"passed_through_samples"},  {"first_contact_time_s"}, {"misfit_N"},       {"steps"},
      {"node_switch_rate_hz"},     {"timing/mean_step_us"}};
  layout.curves = {{"penetration_depth", "m", "penetration depth"},
                   {"force", "N", "size of the total force on the tools", true}};
  for (std::size_t i = 0; i < times; ++i) {
    layout.curve_time_s.push_back(0.005 * static_cast<double>(i));
    layout.measured_N.push_back(2.5 * std::pow(std::min(1.0, 0.012 * static_cast<double>(i)), 1.5));
  }
  layout.runs = runs;
  layout.sweep_source = "format: 1\nname: spatula_law\nbase: spatula_press.yaml\n";
  layout.provenance = {{"version", "0.1.0"}, {"command_line", "fissure sweep spatula_law.yaml -o law"}};
  return layout;
}

/// Slow and thick holds; the default lets fast blades through and has no nodes; ray casting alone loses stiff
/// ones; node pairs now and then crash with velocities.
SweepRun runOf(const SweepTableLayout& layout, std::size_t number, bool grid) {
  SweepRun run;
  const std::size_t pipeline = number % 3;
  run.point = static_cast<long long>(number / 3);
  const Point at = pointOf(number / 3, grid);
  run.pipeline = pipelines[pipeline];
  run.values = {formatReal(at.k),
                formatReal(at.n),
                formatReal(at.speed_m_s),
                formatReal(at.thickness_m),
                number / 3 % 2 == 0 ? "differences" : "velocities",
                "{move_to_m: [0, 0.052, 0], hold_s: " + std::to_string(number / 3 % 4) + ", at the end}"};
  const double depth_m = (pipeline == 0   ? 0.02
                          : pipeline == 1 ? 0.002
                                          : 0.0004) *
                         (0.1 + at.speed_m_s / (1 + 400 * at.thickness_m)) * (1 + 0.2 * share(number, 5));
  const double force_N = at.k * std::pow(0.02, at.n) * (1 + at.speed_m_s);
  const bool lost = pipeline == 1 && at.k > 4000 && at.speed_m_s > 0.2;
  const bool hung = pipeline == 0 && number % 97 == 5;
  const bool crashed = pipeline == 2 && number / 3 % 2 == 1 && number % 5 == 2;
  const bool not_run = number % 211 == 7;
  run.end = not_run   ? RunEnd::missing
            : lost    ? RunEnd::non_finite
            : hung    ? RunEnd::timeout
            : crashed ? RunEnd::crashed
                      : RunEnd::ok;
  if (lost && !not_run) run.detail = "at step " + std::to_string(100 + number % 300) + ", t = 0.2 s";
  if (hung && !not_run) run.detail = "after 60 s at step " + std::to_string(number);
  if (crashed && !not_run) run.detail = "killed by signal 11 at step " + std::to_string(number);
  const bool none = not_run || hung || crashed;
  double misfit_N = 0;
  for (std::size_t i = 0; i < times; ++i) {
    const double ramp = std::min(1.0, 0.012 * static_cast<double>(i));
    run.curves.push_back(none || (lost && i > 40) ? missing : depth_m * ramp);
    misfit_N += std::abs(force_N * std::pow(ramp, at.n) - layout.measured_N[i]) / static_cast<double>(times);
  }
  for (int law = 0; law < 2; ++law)
    for (std::size_t i = 0; i < times; ++i) {
      const double ramp = std::min(1.0, 0.012 * static_cast<double>(i));
      const double noise = 1 + 0.05 * std::sin(static_cast<double>(i * (number + 3)));
      run.curves.push_back(none || (lost && i > 40) ? missing
                           : law == 0               ? force_N * std::pow(ramp, at.n) * noise
                                                    : 1.7 * ramp);
    }
  run.metrics = {depth_m,
                 force_N,
                 force_N * 0.99,
                 0.1 + share(number, 7),
                 pipeline == 0 && depth_m > 0.004 ? 12. : 0.,
                 0.08,
                 misfit_N,
                 lost ? 200. : 600.,
                 pipeline == 0 ? missing : 8 + share(number, 6),
                 90 + 20 * share(number, 9)};
  if (none) std::fill(run.metrics.begin(), run.metrics.end(), missing);
  return run;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::cerr << "usage: make_sweep FILE grid|sobol|line|failed|lost RUNS\n";
    return 2;
  }
  const bool failed = std::string(words[2]) == "failed";
  const bool lost = std::string(words[2]) == "lost";
  const bool grid = failed || lost || std::string(words[2]) == "grid";
  const SweepTableLayout layout = layoutOf(grid, static_cast<std::size_t>(std::atoi(words[3])));
  SweepTableLayout written = layout;
  const bool line = std::string(words[2]) == "line";
  if (line) {
    written.axes.resize(1);
    written.curve_time_s.clear();
    written.metrics.resize(1);
  }
  SweepTableWriter writer(words[1], written);
  for (std::size_t run = 0; run < layout.runs; ++run) {
    SweepRun row = runOf(layout, line ? 3 * run : run, grid);
    if (failed || lost) row.end = RunEnd::failed;
    if (failed) {
      row.detail = "before its first step";
      std::fill(row.metrics.begin(), row.metrics.end(), missing);
      std::fill(row.curves.begin(), row.curves.end(), missing);
    }
    if (line) {
      row.values.resize(1);
      row.metrics.resize(1);
      row.curves.clear();
    }
    writer.append(row);
  }
  writer.finish(false);
}
