#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "recorded_run.h"
#include "scene/build_scene.h"

namespace fissure::clamp_test {

namespace {

MotionSegment opens(double to_m, double duration_s) {
  MotionSegment segment;
  segment.open_to_m = to_m;
  segment.duration_s = duration_s;
  segment.timing = Timing::minimum_jerk;
  return segment;
}

/// A sphere of 100 g and a clamp open around it, which closes by 7 mm on each side in 0.2 s.
class ClampRun : public RecordedRun {
 protected:
  ClampRun() {
    scenario.name = "clamp";
    scenario.bodies = {softSphere()};
    ToolSettings tool;
    tool.name = "clamp";
    tool.shape = BoxShape{Vec3(0.004, 0.04, 0.04)};
    tool.nodes.resolution = {12, 12};
    tool.clamp = ClampSettings{.jaw_position_m = {0.002, 0, 0}};
    tool.motion = ScriptMotion{.segments = {opens(0.046, 0.2), holds(0.2)}, .start_opening_m = 0.062};
    scenario.tools = {tool};
    scenario.world.gravity_m_s2 = Vec3::Zero();
    scenario.force = {
        {.name = "hc", .model = ForceModel::hunt_crossley, .deformation = DeformationKind::corotated}};
    scenario.pipelines = {{.name = "full", .pipeline = PipelineKind::fukuhara}};
  }

  ClampSettings& clamp() { return *scenario.tools[0].clamp; }
  const State& last() const { return states_.back(); }
  double lowest_m() const {
    double lowest_m = 1;
    for (const Vec3& p : last().positions_m) lowest_m = std::min(lowest_m, p.y());
    return lowest_m;
  }
  /// How much the forces across the jaws differ, over their size.
  static double difference(const Vec3& left_N, const Vec3& right_N) {
    return std::abs(right_N.x() + left_N.x()) / right_N.norm();
  }
  /// The same of the right jaw's force and the mirror image of the left one's, friction along the jaws too.
  static double asymmetry(const Vec3& left_N, const Vec3& right_N) {
    return (right_N - Vec3(-left_N.x(), left_N.y(), left_N.z())).norm() / right_N.norm();
  }
};

/// One way of closing on a body that is its own mirror image.
struct Grasp {
  const char* name;
  std::function<void(Scenario&)> set;
};
class MirrorJaws : public ClampRun, public testing::WithParamInterface<Grasp> {};

// Held still in the end: what remains is that Bullet's links are solved one after the other.
TEST_P(MirrorJaws, FeelEqualForces) {
  GetParam().set(scenario);
  execute();
  int compared = 0;
  double worst = 0, worst_law = 0, worst_mirrored = 0;
  for (const State& state : states_) {
    if (state.time_s < 0.25) continue;
    const Vec3 &left_N = state.contact.tool_reactions_N[0], &right_N = state.contact.tool_reactions_N[1];
    ASSERT_GT(right_N.norm(), 5) << state.time_s;
    worst = std::max(worst, difference(left_N, right_N));
    worst_law = std::max(worst_law, difference(state.tool_forces_N[0], state.tool_forces_N[1]));
    worst_mirrored = std::max(worst_mirrored, asymmetry(left_N, right_N));
    ++compared;
  }
  EXPECT_GT(compared, 100);
  EXPECT_LT(worst, 0.02);
  EXPECT_LT(worst_law, 0.02);
  EXPECT_LT(worst_mirrored, 0.06) << "rubbed along the jaws by what is turned";
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("worst_law", std::to_string(worst_law));
  RecordProperty("worst_mirrored", std::to_string(worst_mirrored));
}

INSTANTIATE_TEST_SUITE_P(
    Ways, MirrorJaws,
    testing::Values(
        Grasp{"parallel", [](Scenario&) {}},
        Grasp{"hinged",
              [](Scenario& s) {
                s.tools[0].clamp->opening = ClampOpening::hinged;
                s.tools[0].clamp->hinge_height_m = 0.1;
                s.tools[0].friction = 1;  // else the wedge of the jaws drives the sphere out
                MotionSegment closes = opens(0, 0.2);
                closes.open_to_m.reset();
                closes.open_to_deg = 27;
                s.tools[0].motion = ScriptMotion{.segments = {closes, holds(0.2)}, .start_opening_deg = 40};
              }},
        Grasp{"vessel",
              [](Scenario& s) {
                s.bodies[0].shape = CapsuleShape{0.03, 0.06, 2};
                s.tools[0].friction = 1;
                s.bodies[0].orientation = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitY()));
              }},
        Grasp{
            "given",  // the same left jaw as the mirror image, stated
            [](Scenario& s) {
              s.tools[0].clamp->left_jaw = ClampPart{.shape = s.tools[0].shape, .position_m = {-0.002, 0, 0}};
            }}),
    [](const testing::TestParamInfo<Grasp>& way) { return way.param.name; });

