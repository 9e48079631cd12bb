#include <limits>

#include "measure/probes_fixture.h"
#include "mesh/primitives.h"
#include "scenario/tissues.h"

namespace fissure::probes_test {

namespace {

class ForceProbeTest : public ProbesTest {};

// Force magnitudes 1, 2, 1, 2, 1, 2: second differences are all 2, the mean square is 2.5.
TEST_F(ForceProbeTest, ForceOfEachLaw) {
  addLaws({"hc", "linear"});
  start();
  for (int i = 0; i < 6; ++i) {
    state_.forces[0] = {Vec3(0, i % 2 == 0 ? 1.0 : -2.0, 0), 7.0, -0.5, 3};
    state_.forces[1] = {Vec3(0, 0, 4.0), 1.0, 0.0, 0};
    step();
  }
  EXPECT_EQ(value("force", 1), -2);
  EXPECT_EQ(value("force", 5), 4);
  EXPECT_EQ(value("force_elastic", 0), 7);
  EXPECT_EQ(value("force_viscous", 0), -0.5);
  EXPECT_EQ(value("adhesion_clamped", 0), 3);
  EXPECT_EQ(real("max_force_N"), 2);
  EXPECT_EQ(real("max_force_hc_N"), 2);
  EXPECT_EQ(real("max_force_linear_N"), 4);
  EXPECT_DOUBLE_EQ(real("force_roughness"), 2 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(real("force_roughness_hc"), 2 / std::sqrt(2.5));
  EXPECT_EQ(real("force_roughness_linear"), 0);  // constant
  EXPECT_EQ(real("roughness_same_triangles_hc"), 0) << "no triangle is there";
}

// Components whose magnitude is beyond what a double holds, and terms that are no number.
TEST_F(ForceProbeTest, TheFirstStepWithAForceThatIsNotFiniteIsNamedByLaw) {
  addLaws({"hc", "linear", "kv"});
  start();
  for (int i = 0; i < 5; ++i) {
    state_.forces[0].force_on_tool_N.y() = i < 3 ? 1e100 : 1e200;
    state_.forces[1].viscous_N = i == 1 ? kNaN : 0;
    step();
  }
  EXPECT_EQ(count("force_non_finite_at_step_hc"), 3);
  EXPECT_EQ(count("force_non_finite_at_step_linear"), 1) << "the first, though later ones are finite";
  EXPECT_EQ(scalar("force_non_finite_at_step_kv").name, "absent");
  EXPECT_EQ(real("max_force_hc_N"), std::numeric_limits<double>::infinity());
}

TEST_F(ForceProbeTest, DeformationStatisticsOfEachLaw) {
  addLaws({"hc", "linear"});
  start();
  state_.colliding_triangles.resize(17);
  state_.triangle_forces_N.resize(34);
  state_.forces[1] = {.deformation_max_m = 0.5,
                      .deformation_mean_m = 0.25,
                      .rate_max_m_s = 3,
                      .rate_min_m_s = -4,
                      .rate_mean_m_s = -1};
  step();
  EXPECT_EQ(value("colliding_triangles"), 17);
  EXPECT_EQ(value("deformation_max", 0), 0);
  EXPECT_EQ(value("deformation_max", 1), 0.5);
  EXPECT_EQ(value("deformation_mean", 1), 0.25);
  EXPECT_EQ(value("deformation_rate_max", 1), 3);
  EXPECT_EQ(value("deformation_rate_min", 1), -4);
  EXPECT_EQ(value("deformation_rate_mean", 1), -1);
}

// Its own k is the scenario's business; an exponent of its own leaves the size of a whole probe.
TEST_F(ForceProbeTest, LawsOfWholeProbesAreNamed) {
  addLaws({"linear", "liver", "own"});
  for (std::size_t law : {1u, 2u}) {
    scenario_.force[law].model = ForceModel::hunt_crossley;
    scenario_.force[law].tissue = "pig_liver_1";
    applyTissue(scenario_.force[law]);
  }
  scenario_.force[2].coefficients.k = 3;
  start();
  EXPECT_EQ(std::get<std::string>(scalar("laws_of_whole_probes").value), "liver (pig_liver_1)");
}

TEST_F(ForceProbeTest, LawsOfNoProbeAreNotNamed) {
  addLaws({"hc"});
  start();
  EXPECT_EQ(scalar("laws_of_whole_probes").name, "absent");
}

// Two tools, the second with a limit of 8 N: 8 N is within it, a little more is not, and neither is NaN. The
// first has no limit.
TEST_F(ForceProbeTest, SaturationIsAFlagAgainstTheDevicesLimitAndLeavesTheForce) {
  scene_ = test::makeScene({makeBox({0.1, 0.1, 0.1})}, {{0.04, 0.002, 0.015}, {0.04, 0.002, 0.015}});
  scene_.tools[0].name = "free";
  state_ = test::restState(scene_, {test::at(0, 0.2, 0), test::at(0, 0.2, 0)});
  limitForce(8);
  scenario_.tools[0].name = scene_.tools[1].name = "held";
  addLaws({"hc", "linear"});
  start();
  EXPECT_EQ(layout_.find("saturated")->type, ValueType::flag);
  EXPECT_EQ(layout_.find("saturated")->axes, (Names{"law", "tool"}));
  const double forces_N[] = {8, 8.0000001, 100, 0, kNaN};
  const double expected[] = {0, 1, 1, 0, 1};
  for (int i = 0; i < 5; ++i) {
    state_.tool_forces_N = {Vec3(0, 1000, 0), Vec3(0, 0, -forces_N[i]), Vec3::Zero(), Vec3(0, 7, 0)};
    step();
    EXPECT_EQ(value("saturated", 0), 0) << "no device";
    EXPECT_EQ(value("saturated", 1), expected[i]) << forces_N[i];
    EXPECT_EQ(value("saturated", 3), 0) << "the second law stays within";
    EXPECT_EQ(value("tool_force", 1), 1000);
    EXPECT_TRUE(value("tool_force", 5) == -forces_N[i] || i == 4) << "unclamped";
    EXPECT_EQ(value("tool_force", 10), 7);
  }
  EXPECT_EQ(count("saturated_steps"), 3);
  EXPECT_EQ(count("saturated_steps_hc"), 3);
  EXPECT_EQ(count("saturated_steps_linear"), 0);
}

TEST_F(ForceProbeTest, ForcesWithoutToolsGoToNone) {
  scene_.tools.clear();
  state_.tools.clear();
  addLaws({"hc"});
  start();
  EXPECT_EQ(layout_.find("tool_force"), nullptr);
  EXPECT_NE(layout_.find("force"), nullptr);
  step();
  EXPECT_EQ(value("force"), 0);
}

}  // namespace

}  // namespace fissure::probes_test
