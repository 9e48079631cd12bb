// A substep of elastic tissue: elements as lanes, and one element at a time.
#include <cstdlib>
#include <string>

#include "batch.h"
#include "block_mesh.h"
#include "cases.h"
#include "elastic/elastic_tissue.h"
#include "elastic/instruction_set.h"
#include "plain_elements.h"

namespace fissure::bench {

namespace {

constexpr ElasticMaterial kSoft = {MaterialModel::neo_hookean, 1e4, 0.4, 1000};
constexpr double kSubstep_s = 1e-5;

BlockMesh blockOf(const std::array<int, 3>& cells) {
  return makeBlock({.cells = cells, .split = CellSplit::six, .irregularity = 0.3});
}

/// The block's shape in motion, 10 % sheared and compressed.
template <class Positions>
void deform(Positions& positions_m) {
  for (Vec3& position_m : positions_m) position_m += Vec3(0.1 * position_m.z(), 0, -0.1 * position_m.z());
}

/// Median substep, seconds; its time per tetrahedron as a counter.
template <class Substep>
double timeOfSubstep(benchmark::State& state, std::size_t tetrahedra, const Substep& substep) {
  const int calls = static_cast<int>(4000000 / tetrahedra) / 50 + 20;
  Batch batch;
  for (int i = 0; i < calls; ++i) batch.time(substep);
  state.counters["tetrahedra"] = static_cast<double>(tetrahedra);
  state.counters["allocations"] = batch.allocationCount() / batch.size();
  state.counters["tetrahedron_us"] = 1e6 * batch.median_s() / static_cast<double>(tetrahedra);
  return batch.median_s();
}

double asLanes(benchmark::State& state, const std::array<int, 3>& cells, const ElasticMaterial& material,
               InstructionSet set) {
  const BlockMesh block = blockOf(cells);
  setenv("FISSURE_INSTRUCTIONS", nameOf(set).c_str(), 1);
  ElasticTissue tissue(block.mesh, material, {}, block.surface_vertices, Vec3::Zero());
  unsetenv("FISSURE_INSTRUCTIONS");
  auto positions_m = tissue.positions_m();
  deform(positions_m);
  return timeOfSubstep(state, block.mesh.tetrahedra.size(), [&] { tissue.advance(kSubstep_s); });
}

double oneByOne(benchmark::State& state, const std::array<int, 3>& cells) {
  const BlockMesh block = blockOf(cells);
  PlainElements elements(block.mesh, kSoft);
  deform(elements.positions_m);
  return timeOfSubstep(state, block.mesh.tetrahedra.size(), [&] { elements.advance(kSubstep_s); });
}

}  // namespace

void addElasticCases() {
  const InstructionSet widest = supportedInstructionSets().back();
  for (const std::array<int, 3>& cells :
       {std::array{4, 4, 5}, std::array{8, 8, 11}, std::array{16, 16, 21}}) {
    const std::string name = "elastic/" + std::to_string(6 * cells[0] * cells[1] * cells[2]) + "/";
    addCase(name + "plain", [=](benchmark::State& state) { return oneByOne(state, cells); });
    addCase(name + "baseline",
            [=](benchmark::State& state) { return asLanes(state, cells, kSoft, InstructionSet::baseline); });
    addCase(name + "widest", [=](benchmark::State& state) { return asLanes(state, cells, kSoft, widest); });
    for (const auto& [what, change] : std::initializer_list<std::pair<std::string, ElasticMaterial>>{
             {"corotated", {MaterialModel::linear_corotated, 1e4, 0.4, 1000}},
             {"kirchhoff", {MaterialModel::saint_venant_kirchhoff, 1e4, 0.4, 1000}},
             {"viscous", {MaterialModel::neo_hookean, 1e4, 0.4, 1000, 1}},
             {"averaged", {MaterialModel::neo_hookean, 1e4, 0.49, 1000}}}) {
      const ElasticMaterial material = change;
      addCase(name + "widest_" + what,
              [=](benchmark::State& state) { return asLanes(state, cells, material, widest); });
    }
  }
}

}  // namespace fissure::bench