class LiftingClamp : public ClampRun {
 protected:
  /// Grasps the sphere on the ground, lifts it by 50 mm and holds it.
  void lift(double friction) {
    scenario.world.gravity_m_s2 = Vec3(0, -9.81, 0);
    scenario.ground = GroundSettings{};
    scenario.bodies[0].position_m = Vec3(0, 0.03, 0);
    scenario.tools[0].friction = friction;
    scenario.tools[0].motion =
        ScriptMotion{.start_m = Vec3(0, 0.031, 0),
                     .segments = {opens(0.046, 0.2), moves(Vec3(0, 0.081, 0), 0.5), holds(0.5)},
                     .start_opening_m = 0.062};
    execute();
  }
};

TEST_F(LiftingClamp, HoldsWithFriction) {
  lift(1);
  EXPECT_NEAR(lowest_m(), 0.05, 0.003);
  EXPECT_NEAR(seen.number("clamp_final_reaction_N"), 0.981, 0.02) << "its weight";
}

TEST_F(LiftingClamp, SlipsWithoutFriction) {
  lift(0);
  EXPECT_LT(lowest_m(), 0.002) << "on the ground";
  EXPECT_EQ(seen.number("clamp_final_reaction_N"), 0);
}

TEST_F(ClampRun, RecordsEachJawAndTheResultant) {
  scenario.world.gravity_m_s2 = Vec3(0, 0, 0.5);  // not the same on both jaws, nor along one axis
  scenario.tools[0].friction = 1;
  execute();
  const std::size_t reaction = layout.find("clamp_reaction")->first_column;
  const std::size_t of_tools = layout.find("tool_reaction")->first_column;
  const std::size_t whole = layout.find("reaction_force")->first_column;
  const std::size_t force = layout.find("clamp_force")->first_column;
  const std::size_t forces = layout.find("tool_force")->first_column;
  const std::size_t opening = layout.find("jaw_opening")->first_column;
  EXPECT_EQ(layout.find("jaw_angle"), nullptr) << "no hinge, no angle";
  EXPECT_EQ(layout.axis("tool").labels, (std::vector<std::string>{"clamp_left", "clamp_right"}));
  double largest_N = 0, largest_left_N = 0;
  for (std::size_t i = 0; i < seen.rows.size(); ++i) {
    const RecordRow& row = seen.rows[i];
    Vec3 resultant_N, left_N;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(row[reaction + k], row[of_tools + k] + row[of_tools + 3 + k]);
      EXPECT_NEAR(row[reaction + k], row[whole + k], 1e-12 * (1 + std::abs(row[of_tools + k])));
      EXPECT_EQ(row[force + k], row[forces + k] + row[forces + 3 + k]);
      resultant_N[static_cast<int>(k)] = row[force + k];
      left_N[static_cast<int>(k)] = row[forces + k];
    }
    largest_N = std::max(largest_N, resultant_N.norm());
    largest_left_N = std::max(largest_left_N, left_N.norm());
    EXPECT_EQ(row[opening], states_[i].clamps[0].opening);
    const double between_m =
        states_[i].tools[1].pose.position_m.x() - states_[i].tools[0].pose.position_m.x();
    EXPECT_NEAR(row[opening], between_m - 0.004, 1e-15);
  }
  EXPECT_GT(largest_N, 0);
  EXPECT_EQ(seen.number("clamp_max_resultant_hc_N"), largest_N);
  EXPECT_EQ(seen.number("clamp_left_max_force_hc_N"), largest_left_N);
  EXPECT_GT(seen.number("clamp_right_max_force_hc_N"), 1);
}

