// The same bits from every instruction set of this machine, and what the environment may ask for.
#include "elastic/instruction_set.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <optional>

#include "tissue_probe.h"
#include "two_materials.h"

namespace fissure {

namespace {

/// FISSURE_INSTRUCTIONS for the length of a test.
class Instructions {
 public:
  explicit Instructions(const std::string& value) {
    if (const char* was = std::getenv("FISSURE_INSTRUCTIONS")) before_ = was;
    setenv("FISSURE_INSTRUCTIONS", value.c_str(), 1);
  }
  ~Instructions() {
    if (before_)
      setenv("FISSURE_INSTRUCTIONS", before_->c_str(), 1);
    else
      unsetenv("FISSURE_INSTRUCTIONS");
  }
  Instructions(const Instructions&) = delete;
  Instructions& operator=(const Instructions&) = delete;

 private:
  std::optional<std::string> before_;
};

/// All numbers that a violent run with contacts ends with, of a tissue whose upper half is `other`.
std::vector<double> outcome(const ElasticMaterial& material, const ElasticMaterial& other) {
  const BlockMesh block =
      makeBlock({.cells = {3, 4, 3}, .irregularity = 0.4});  // 180: the last group is half full
  const auto held = block.where([](const Vec3& p) { return p.z() == 0; });
  const ElementMaterials materials =
      twoMaterials(block.mesh, material, other, [](const Vec3& p) { return p.z() > 0.02; });
  ElasticTissue tissue(block.mesh, materials, held, block.surface_vertices, {0, 0, -9.81});
  Random random;
  for (std::size_t v = 0; v < block.mesh.vertices_m.size(); ++v)
    if (tissue.inverseMasses_1_kg()[v] > 0) tissue.velocities_m_s()[v] = 3 * random.vector();
  std::vector<Vec3> motion_m(static_cast<std::size_t>(block.surface_vertices), Vec3(0, 0, -1e-6));
  std::vector<double> numbers;
  for (int step = 0; step < 40; ++step) {
    const int substeps = tissue.substepsFor(1e-3);
    numbers.push_back(substeps);
    for (int i = 0; i < substeps; ++i) {
      tissue.advance(1e-3 / substeps);
      tissue.addMotion(motion_m, 1e-3 / substeps);
    }
    numbers.push_back(tissue.invertedElements());
    numbers.push_back(tissue.criticalStep_s());
  }
  for (const Vec3& position_m : tissue.positions_m())
    numbers.insert(numbers.end(), position_m.begin(), position_m.end());
  for (const Vec3& velocity_m_s : tissue.velocities_m_s())
    numbers.insert(numbers.end(), velocity_m_s.begin(), velocity_m_s.end());
  const ElasticEnergies e = tissue.energies();
  numbers.insert(numbers.end(), {e.kinetic_J, e.stored_J, e.gravity_J, e.viscous_loss_J,
                                 e.mass_damping_loss_J, e.contact_work_J});
  return numbers;
}

TEST(InstructionSets, GiveTheSameBits) {
  for (const MaterialModel model : kModels)
    for (const double ratio : {0.3, 0.49})
      for (const double damping : {0.0, 1.0})
        for (const double other_Pa : {1e4, 6e4}) {
          const ElasticMaterial material = {model, 1e4, ratio, 1000, damping, damping};
          ElasticMaterial other = material;
          other.youngs_modulus_Pa = other_Pa;
          std::vector<double> reference;
          for (const InstructionSet set : supportedInstructionSets()) {
            const Instructions instructions(nameOf(set));
            const std::vector<double> numbers = outcome(material, other);
            if (reference.empty()) reference = numbers;
            ASSERT_EQ(numbers.size(), reference.size());
            EXPECT_EQ(std::memcmp(numbers.data(), reference.data(), 8 * numbers.size()), 0)
                << nameOf(set) << " " << ratio << " " << other_Pa;
          }
        }
}

TEST(InstructionSets, BaselineIsTheFirstAndTheWidestIsChosen) {
  EXPECT_EQ(supportedInstructionSets().front(), InstructionSet::baseline);
  const Instructions instructions("baseline");
  EXPECT_EQ(chosenInstructionSet(), InstructionSet::baseline);
  unsetenv("FISSURE_INSTRUCTIONS");
  EXPECT_EQ(chosenInstructionSet(), supportedInstructionSets().back());
}

TEST(InstructionSets, UnknownOnesAreRefused) {
  for (const char* name : {"sse9", "", "AVX2"}) {
    const Instructions instructions(name);
    try {
      chosenInstructionSet();
      FAIL() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).find("FISSURE_INSTRUCTIONS is '" + std::string(name) + "'"), 0u);
    }
  }
}

}  // namespace

}  // namespace fissure
