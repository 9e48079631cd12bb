// fissure-bench: what the stages of a run cost. Times are informative; the counters beside them are exact,
// the same in every run of one build, and tested (check_counters.py).
//
//   step/<scenario>/<pipeline>       a simulated step, Bullet and contact, without measuring and writing: the
//                                    median of 200 steps from just before first contact. Each iteration is
//                                    one such batch of a newly built simulation. collision_share: the median
//                                    time for tool against tissue over it (of Bullet's own contact only the
//                                    detection: its response is part of the solve)
//   detect/<triangles>/<nodes>       NodeContact::step alone: the spatula 8 mm deep in the sphere, restored
//                                    before each call; nodes on each large face
//   measure/<triangles>/<where>      PenetrationMeter::measure of one step: the spatula 5 mm above the sphere
//                                    (outside), pressed in with tissue held in front of it (touching), 8 mm
//                                    inside undeformed tissue (deep)
//   store/append                     one row of spatula_press into a part file
//   render/640x480                   one frame of spatula_press
//
// Google Benchmark adds how it timed: /iterations:N and /manual_time.
//   fissure-bench --benchmark_filter=^detect/512/ --benchmark_repetitions=5
// scripts/bench builds and runs all of it, and prints the ratios that matter.
#include "cases.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  fissure::bench::addStepCases();
  fissure::bench::addContactCases();
  fissure::bench::addOutputCases();
  return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 2;
}
