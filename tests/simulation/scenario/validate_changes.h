#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "scenario_text.h"

namespace fissure {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A good scenario with one of everything: a ball, a scripted blade, a replayed hand, two pipelines, a law, a
/// camera.
inline Scenario full() {
  Scenario s = smallest();
  s.ground = GroundSettings{};
  s.time.duration_s.reset();
  ToolSettings blade;
  blade.name = "blade";
  MotionSegment down;
  down.move_to_m = Vec3(0, -1, 0);
  down.speed_m_s = 2;
  blade.motion = ScriptMotion{Vec3::Zero(), Quat::Identity(), {down}};
  ToolSettings hand;
  hand.name = "hand";
  ReplayMotion replay;
  replay.file = "hand.csv";
  replay.time_column = "t";
  hand.motion = replay;
  s.tools = {blade, hand};
  PipelineSettings fukuhara;
  fukuhara.name = "fukuhara";
  fukuhara.pipeline = PipelineKind::fukuhara;
  s.pipelines.push_back(fukuhara);
  s.force = {{"hc", ForceModel::hunt_crossley}};
  s.record.snapshots_every_s = 0.01;
  s.record.frames = FrameSettings{};
  s.record.frames->camera = CameraSettings{};
  return s;
}

inline ScriptMotion& script(Scenario& s) {
  return std::get<ScriptMotion>(s.tools[0].motion);
}
inline MotionSegment& segment(Scenario& s) {
  return script(s).segments[0];
}
inline ReplayMotion& replay(Scenario& s) {
  return std::get<ReplayMotion>(s.tools[1].motion);
}
inline SphereShape& sphere(Scenario& s) {
  return std::get<SphereShape>(s.bodies[0].shape);
}

struct Change {
  const char* path;  ///< of the one problem that this makes
  std::function<void(Scenario&)> make;
};

inline void expectProblems(const std::vector<Change>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scenario s = full();
    changes[i].make(s);
    const std::vector<Problem> problems = validate(s);
    ASSERT_FALSE(problems.empty()) << "change " << i << " at " << changes[i].path;
    EXPECT_EQ(problems[0].path, changes[i].path) << "change " << i << ": " << problems[0].message;
    const std::string& message = problems[0].message;
    EXPECT_TRUE(message.find("expected") != std::string::npos ||
                message.find("did you mean") != std::string::npos)
        << message;
    EXPECT_EQ(problems.size(), 1u) << "change " << i << ": " << problems.back().path;
  }
}

}  // namespace fissure
