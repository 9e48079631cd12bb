#include "validate_changes.h"

namespace fissure::validate_motions_test {

namespace {

TEST(Validate, ALogOfAxesNeedsARateAlone) {
  Scenario s = full();
  replay(s).layout = LogLayout::axes;
  replay(s).time_column.reset();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_NE(validate(s)[0].message.find("expected rate_hz"), std::string::npos);
  replay(s).rate_hz = 100;
  EXPECT_TRUE(validate(s).empty());
}

TEST(Validate, Scripts) {
  expectProblems({
      {"tools.1.name", [](Scenario& s) { s.tools[1].name = "blade"; }},
      {"tools.blade.shape.size_m", [](Scenario& s) { std::get<BoxShape>(s.tools[0].shape).size_m.y() = 0; }},
      {"tools.blade.nodes.resolution", [](Scenario& s) { s.tools[0].nodes.resolution[1] = 0; }},
      {"tools.blade.nodes.resolution", [](Scenario& s) { s.tools[0].nodes.resolution[0] = 513; }},
      {"tools.blade.nodes.narrow_rows", [](Scenario& s) { s.tools[0].nodes.narrow_rows = -1; }},
      {"tools.blade.friction", [](Scenario& s) { s.tools[0].friction = -1; }},
      {"tools.blade.force_limit_N", [](Scenario& s) { s.tools[0].force_limit_N = 0; }},
      {"tools.blade.force_limit_N", [](Scenario& s) { s.tools[0].force_limit_N = nan; }},
      {"tools.blade.motion.start_orientation", [](Scenario& s) { script(s).start_orientation.z() = 1; }},
      {"tools.blade.motion.segments.0.move_to_m", [](Scenario& s) { segment(s).move_to_m->x() = nan; }},
      {"tools.blade.motion.segments.0.speed_m_s", [](Scenario& s) { segment(s).speed_m_s = 0; }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).speed_m_s.reset(); }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).duration_s = 1; }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).move_to_m.reset(); }},
      {"tools.blade.motion.segments.0.speed_m_s", [](Scenario& s) { segment(s).move_to_m = Vec3::Zero(); }},
      {"tools.blade.motion.segments.0.rotate_to",
       [](Scenario& s) { segment(s).rotate_to = Quat(1, 1, 0, 0); }},
      {"tools.blade.motion.segments.0.ramp_fraction", [](Scenario& s) { segment(s).ramp_fraction = 0.6; }},
      {"tools.blade.motion.segments.0.ramp_fraction", [](Scenario& s) { segment(s).ramp_fraction = 0; }},
      {"tools.blade.motion.segments.1.speed_m_s",
       [](Scenario& s) { script(s).segments.push_back(segment(s)); }},  // a second move to the same point
      {"tools.blade.motion.segments.0.hold_s",
       [](Scenario& s) { segment(s) = {{}, {}, 0.0, {}, {}, Timing::constant, 0.25}; }},
      {"tools.blade.motion.segments.0.hold_s",
       [](Scenario& s) {  // alone: the time of the whole script would be negative
         s.tools.pop_back();
         segment(s) = {{}, {}, -1.0, {}, {}, Timing::constant, 0.25};
       }},
      {"tools.blade.motion.segments.0",
       [](Scenario& s) { segment(s) = {{}, {}, 1.0, 1.0, {}, Timing::constant, 0.25}; }},
      {"tools.blade.motion.segments.0",
       [](Scenario& s) { segment(s) = {Vec3(1, 1, 1), {}, 1.0, {}, {}, Timing::constant, 0.25}; }},
  });
}

TEST(Validate, AMoveOfNoLengthIsFineWithADuration) {
  Scenario s = full();
  segment(s) = {Vec3::Zero(), {}, {}, {}, 0.5, Timing::constant, 0.25};
  EXPECT_TRUE(validate(s).empty());
}

TEST(Validate, Replays) {
  const auto axes = [](const char* x, const char* y, const char* z) {
    return [=](Scenario& s) { replay(s).mapping.axes = {x, y, z}; };
  };
  expectProblems({
      {"tools.hand.motion.file", [](Scenario& s) { replay(s).file = ""; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).rate_hz = 1000; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).time_column.reset(); }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).time_column = "x"; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).position_columns[2] = ""; }},
      {"tools.hand.motion",
       [](Scenario& s) {
         replay(s).quaternion_columns = {"a", "b", "c", "y"};
       }},
      {"tools.hand.motion.mapping.axes", axes("x", "z", "y")},   // left-handed
      {"tools.hand.motion.mapping.axes", axes("x", "y", "-z")},  // left-handed
      {"tools.hand.motion.mapping.axes", axes("x", "x", "z")},   // an axis twice
      {"tools.hand.motion.mapping.axes", axes("x", "y", "w")},   // no such axis
      {"tools.hand.motion.mapping.axes", axes("", "y", "z")},
      {"tools.hand.motion.mapping.axes", axes("--x", "y", "z")},
      {"tools.hand.motion.mapping.scale", [](Scenario& s) { replay(s).mapping.scale = 0; }},
      {"tools.hand.motion.mapping.mount", [](Scenario& s) { replay(s).mapping.mount = Quat(0, 0, 0, 0); }},
      {"tools.hand.motion.start_s", [](Scenario& s) { replay(s).start_s = -1; }},
      {"tools.hand.motion.end_s", [](Scenario& s) { replay(s).end_s = 0; }},
      {"tools.hand.motion.max_gap_s", [](Scenario& s) { replay(s).max_gap_s = 0; }},
      {"tools.hand.motion.jump_m", [](Scenario& s) { replay(s).jump_m = nan; }},
      {"tools.hand.motion.jump_speed_m_s", [](Scenario& s) { replay(s).jump_speed_m_s = 0; }},
      {"tools.hand.motion.frame_column", [](Scenario& s) { replay(s).frame_column = "Frame"; }},
      {"tools.hand.motion.time_unit",
       [](Scenario& s) {
         replay(s).time_column.reset();
         replay(s).rate_hz = 60;
         replay(s).time_unit = TimeUnit::ms;
       }},
      {"tools.hand.motion",
       [](Scenario& s) {
         replay(s).time_column.reset();
         replay(s).rate_hz = 60;
         replay(s).frame_column = "x";
       }},
  });
  for (const auto& good : {axes("x", "-z", "y"), axes("-x", "-y", "z"), axes("y", "z", "x")}) {
    Scenario s = full();
    good(s);
    EXPECT_TRUE(validate(s).empty());
  }
}

TEST(Validate, TheLongestScriptIsTheDurationWhereNoneIsGiven) {
  // 1 m at 2 m/s and a hold of 0.25 s: 0.75 s.
  Scenario s = full();
  s.tools.pop_back();
  s.record = {};
  script(s).segments.push_back({{}, {}, 0.25, {}, {}, Timing::constant, 0.25});
  s.time.step_s = 0.75;
  EXPECT_TRUE(validate(s).empty());
  s.time.step_s = 0.7501;
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].message, "is 0.7501, expected at most the duration, 0.75 s");
  script(s).segments.clear();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].path, "time");
  s.tools.clear();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].path, "time");
}

}  // namespace

}  // namespace fissure::validate_motions_test
