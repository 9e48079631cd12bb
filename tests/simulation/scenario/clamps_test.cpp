#include <functional>
#include <string>

#include "scenario/rigid_tools.h"
#include "scenario_text.h"

namespace fissure::clamps_test {

namespace {

/// A hinged clamp with all there is, on a script, and a parallel one on a log. The first tool starts at
/// line 9.
const std::string clamps_text = std::string(smallest_text) +
                                "tools:\n"
                                "  - name: forceps\n"
                                "    shape: {type: box, size_m: [0.004, 0.04, 0.01]}\n"
                                "    clamp:\n"
                                "      opening: hinged\n"
                                "      hinge_height_m: 0.05\n"
                                "      jaw_position_m: [0.003, 0.001, 0.002]\n"
                                "      jaw_orientation: [0, 0, 0, 1]\n"
                                "      left_jaw:\n"
                                "        shape: {type: box, size_m: [0.002, 0.03, 0.02]}\n"
                                "        position_m: [-0.002, 0.004, 0]\n"
                                "        orientation: [0, 1, 0, 0]\n"
                                "      handle:\n"
                                "        - {shape: {type: box, size_m: [0.01, 0.02, 0.03]}, "
                                "position_m: [0, 0.1, 0], orientation: [1, 0, 0, 0]}\n"
                                "    motion:\n"
                                "      type: script\n"
                                "      start_m: [0, 0, 0]\n"
                                "      start_opening_deg: 30\n"
                                "      segments:\n"
                                "        - {open_to_deg: 10, duration_s: 0.5, timing: minimum_jerk}\n"
                                "        - {move_to_m: [0, 1, 0], open_to_deg: 0, speed_m_s: 2}\n"
                                "  - name: gripper\n"
                                "    shape: {type: box, size_m: [0.004, 0.04, 0.01]}\n"
                                "    clamp: {opening: parallel, jaw_position_m: [0.002, 0, 0]}\n"
                                "    nodes: {resolution: [5, 3]}\n"
                                "    friction: 0.5\n"
                                "    force_limit_N: 8\n"
                                "    motion:\n"
                                "      type: replay\n"
                                "      file: hand.csv\n"
                                "      rate_hz: 1000\n"
                                "      opening: {axis: z, closed_device_m: 0.09, open_device_m: 0.12, "
                                "open_m: 0.05}\n";

class Clamps : public ScenarioFiles {
 protected:
  Clamps() { write("hand.csv", "x,y,z\n0,0,0\n"); }
  /// The error of the scenario with `from` replaced by `to`, once.
  std::string errorWith(const std::string& from, const std::string& to) {
    std::string text = clamps_text;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    write("a.yaml", text.replace(text.find(from), from.size(), to));
    return loadError("a.yaml");
  }
};

TEST_F(Clamps, EveryFieldIsReadAndWrittenBack) {
  const std::filesystem::path file = write("a.yaml", clamps_text);
  const LoadedScenario loaded = loadScenario(file);
  EXPECT_EQ(parseScenario(loaded.resolved, file).scenario, loaded.scenario) << loaded.resolved;
  const ToolSettings &forceps = loaded.scenario.tools[0], &gripper = loaded.scenario.tools[1];
  const ClampPart left{BoxShape{Vec3(0.002, 0.03, 0.02)}, {-0.002, 0.004, 0}, {0, 0, 1, 0}};
  const ClampPart handle{BoxShape{Vec3(0.01, 0.02, 0.03)}, {0, 0.1, 0}, {0, 1, 0, 0}};
  EXPECT_EQ(
      forceps.clamp,
      (ClampSettings{ClampOpening::hinged, 0.05, {0.003, 0.001, 0.002}, Quat::Identity(), left, {handle}}));
  const auto& script = std::get<ScriptMotion>(forceps.motion);
  EXPECT_EQ(script.start_opening_deg, 30);
  EXPECT_EQ(script.segments[0].openTo(), 10);
  EXPECT_EQ(std::get<ReplayMotion>(gripper.motion).opening,
            (DeviceOpening{DeviceAxis::z, 0.09, 0.12, 0.05, std::nullopt}));
}

TEST_F(Clamps, AreTwoRigidToolsOfTheirNames) {
  const Scenario s = loadScenario(write("a.yaml", clamps_text)).scenario;
  const std::vector<ToolSettings> rigid = rigidTools(s.tools);
  ASSERT_EQ(rigid.size(), 4u);
  const std::array<const char*, 4> names = {"forceps_left", "forceps_right", "gripper_left", "gripper_right"};
  for (std::size_t t = 0; t < 4; ++t) {
    EXPECT_EQ(rigid[t].name, names[t]);
    EXPECT_FALSE(rigid[t].clamp);
  }
  EXPECT_EQ(std::get<BoxShape>(rigid[0].shape).size_m, Vec3(0.002, 0.03, 0.02)) << "its own";
  EXPECT_EQ(std::get<BoxShape>(rigid[1].shape).size_m, Vec3(0.004, 0.04, 0.01));
  EXPECT_EQ(std::get<BoxShape>(rigid[2].shape).size_m, Vec3(0.004, 0.04, 0.01))
      << "the right one's mirror image";
  EXPECT_EQ(rigid[2].nodes.resolution, (std::array<int, 2>{5, 3}));
  EXPECT_EQ(rigid[2].friction, 0.5);
  EXPECT_EQ(rigid[3].force_limit_N, 8);
  EXPECT_EQ(rigidTools(rigid), rigid) << "rigid ones stay";
}

// The mirror image of where a point of the right jaw is, is where the mirrored point of the left jaw is.
TEST(ClosedJaws, AreMirrorImagesInTheMiddle) {
  ToolSettings clamp;
  clamp.clamp = ClampSettings{.jaw_position_m = {0.3, -0.2, 0.1},
                              .jaw_orientation = Quat(0.1, 0.7, -0.3, 0.5).normalized()};
  const auto [left, right] = closedJaws(clamp);
  const auto mirrored = [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); };
  for (const Vec3& point : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.2, -0.5, 0.7)}) {
    const Vec3 of_right = Pose{right.position_m, right.orientation}.toScene(point);
    const Vec3 of_left = Pose{left.position_m, left.orientation}.toScene(mirrored(point));
    EXPECT_LT((of_left - mirrored(of_right)).norm(), 1e-15);
  }
}

