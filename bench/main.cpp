// fissure-bench: what the stages of a run cost. A benchmark makes one batch of calls: from a state of its
// own, or one restored before each call, so that every batch meets the same contacts. Its time is the median
// call.
//
//   step/<scenario>/<pipeline>       a simulated step, Bullet and contact, without measuring and writing: 200
//                                    of them from just before first contact, in a new simulation
//   detect/<triangles>/<nodes>       NodeContact::step alone, as fukuhara has it by default: the spatula 8 mm
//                                    deep in the sphere, restored before each call; nodes on each large face
//   detect/<triangles>/swept         SweptContact::step alone, in the same place
//   measure/<triangles>/<where>      PenetrationMeter::measure of one step: the spatula 5 mm above the sphere
//                                    (outside), pressed in with tissue held in front of it (touching), 8 mm
//                                    inside undeformed tissue (deep)
//   certify/<scenario>/<pipeline>    Certifier::certify of each step of a run as configured; step_us: the
//   step
//                                    itself
//   record/<scenario>/<pipeline>     what a run as configured pays a step for being measured (median),
//                                    written and drawn (means)
//   store/append                     one row of spatula_press into a part file: the median of blocks
//   render/640x480                   one frame of spatula_press
//   compare/difference, shift        1,000 rows of 66 vertices against others; over 20 rows each way
//   laws/family, plain               10,000 force laws (20 n x 25 lambda x 20 k) over one step of 60
//   triangles:
//                                    LawFamily::evaluate, and each law triangle by triangle
//   elastic/<tetrahedra>/<how>       a substep of neo-Hookean tissue at a Poisson's ratio of 0.4: one element
//   at
//                                    a time (plain), as lanes of the baseline and of the widest instruction
//                                    set of the machine; of the widest also with the corotated law, with
//                                    viscosity, and at 0.49, where pressures are averaged
//
// Counters are of one call, step or row (record: frames are of the whole run). Those whose names end in _us
// are times: of each stage of a step (Simulation::stageTimes), medians. All others are exact, the same in
// every run of one build, and tested (check_counters.py); allocations are calls of operator new in what is
// timed.
//
// A repetition is a batch:
//   fissure-bench --benchmark_filter=^detect/512/ --benchmark_repetitions=9
// scripts/bench builds and runs all of it, and prints the ratios that matter; scripts/bench-compare compares
// two commits.
#include "cases.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  fissure::bench::addStepCases();
  fissure::bench::addContactCases();
  fissure::bench::addCertificateCases();
  fissure::bench::addRecordCases();
  fissure::bench::addOutputCases();
  fissure::bench::addCompareCases();
  fissure::bench::addLawCases();
  fissure::bench::addElasticCases();
  return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 2;
}