TEST_F(ClampRun, BulletDoesNotSayTheReactionsOfJaws) {
  scenario.pipelines = {
      {.name = "default", .pipeline = PipelineKind::default_sdf, .settings = SettingsPreset::tuned}};
  execute();
  EXPECT_TRUE(std::isnan(seen.rows.back()[layout.find("clamp_reaction")->first_column]));
  EXPECT_TRUE(std::isnan(seen.rows.back()[layout.find("tool_reaction")->first_column]));
  EXPECT_FALSE(seen.summary.contains("clamp_final_reaction_N"));
  EXPECT_GT(seen.number("clamp_left_max_force_hc_N"), 0);
}

// The jaws pass each other's places when they close: they meet tissue only.
TEST_F(ClampRun, JawsDoNotMeetEachOther) {
  scenario.bodies[0].position_m = Vec3(0, 0.2, 0);
  scenario.tools[0].motion = ScriptMotion{.segments = {opens(0, 0.1)}, .start_opening_m = 0.062};
  execute();
  EXPECT_EQ(last().tools[1].pose.position_m.x(), 0.002);
  EXPECT_EQ(last().tools[0].pose.position_m.x(), -0.002);
  EXPECT_EQ(seen.number("clamp_max_resultant_hc_N"), 0);
}

TEST_F(ClampRun, AHandleChangesNothing) {
  execute();
  const Seen without = seen;
  const std::vector<State> states = states_;
  // Where it would squash the sphere, if it met it.
  clamp().handle = {ClampPart{.shape = BoxShape{Vec3(0.05, 0.05, 0.05)}}};
  execute();
  EXPECT_EQ(std::get<std::string>(seen.summary.at("final_state_hash").value),
            std::get<std::string>(without.summary.at("final_state_hash").value));
  EXPECT_EQ(last().positions_m, states.back().positions_m);
  EXPECT_EQ(seen.number("max_penetration_depth_m"), without.number("max_penetration_depth_m"));
}

TEST_F(ClampRun, AHandleIsMadeOnlyForWhatCanBeDrawn) {
  clamp().handle = {ClampPart{.shape = BoxShape{Vec3(0.01, 0.02, 0.03)}, .position_m = {0, 0.1, 0}},
                    ClampPart{.shape = BoxShape{Vec3(0.01, 0.02, 0.03)}, .position_m = {0, 0.2, 0}}};
  EXPECT_TRUE(buildScene(scenario, true).clamps.at(0).handle.vertices_m.empty());
  scenario.record.frames = FrameSettings{};
  const Scene scene = buildScene(scenario, true);
  EXPECT_EQ(scene.clamps.at(0).handle.vertices_m.size(), 16u);
  EXPECT_EQ(scene.clamps.at(0).handle.faces.size(), 24u);
  EXPECT_EQ(scene.clamps.at(0).handle.vertices_m.back(), Vec3(0.005, 0.2 + 0.01, 0.015));
  EXPECT_EQ(scene.clamps.at(0).handle.faces.back()[0], 8 + scene.clamps.at(0).handle.faces.at(11)[0]);
  EXPECT_EQ(scene.tools.size(), 2u);
  EXPECT_EQ(scene.nodeCount(), 2 * 2 * 144);
  EXPECT_TRUE(scene.hasHandles());
  scenario.record.frames.reset();
  EXPECT_FALSE(buildScene(scenario, true).hasHandles());
  scenario.record.snapshots_every_s = 0.1;  // which can be drawn later
  EXPECT_EQ(buildScene(scenario, true).clamps.at(0).handle.faces, scene.clamps.at(0).handle.faces);
}

}  // namespace
}  // namespace fissure::clamp_test