TEST_F(Clamps, RefuseWhatIsWrongInOneLine) {
  struct Case {
    const char *from, *to, *message;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"{type: box, size_m: [0.002, 0.03, 0.02]}", "{type: sphere, radius_m: 0.001}",
            "10: tools.forceps.nodes.placement is grid, expected centroids: only a box has large faces for a "
            "grid"},
           {"opening: hinged", "opening: hinge",
            "13: tools.forceps.clamp.opening is \"hinge\", did you mean \"hinged\"?"},
           {"      hinge_height_m: 0.05\n", "",
            "12: missing key \"hinge_height_m\" in tools.forceps.clamp, expected it"},
           {"clamp: {opening: parallel,", "clamp: {opening: parallel, hinge_height_m: 1,",
            "32: key \"hinge_height_m\" in tools.gripper.clamp has no meaning here, expected it only for "
            "opening "
            "hinged"},
           {"hinge_height_m: 0.05", "hinge_height_m: 0.02",
            "15: tools.forceps.clamp.jaw_position_m puts the jaw 1 mm above the hinge, "
            "where "
            "it meets the other one when they open, expected it below"},
           {"jaw_position_m: [0.003,", "jaw_position_m: [0.001,",
            "15: tools.forceps.clamp.jaw_position_m puts the jaw 1 mm beyond the clamp's plane x = 0, "
            "where it "
            "meets the other one, expected it on the right (x >= 0)"},
           {"position_m: [-0.002,", "position_m: [0,",
            "19: tools.forceps.clamp.left_jaw.position_m puts the jaw 1 mm beyond the clamp's plane x = 0, "
            "where it meets the other one, expected it on the left (x <= 0)"},
           {"open_to_deg: 10", "open_to_deg: -1",
            "28: tools.forceps.motion.segments.0.open_to_deg is -1, expected a number from 0 to 180"},
           {"open_to_deg: 10", "open_to_m: 0.01",
            "28: tools.forceps.motion.segments.0.open_to_m is given for hinged jaws, expected open_to_deg"},
           {"start_opening_deg: 30", "start_opening_deg: 181",
            "26: tools.forceps.motion.start_opening_deg is 181, expected a number from 0 to 180"},
           {"{open_to_deg: 10, duration_s: 0.5,", "{open_to_deg: 10, speed_m_s: 0.5,",
            "28: tools.forceps.motion.segments.0.speed_m_s is given for a way of no length, expected "
            "duration_s"},
           {"{open_to_deg: 10,", "{",
            "28: tools.forceps.motion.segments.0 does nothing, expected hold_s, move_to_m, rotate_to or, of "
            "a "
            "clamp, an opening"},
           {"open_to_deg: 10, duration_s: 0.5, timing: minimum_jerk", "open_to_deg: 10, hold_s: 0.5",
            "28: tools.forceps.motion.segments.0 holds and moves, expected hold_s alone or without it a "
            "movement"},
           {"    clamp: {opening: parallel, jaw_position_m: [0.002, 0, 0]}\n", "",
            "39: tools.gripper.motion.opening is given for a tool that does not open, expected a clamp"},
           {"      opening: {axis: z, closed_device_m: 0.09, open_device_m: 0.12, open_m: 0.05}\n", "",
            "36: tools.gripper.motion has no opening, expected the device axis that opens the clamp"},
           {"axis: z", "axis: -z",
            "40: tools.gripper.motion.opening.axis is \"-z\", expected an axis of the device: x, y or z"},
           {"open_device_m: 0.12", "open_device_m: 0.09",
            "40: tools.gripper.motion.opening.open_device_m is closed_device_m too, expected another place"},
           {", open_m: 0.05", "",
            "40: tools.gripper.motion.opening does not say how far it opens, expected open_m"},
           {"open_m: 0.05", "open_deg: 5",
            "40: tools.gripper.motion.opening.open_deg is given for parallel jaws, expected open_m"},
           {"open_m: 0.05", "open_m: 0",
            "40: tools.gripper.motion.opening.open_m is 0, expected more: the clamp would never open"},
           {"open_m: 0.05", "open_m: -1",
            "40: tools.gripper.motion.opening.open_m is -1, expected a number of at least 0: the jaws touch "
            "there"},
           {"name: gripper", "name: forceps_left",
            "30: tools.forceps_left.name is that of a jaw of \"forceps\" too, expected another"}})
    EXPECT_EQ(errorWith(c.from, c.to), std::string("a.yaml:") + c.message) << c.to;
}

