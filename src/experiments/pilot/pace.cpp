#include "pilot/pace.h"

#include <algorithm>
#include <numeric>

namespace fissure {

namespace {

constexpr std::int64_t window_steps = 12;  ///< at the run's own speed
constexpr std::int64_t dying_steps = 7;    ///< of these, not measured
constexpr std::int64_t fewest_windows = 3;
/// Two thirds of a pilot are windows.
constexpr std::int64_t fewest_steps = 3 * fewest_windows * window_steps / 2;

/// Steps of a run that is its own pilot: all, in windows that share them out.
Pace wholeRun(std::int64_t steps) {
  Pace pace;
  for (std::int64_t step = 0; step <= steps; ++step) pace.run_steps.push_back(step);
  for (std::int64_t first = 1; first <= steps; first += window_steps) {
    std::vector<std::int64_t>& window = pace.windows.emplace_back();
    for (std::int64_t step = first; step < std::min(first + window_steps, steps + 1); ++step)
      window.push_back(step);
  }
  pace.is_in_window.assign(pace.run_steps.size(), true);
  return pace;
}

/// Passes the steps of the run up to `to` in `jumps` steps as equal as can be.
void jump(Pace& pace, std::int64_t to, std::int64_t jumps) {
  const std::int64_t from = pace.run_steps.back();
  for (std::int64_t j = 1; j <= jumps; ++j) {
    const std::int64_t step = from + (to - from) * j / jumps;
    if (step <= pace.run_steps.back()) continue;
    pace.run_steps.push_back(step);
    pace.is_in_window.push_back(false);
  }
}

/// The middle of a window and the mean cost of its steps.
struct Sample {
  double at = 0, cost = 0;
};

}  // namespace

double Pace::speedChangeAfter(std::int64_t step) const {
  const auto i = static_cast<std::size_t>(step);
  if (i + 1 >= run_steps.size()) return 1;
  const bool was_in_window = i == 0 || is_in_window[i];
  if (was_in_window == is_in_window[i + 1]) return 1;
  return was_in_window ? static_cast<double>(run_steps[i + 1] - run_steps[i])
                       : 1 / static_cast<double>(run_steps[i] - run_steps[i - 1]);
}

Pace paceOf(std::int64_t steps, int one_in) {
  const std::int64_t wanted = std::max(steps / one_in, fewest_steps);
  if (steps <= 2 * fewest_steps) return wholeRun(steps);
  const std::int64_t windows = 2 * wanted / (3 * window_steps);
  const std::int64_t jumps = std::max<std::int64_t>(1, (wanted - windows * window_steps) / (windows + 1));
  Pace pace{{0}, {}, {false}};
  for (std::int64_t w = 0; w < windows; ++w) {
    const std::int64_t middle = steps * (2 * w + 1) / (2 * windows);
    jump(pace, middle - window_steps / 2, jumps);
    std::vector<std::int64_t>& window = pace.windows.emplace_back();
    for (std::int64_t step = 1; step <= window_steps; ++step) {
      pace.run_steps.push_back(pace.run_steps.back() + 1);
      pace.is_in_window.push_back(true);
      if (step > dying_steps) window.push_back(pace.steps());
    }
  }
  jump(pace, steps, jumps);
  return pace;
}

double costOfRun(const Pace& pace, const std::vector<double>& step_costs, std::size_t every,
                 std::size_t from) {
  if (pace.steps() == pace.stepsOfRun() && every == 1)
    return std::accumulate(step_costs.begin() + 1, step_costs.end(), 0.0);
  std::vector<Sample> samples;
  for (std::size_t w = from; w < pace.windows.size(); w += every) {
    Sample& sample = samples.emplace_back();
    const auto share = 1 / static_cast<double>(pace.windows[w].size());
    for (const std::int64_t step : pace.windows[w]) {
      sample.at += share * static_cast<double>(pace.run_steps[static_cast<std::size_t>(step)]);
      sample.cost += share * step_costs[static_cast<std::size_t>(step)];
    }
  }
  const auto end = static_cast<double>(pace.stepsOfRun());
  double cost = samples.front().at * samples.front().cost + (end - samples.back().at) * samples.back().cost;
  for (std::size_t s = 1; s < samples.size(); ++s)
    cost += (samples[s].at - samples[s - 1].at) * (samples[s].cost + samples[s - 1].cost) / 2;
  return cost * (end - 2) / end + step_costs[1] + step_costs.back();
}

}  // namespace fissure
