#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <utility>

#include "scenario/load.h"

namespace fissure::bench {

void addStepCases();
void addContactCases();
void addCertificateCases();
void addRecordCases();
void addOutputCases();
void addCompareCases();
void addLawCases();
void addElasticCases();

/// Registers a benchmark in microseconds. `body` makes one batch of calls, from a state of its own, and gives
/// what one call took in seconds; it may add counters. Anything it throws becomes the benchmark's error, and
/// the others go on.
inline void addCase(const std::string& name, const std::function<double(benchmark::State&)>& body) {
  const auto guarded = [body](benchmark::State& state) {
    try {
      for (auto _ : state) state.SetIterationTime(body(state));
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), guarded)
      ->Unit(benchmark::kMicrosecond)
      ->UseManualTime()
      ->Iterations(1);
}

/// A scenario of configs/ by its name.
inline Scenario configuredScenario(const std::string& name, const std::vector<Override>& overrides = {}) {
  return loadScenario(FISSURE_SOURCE_DIR "/configs/" + name + ".yaml", overrides).scenario;
}

}  // namespace fissure::bench
