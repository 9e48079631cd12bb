// What only the volume of an elastic body says: how many substeps it needs, and that they are too many.
#include <gtest/gtest.h>

#include <string>

#include "check/run_plan.h"
#include "check/scenario_input.h"
#include "stepping/substep_plan.h"

namespace fissure::elastic_check_test {

namespace {

CheckedScenario checked(const std::string& elastic, const std::string& more = "") {
  const std::string text =
      "format: 1\nname: s\ntime: {duration_s: 1, step_s: 0.001}\nbodies:\n"
      "  - {name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 2}, model: elastic, elastic: {" +
      elastic + "}}\npipelines:\n  - {pipeline: swept}\n" + more;
  return checkLoaded("s.yaml", parseScenario(text, "s.yaml"), {});
}

SubstepPlan planOf(const CheckedScenario& scenario) {
  return planSubsteps(scenario.loaded.scenario.bodies[0], scenario.prepared.scene.bodies[0],
                      scenario.loaded.scenario.time.step_s);
}

TEST(ElasticCheck, SaysWhatAStepCosts) {
  const SubstepPlan soft = planOf(checked("youngs_modulus_Pa: 10000"));
  EXPECT_EQ(soft.tetrahedra, 512u);
  EXPECT_EQ(soft.substeps, 1);
  // Frequencies go with the root of the modulus.
  const SubstepPlan stiff = planOf(checked("youngs_modulus_Pa: 1.0e8"));
  EXPECT_NEAR(stiff.critical_step_s, soft.critical_step_s / 100, 1e-6 * soft.critical_step_s);
  EXPECT_GT(stiff.substeps, 10);
}

// 129 vertices, 128 triangles on 66 of them; the result holds the volume once, beside the snapshots.
TEST(ElasticCheck, CountsTheVolumeThatIsStoredBesideSnapshots) {
  const CheckedScenario with = checked("viscosity_Pa_s: 1", "record: {snapshots_every_s: 0.1}\n");
  const RunPlan plan = planRuns(with).at(0);
  const double snapshot_bytes = 8 + 33 * 66;
  ASSERT_EQ(plan.snapshots, 11);
  EXPECT_NEAR(plan.snapshot_bytes - 11 * snapshot_bytes, 129 * 32 + 512 * 5, 1);
  EXPECT_EQ(planRuns(checked("viscosity_Pa_s: 1")).at(0).snapshot_bytes, 0);
}

TEST(ElasticCheck, RefusesMoreSubstepsThanAreAffordable) {
  for (const char* elastic : {"viscosity_Pa_s: 1.0e9", "viscosity_Pa_s: 1.0e200",
                              "youngs_modulus_Pa: 1.0e300", "density_kg_m3: 1.0e-160, viscosity_Pa_s: 5"}) {
    try {
      checked(elastic);
      ADD_FAILURE() << "expected InputError: " << elastic;
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find('\n'), std::string::npos);
      EXPECT_NE(text.find("bodies.ball.elastic"), std::string::npos) << text;
      EXPECT_NE(text.find("substeps"), std::string::npos) << text;
    }
  }
}

TEST(ElasticCheck, NotesNumbersThatAreNotThoseOfThePreset) {
  EXPECT_TRUE(checked("preset: liver").notes.empty());
  const std::vector<std::string> notes = checked("preset: liver, youngs_modulus_Pa: 7000").notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("liver"), std::string::npos) << notes[0];
}

}  // namespace

}  // namespace fissure::elastic_check_test
