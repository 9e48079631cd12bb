// Ten thousand force laws over one step: as a family, and one by one.
#include <cmath>
#include <random>

#include "batch.h"
#include "cases.h"
#include "task/law_family.h"

namespace fissure::bench {

namespace {

constexpr int kTriangles = 60;  // about what a spatula meets at 512 triangles
constexpr int kLawCalls = 25;

/// 20 n x 25 lambda x 20 k: with these rates some triangles pull by most of the laws.
std::vector<ForceSettings> manyLaws() {
  std::vector<ForceSettings> laws;
  for (int n = 0; n < 20; ++n)
    for (int lambda = 0; lambda < 25; ++lambda)
      for (int k = 0; k < 20; ++k)
        laws.push_back(
            {.model = ForceModel::hunt_crossley,
             .coefficients = {
                 .k = 20.0 * std::pow(1.3, k), .lambda = 40.0 * std::pow(1.3, lambda), .n = 1 + 0.1 * n}});
  return laws;
}

/// Deformations up to 8 mm, rates up to 0.5 m/s of both signs.
std::vector<LawInput> oneStep() {
  std::mt19937_64 random(1);
  const auto between = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11) / 9007199254740992.0;
  };
  std::vector<LawInput> inputs;
  for (int i = 0; i < kTriangles; ++i) {
    const Vec3 direction(between(-1, 1), 1, between(-1, 1));
    inputs.push_back({between(0, 0.008), between(-0.5, 0.5), 1e-5, direction.normalized()});
  }
  return inputs;
}

/// The plain evaluation: each law triangle by triangle.
double plain(benchmark::State& state) {
  const std::vector<LawInput> inputs = oneStep();
  std::vector<ForceLaw> laws;
  for (const ForceSettings& law : manyLaws()) laws.emplace_back(law.model, law.coefficients);
  std::vector<double> forces_N(laws.size());
  Batch batch;
  for (int i = 0; i < kLawCalls; ++i) {
    batch.time([&] {
      for (std::size_t law = 0; law < laws.size(); ++law) {
        Vec3 sum_N = Vec3::Zero();
        for (const LawInput& input : inputs) {
          const LawForce force = laws[law].at(input.deformation_m, input.rate_m_s);
          sum_N += (force.elastic_N + force.viscous_N) * input.direction;
        }
        forces_N[law] = sum_N.norm();
      }
    });
    benchmark::DoNotOptimize(forces_N.data());
  }
  state.counters["laws"] = static_cast<double>(laws.size());
  return batch.median_s();
}

double family(benchmark::State& state) {
  const std::vector<LawInput> inputs = oneStep();
  LawFamily laws(manyLaws(), {{.model = ForceModel::hunt_crossley}});
  laws.evaluate(inputs);  // its arrays have their size from here on
  Batch batch;
  for (int i = 0; i < kLawCalls; ++i) batch.time([&] { laws.evaluate(inputs); });
  double clamped = 0;
  for (const int of_law : laws.valuesByPlace().adhesion_clamped) clamped += of_law;
  if (!(clamped > 0)) throw std::logic_error("no triangle pulls");
  state.counters["laws"] = static_cast<double>(laws.valuesByPlace().size());
  state.counters["adhesion_clamped"] = clamped;
  state.counters["allocations"] = batch.allocationCount() / batch.size();
  return batch.median_s();
}

}  // namespace

void addLawCases() {
  addCase("laws/family", family);
  addCase("laws/plain", plain);
}

}  // namespace fissure::bench
