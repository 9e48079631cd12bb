#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <string>

#include "scenario/load.h"

namespace fissure::bench {

void addStepCases();
void addContactCases();
void addOutputCases();

/// Registers a benchmark in microseconds. Anything it throws becomes its error, and the others go on.
inline benchmark::internal::Benchmark* addCase(const std::string& name,
                                               const std::function<void(benchmark::State&)>& body) {
  const auto guarded = [body](benchmark::State& state) {
    try {
      body(state);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), guarded)->Unit(benchmark::kMicrosecond);
}

/// Wall time of `work`, seconds.
template <class Work>
double secondsOf(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A scenario of configs/ by its name.
inline Scenario configuredScenario(const std::string& name, const std::vector<Override>& overrides = {}) {
  return loadScenario(FISSURE_SOURCE_DIR "/configs/" + name + ".yaml", overrides).scenario;
}

}  // namespace fissure::bench