TEST_F(Clamps, NeedANameThatLeavesRoomForTheirJaws) {
  EXPECT_EQ(errorWith("gripper", std::string(58, 'g')), "nothing");
  EXPECT_NE(errorWith("gripper", std::string(59, 'g')).find("too long for its jaw"), std::string::npos);
}

TEST_F(Clamps, OpeningsAreForClampsOnly) {
  EXPECT_NE(
      errorWith("    clamp: {opening: parallel, jaw_position_m: [0.002, 0, 0]}\n", "").find("does not open"),
      std::string::npos);
  ToolSettings blade;
  blade.name = "blade";
  MotionSegment opens;
  opens.open_to_m = 0.1;
  opens.duration_s = 1;
  blade.motion = ScriptMotion{.segments = {opens}};
  Scenario s = smallest();
  s.tools = {blade};
  const std::vector<Problem> problems = validate(s);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].path, "tools.blade.motion.segments.0.open_to_m");
  EXPECT_EQ(problems[0].message, "is given for a tool that does not open, expected a clamp");
}

TEST(Capsule, IsReadWrittenAndChecked) {
  const auto with = [](const std::string& shape) {
    return parseScenario(smallest_text, "a.yaml", {{"bodies.0.shape", shape}});
  };
  const LoadedScenario loaded = with("{type: capsule, radius_m: 0.01, length_m: 0.05, subdivisions: 1}");
  EXPECT_EQ(std::get<CapsuleShape>(loaded.scenario.bodies[0].shape), (CapsuleShape{0.01, 0.05, 1}));
  EXPECT_EQ(parseScenario(loaded.resolved, "a.yaml").scenario, loaded.scenario);
  EXPECT_NE(inputError([&] {
              with("{type: capsule, radius_m: 0.01, length_m: 0}");
            }).find("length_m is 0, expected a number above 0"),
            std::string::npos);
  EXPECT_NE(inputError([&] {
              with("{type: capsule, radius_m: 1e-6, length_m: 10}");
            }).find("triangles, expected at most"),
            std::string::npos)
      << "counted before any is made";
}

}  // namespace

}  // namespace fissure::clamps_test
