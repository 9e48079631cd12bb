#include "measure/probes.h"

#include <cmath>

#include "measure/final_state_probe.h"
#include "measure/probes_fixture.h"

namespace fissure::probes_test {

namespace {

TEST_F(ProbesTest, DeclareOnlyWhatTheSceneNeeds) {
  start();
  EXPECT_EQ(seriesNames(), (Names{"penetration_depth", "inversion_aware_depth", "passed_through",
                                  "inverted_triangles", "stand_off", "tool_position", "tool_quaternion",
                                  "contact_count", "reaction_force", "kinetic_energy", "momentum", "volume",
                                  "timing/step_time_us", "timing/collision_time_us"}));
  EXPECT_EQ(scalar("node_switch_rate_hz").name, "absent");
  EXPECT_EQ(scalar("max_force_N").name, "absent");
}

// Two vertices of the second body, by numbers made up; what counts is the way since the first sample.
TEST_F(ProbesTest, AGaugeIsTheMeanWayOfItsVerticesSinceTimeZero) {
  scene_ = test::makeScene({makeBox({0.1, 0.1, 0.1}), makeBox({0.2, 0.2, 0.2})}, {});
  scene_.bodies[0].gauges = {{"one", {3}}};
  scene_.bodies[1].gauges = {{"two", {0, 7}}};
  state_ = test::restState(scene_, {});
  for (Vec3& position_m : state_.positions_m) position_m += Vec3(1, 2, 3);  // settled somewhere else
  start();
  EXPECT_EQ(layout_.axis("gauge").labels, (Names{"one", "two"}));
  EXPECT_TRUE(std::isnan(real("gauge_one_x_max_m"))) << "never sampled";
  step();
  EXPECT_EQ(value("gauge_displacement", 3), 0);
  state_.positions_m[8 + 0] += Vec3(0.2, 0, 0);
  state_.positions_m[8 + 7] += Vec3(0.4, -0.1, 0);
  state_.positions_m[8 + 5] += Vec3(9, 9, 9);
  step();
  EXPECT_EQ(value("gauge_displacement", 0), 0);
  EXPECT_NEAR(value("gauge_displacement", 3), 0.3, 1e-15);
  EXPECT_NEAR(value("gauge_displacement", 4), -0.05, 1e-15);
  state_.positions_m[8 + 0] -= Vec3(1.2, 0, 0);
  step();
  EXPECT_NEAR(real("gauge_two_x_max_m"), 0.3, 1e-15);
  EXPECT_NEAR(real("gauge_two_x_min_m"), -0.3, 1e-15);
  EXPECT_NEAR(real("gauge_two_x_final_m"), -0.3, 1e-15);
  EXPECT_NEAR(real("gauge_two_y_min_m"), -0.05, 1e-15);
  EXPECT_EQ(real("gauge_two_y_max_m"), 0);
  EXPECT_EQ(real("gauge_one_z_min_m"), 0);
  state_.positions_m[3].x() = kNaN;
  step();
  state_.positions_m[3].x() = 0;
  step();
  EXPECT_TRUE(std::isnan(real("gauge_one_x_min_m")) && std::isnan(real("gauge_one_x_max_m")));
}

TEST_F(ProbesTest, DeclareNodeAndForceSeriesWhereTheyExist) {
  addNodes(4);
  addLaws({"hc", "linear"});
  start();
  EXPECT_EQ(seriesNames(), (Names{"penetration_depth",
                                  "inversion_aware_depth",
                                  "passed_through",
                                  "inverted_triangles",
                                  "stand_off",
                                  "tool_position",
                                  "tool_quaternion",
                                  "contact_count",
                                  "infeasible_count",
                                  "candidate_count",
                                  "capped_count",
                                  "reaction_force",
                                  "force",
                                  "force_elastic",
                                  "force_viscous",
                                  "adhesion_clamped",
                                  "deformation_max",
                                  "deformation_mean",
                                  "deformation_rate_max",
                                  "deformation_rate_min",
                                  "deformation_rate_mean",
                                  "colliding_triangles",
                                  "tool_force",
                                  "kinetic_energy",
                                  "momentum",
                                  "volume",
                                  "timing/step_time_us",
                                  "timing/collision_time_us"}));
  EXPECT_EQ(layout_.find("force")->axes, (Names{"law", "xyz"}));
  EXPECT_EQ(layout_.find("tool_force")->axes, (Names{"law", "tool", "xyz"}));
  EXPECT_EQ(layout_.find("deformation_max")->axes, (Names{"law"}));
  EXPECT_EQ(scalar("saturated_steps").name, "absent");
  EXPECT_EQ(layout_.axis("law").labels, (Names{"hc", "linear"}));
  EXPECT_EQ(layout_.find("passed_through")->type, ValueType::count);
}

TEST_F(ProbesTest, MeasureNoToolWithoutTools) {
  scene_.tools.clear();
  state_.tools.clear();
  start();
  EXPECT_EQ(seriesNames(), (Names{"kinetic_energy", "momentum", "volume", "timing/step_time_us",
                                  "timing/collision_time_us"}));
  step();
}

TEST_F(ProbesTest, FillEveryColumn) {
  addNodes(4);
  limitForce(8);
  addLaws({"hc"});
  start();
  step();
  for (const double column : row_) EXPECT_NE(column, 12345.0);
}

TEST_F(ProbesTest, SummarizeNaNBeforeTheFirstStep) {
  addNodes(4);
  limitForce(8);
  addLaws({"hc"});
  start();
  Summary summary;
  for (const auto& probe : probes_) probe->summarize(summary);
  for (const SummaryValue& scalar : summary) {
    if (scalar.name == "tool_samples" || scalar.name == "sample_coverage_m")
      continue;  // known from the start
    if (scalar.name.starts_with("node_spacing")) continue;
    ASSERT_TRUE(std::holds_alternative<double>(scalar.value)) << scalar.name;
    EXPECT_TRUE(std::isnan(std::get<double>(scalar.value))) << scalar.name;
  }
}

// The tissue box's top is at y = 0.05, its corners far from the blade.
TEST_F(ProbesTest, PenetrationKeepsMaximumAndLastValue) {
  start();
  for (const double depth : {-0.1, 0.003, 0.001}) {
    state_.tools[0].pose = test::at(0, 0.051 - depth, 0);
    step();
  }
  EXPECT_NEAR(value("penetration_depth"), 0.001, 1e-12);
  EXPECT_NEAR(real("max_penetration_depth_m"), 0.003, 1e-12);
  EXPECT_NEAR(real("final_penetration_depth_m"), 0.001, 1e-12);
  EXPECT_EQ(count("passed_through_samples"), 0);
  EXPECT_EQ(count("max_inverted_triangles"), 0);
}

TEST_F(ProbesTest, OneUnknownDepthMakesTheMaximumUnknown) {
  start();
  step();
  state_.positions_m[3].x() = kNaN;
  step();
  state_ = test::restState(scene_, {test::at(0, 0.2, 0)});
  step();
  EXPECT_TRUE(std::isnan(real("max_penetration_depth_m")));
  EXPECT_EQ(real("final_penetration_depth_m"), 0);
}

// The tissue box reaches from y = -0.05 to 0.05.
TEST_F(ProbesTest, GroundDepthIsThatOfTheLowestVertex) {
  scene_.ground_height_m = -0.06;
  start();
  step();
  EXPECT_EQ(value("ground_depth"), 0);
  state_.positions_m[5].y() = -0.0625;
  step();
  EXPECT_NEAR(value("ground_depth"), 0.0025, 1e-15);
  state_.positions_m[5].y() = 0;
  step();
  EXPECT_EQ(value("ground_depth"), 0);
  EXPECT_NEAR(real("max_ground_depth_m"), 0.0025, 1e-15);
  state_.positions_m[5].y() = kNaN;
  step();
  EXPECT_TRUE(std::isnan(value("ground_depth")) && std::isnan(real("max_ground_depth_m")));
}

TEST_F(ProbesTest, TheGroundsReactionIsKeptWhereStatesSayIt) {
  scene_.ground_height_m = -0.06;
  scene_.ground_reaction_known = true;
  start();
  step();  // the initial state: nothing has pushed yet
  EXPECT_EQ(value("ground_reaction"), 0);
  state_.contact.ground_reaction_N = Vec3(-3, -4, 0);
  step();
  EXPECT_EQ(value("ground_reaction"), -3);
  state_.contact.ground_reaction_N = Vec3(0, -1, 0);
  step();
  EXPECT_EQ(real("max_ground_reaction_N"), 5);
}

TEST_F(ProbesTest, AnEnginesGroundSaysNoReaction) {
  scene_.ground_height_m = -0.06;
  start();
  step();
  EXPECT_EQ(layout_.find("ground_reaction"), nullptr);
  EXPECT_EQ(scalar("max_ground_reaction_N").name, "absent");
}

TEST_F(ProbesTest, WithoutGroundThereIsNoGroundDepth) {
  start();
  EXPECT_EQ(layout_.find("ground_depth"), nullptr);
  EXPECT_EQ(scalar("max_ground_depth_m").name, "absent");
}

TEST_F(ProbesTest, ATrialWithoutContactIsNamed) {
  start();
  step();
  EXPECT_EQ(count("contact_steps"), 0);
  EXPECT_EQ(std::get<std::string>(scalar("untouched_tools").value), scene_.tools[0].name);
  state_.contact.contact_count = 2;
  step();
  EXPECT_EQ(count("contact_steps"), 1);
  EXPECT_EQ(scalar("untouched_tools").name, "absent");
}

TEST_F(ProbesTest, InvertedTissueIsUnsoundBeforeTheFirstContact) {
  start();
  step();
  for (Vec3& position_m : state_.positions_m) position_m.x() = -position_m.x();
  step();
  EXPECT_EQ(count("unsound_steps"), 1);
  EXPECT_EQ(count("first_unsound_step"), 1);
}

// With a measurement of every second step: a touch in between is a touch, and what it turns inside out is not
// the tissue's own doing.
TEST_F(ProbesTest, AContactBetweenTwoMeasurementsIsNoInversionOfItsOwn) {
  scene_ = test::makeScene({makeSphere(0.05, 2)}, {{0.04, 0.002, 0.015}});
  state_ = test::restState(scene_, {test::at(0, 0.2, 0)});
  scenario_.measure.every = 2;
  start();
  step();
  state_.contact.contact_count = 1;
  step();
  state_.contact.contact_count = 0;
  const TriangleMesh& rest = scene_.bodies[0].rest;
  state_.positions_m[static_cast<std::size_t>(rest.faces.front()[0])] *= -1.2;  // turns a few triangles over
  step();
  EXPECT_GT(value("inverted_triangles"), 0);
  EXPECT_LT(2 * value("inverted_triangles"), static_cast<double>(rest.faces.size()));
  EXPECT_EQ(count("contact_steps"), 1);
  EXPECT_EQ(count("unsound_steps"), 0);
}

TEST_F(ProbesTest, ThePeakOfTheReaction) {
  start();
  for (const double y : {1.0, -5.0, 2.0}) {
    state_.contact.reaction_on_tool_N = Vec3(0, y, 0);
    step();
  }
  EXPECT_EQ(real("max_reaction_N"), 5);
}

// Two tools hold each other the balance: the sum is 0, and what each feels alternates.
TEST_F(ProbesTest, RoughnessOfTheReactionAndOfWhatEachToolFeels) {
  scene_ = test::makeScene({makeBox({0.1, 0.1, 0.1})}, {{0.04, 0.002, 0.015}, {0.04, 0.002, 0.015}});
  state_ = test::restState(scene_, {test::at(0, 0.2, 0), test::at(0, -0.2, 0)});
  addLaws({"hc", "linear"});
  start();
  for (int i = 0; i < 6; ++i) {
    const double size_N = i % 2 == 0 ? 1 : 2;
    state_.contact.tool_reactions_N = {Vec3(0, size_N, 0), Vec3(0, 0, -2)};
    state_.contact.reaction_on_tool_N = Vec3(size_N, 0, 0);
    state_.tool_forces_N = {Vec3(0, size_N, 0), Vec3(0, -size_N, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    step();
  }
  EXPECT_DOUBLE_EQ(real("reaction_roughness"), 2 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(real("tool_reaction_roughness"), 2 / std::sqrt(6.5));
  EXPECT_TRUE(std::isnan(real("force_roughness_hc"))) << "the sum is 0";
  EXPECT_DOUBLE_EQ(real("tool_force_roughness_hc"), 2 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(real("tool_force_roughness"), 2 / std::sqrt(2.5));
  EXPECT_EQ(real("tool_force_roughness_linear"), 0);
  state_.contact.tool_reactions_N.clear();
  step();
  EXPECT_TRUE(std::isnan(real("tool_reaction_roughness"))) << "not measured";
}

TEST_F(ProbesTest, OneToolHasNoRoughnessOfItsOwn) {
  addLaws({"hc"});
  start();
  step();
  for (const char* name : {"tool_reaction_roughness", "tool_force_roughness", "tool_force_roughness_hc"})
    EXPECT_EQ(scalar(name).name, "absent") << name;
}

// Along one of its axes a blade moves straight; between them it moves obliquely.
TEST_F(ProbesTest, ObliqueStepsOfNodesOnAllSides) {
  addNodes(4);
  scene_.tools[0].nodes.all_sides = true;
  start();
  const auto move = [&](const Vec3& velocity_m_s, int contacts) {
    state_.tools[0].velocity_m_s = velocity_m_s;
    state_.contact.contact_count = contacts;
    step();
  };
  move({0, -1, 0}, 1);
  move({1, 0.1, 0}, 1);
  move({0, 0, 0}, 1);
  move({1, -1, 0}, 0);
  EXPECT_EQ(count("oblique_steps"), 0);
  move({1, -1, 0}, 1);
  EXPECT_EQ(count("oblique_steps"), 1);
  move({1, 0, 0.3}, 1);
  EXPECT_EQ(count("oblique_steps"), 2);
}

TEST_F(ProbesTest, ToolPose) {
  start();
  state_.tools[0].pose = {Vec3(1, 2, 3), Quat(0.5, -0.5, 0.5, -0.5)};
  step();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(value("tool_position", i), 1.0 + static_cast<double>(i));
  const double quaternion[] = {-0.5, 0.5, -0.5, 0.5};  // x, y, z, w
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(value("tool_quaternion", i), quaternion[i]);
}

TEST_F(ProbesTest, ContactCountsAndFirstContact) {
  addNodes(4);
  start();
  for (const int contacts : {0, 0, 3, 5, 1}) {
    state_.contact.contact_count = contacts;
    state_.contact.candidate_count = contacts + 2;
    state_.contact.infeasible_count = 2;
    state_.contact.capped_count = contacts / 2;
    state_.contact.reaction_on_tool_N = Vec3(0, contacts, -1);
    step();
  }
  EXPECT_EQ(value("contact_count"), 1);
  EXPECT_EQ(value("candidate_count"), 3);
  EXPECT_EQ(value("infeasible_count"), 2);
  EXPECT_EQ(value("capped_count"), 0);
  EXPECT_EQ(value("reaction_force", 1), 1);
  EXPECT_EQ(value("reaction_force", 2), -1);
  EXPECT_DOUBLE_EQ(real("first_contact_time_s"), 0.002);
  EXPECT_EQ(count("max_contact_count"), 5);
  EXPECT_EQ(count("contacts_total"), 9);
}

// 2 nodes over 4 ms. Node 0: free, feasible, capped, infeasible, feasible: 3 switches. Node 1 never acts. 3 /
// (2 x 4 ms).
TEST_F(ProbesTest, NodeSwitchRateCountsActingAgainstNot) {
  addNodes(2);
  start();
  const NodeState first[] = {NodeState::free, NodeState::feasible, NodeState::capped, NodeState::infeasible,
                             NodeState::feasible};
  for (const NodeState node : first) {
    state_.contact.node_states = {node, node == NodeState::capped ? NodeState::infeasible : NodeState::free};
    step();
  }
  EXPECT_DOUBLE_EQ(real("node_switch_rate_hz"), 375.0);
}

// Box 0.1 m on edge, 8 vertices of 1 kg moving with (1, -2, 2) m/s: 9 / 2 J each.
TEST_F(ProbesTest, EnergyMomentumAndSignedVolume) {
  start();
  state_.velocities_m_s.assign(8, Vec3(1, -2, 2));
  state_.masses_kg[0] = 3;
  step();
  EXPECT_DOUBLE_EQ(value("kinetic_energy"), 45);
  EXPECT_DOUBLE_EQ(value("momentum", 0), 10);
  EXPECT_DOUBLE_EQ(value("momentum", 1), -20);
  EXPECT_DOUBLE_EQ(value("momentum", 2), 20);
  EXPECT_NEAR(value("volume"), 1e-3, 1e-15);
  for (Vec3& vertex : state_.positions_m) vertex.z() *= -2;
  step();
  EXPECT_NEAR(value("volume"), -2e-3, 1e-15);
}

TEST_F(ProbesTest, TimingLeavesTheInitialStateOut) {
  start();
  state_.timing = {kNaN, kNaN};
  step();
  EXPECT_TRUE(std::isnan(value("timing/step_time_us")));
  for (int i = 100; i >= 1; --i) {
    state_.timing = {static_cast<double>(i), 0.25 * i};
    step();
  }
  EXPECT_DOUBLE_EQ(real("timing/mean_step_us"), 50.5);
  EXPECT_EQ(real("timing/p50_step_us"), 50);
  EXPECT_EQ(real("timing/p99_step_us"), 99);
  EXPECT_EQ(real("timing/max_step_us"), 100);
  EXPECT_DOUBLE_EQ(real("timing/mean_collision_us"), 50.5 / 4);
  EXPECT_DOUBLE_EQ(real("timing/collision_share"), 0.25);
  EXPECT_DOUBLE_EQ(real("timing/real_time_factor"), 1000 / 50.5);
}

// Percentiles of a long run are of evenly spaced steps; mean and maximum are of all.
TEST_F(ProbesTest, TimingOfALongRunIsOfAllItsSteps) {
  start();
  constexpr int kSteps = 140000;
  double sum_us = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double step_us = i == 1 ? 5000 : i % 1000;
    sum_us += step_us;
    state_.timing = {step_us, 0};
    step();
  }
  EXPECT_NEAR(real("timing/p50_step_us"), 499.5, 3);
  EXPECT_NEAR(real("timing/p99_step_us"), 989.5, 3);
  EXPECT_EQ(real("timing/max_step_us"), 5000);
  EXPECT_DOUBLE_EQ(real("timing/mean_step_us"), sum_us / kSteps);
}

TEST_F(ProbesTest, StepsAndHashOfTheLastState) {
  start();
  step();
  step();
  state_.velocities_m_s[7] = Vec3(0, 0, 1e-300);
  step();
  EXPECT_EQ(count("steps"), 2);
  EXPECT_EQ(std::get<std::string>(scalar("final_state_hash").value),
            stateHash(state_.positions_m, state_.velocities_m_s));
}

TEST_F(ProbesTest, ClampsOfBothKindsAreOpenInTheirOwnUnits) {
  scene_.tools.push_back(scene_.tools[0]);
  scene_.tools[0].name = "left", scene_.tools[1].name = "right";
  scene_.clamps = {{.name = "gripper", .left_tool = 0, .right_tool = 1},
                   {.name = "forceps", .left_tool = 1, .right_tool = 0, .hinged = true}};
  state_.tools.resize(2);
  state_.clamps = {{.opening = 0.02}, {.opening = 30}};
  addLaws({"hc", "soft"});
  start();
  state_.contact.tool_reactions_N = {Vec3(1, 0, 0), Vec3(-4, 0, 0)};
  state_.tool_forces_N[2] = Vec3(0, 3, 0);  // of the second law, on the left
  state_.tool_forces_N[3] = Vec3(0, 0, 4);
  step();
  EXPECT_EQ(value("jaw_opening", 0), 0.02);
  EXPECT_TRUE(std::isnan(value("jaw_opening", 1)));
  EXPECT_TRUE(std::isnan(value("jaw_angle", 0)));
  EXPECT_EQ(value("jaw_angle", 1), 30);
  EXPECT_EQ(value("clamp_reaction", 0), -3);
  EXPECT_EQ(value("clamp_force", 3 * 2 + 1), 3) << "second law, first clamp, y";
  EXPECT_EQ(value("clamp_force", 3 * 3 + 2), 4) << "second law, second clamp, z";
  EXPECT_EQ(real("gripper_max_resultant_soft_N"), 5);
  EXPECT_EQ(real("gripper_left_max_force_soft_N"), 3);
  EXPECT_EQ(real("forceps_left_max_force_soft_N"), 4);
  EXPECT_EQ(real("gripper_max_resultant_hc_N"), 0);
  EXPECT_EQ(real("gripper_final_reaction_N"), 3);
  state_.contact.tool_reactions_N.clear();
  step();
  EXPECT_TRUE(std::isnan(value("clamp_reaction", 0)));
  EXPECT_TRUE(std::isnan(value("tool_reaction", 0)));
  EXPECT_EQ(scalar("gripper_final_reaction_N").name, "absent");
}

}  // namespace
}  // namespace fissure::probes_test
