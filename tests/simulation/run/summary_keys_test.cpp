// The table of keys that are made of names is the one that runs write.
#include "scenario/summary_keys.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "recorded_run.h"

namespace fissure::summary_keys_test {

namespace {

/// One of everything that has a name in keys: each holds "qq", which no other key does.
class NamedRun : public RecordedRun {
 protected:
  NamedRun()
      : folder_(std::filesystem::temp_directory_path() / ("fissure_keys_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "log.csv") << "t,x,y,z,s\n0,0,0.2,0,ok\n0.005,0,0.2,0.001,ok\n";
    scenario.name = "keys";
    scenario.directory = folder_;
    scenario.time.duration_s = 0.005;
    scenario.bodies = {softSphere()};
    scenario.bodies[0].gauges = {{.name = "qqgauge", .box = {.min_m = {-1, -1, -1}, .max_m = {1, 1, 1}}}};
    ToolSettings clamp;
    clamp.name = "qqclamp";
    clamp.shape = BoxShape{Vec3(0.004, 0.04, 0.04)};
    clamp.clamp = ClampSettings{.jaw_position_m = {0.002, 0, 0}};
    clamp.force_limit_N = 1;
    ReplayMotion replay;
    replay.file = "log.csv";
    replay.time_column = "t";
    replay.where = RowFilter{"s", "ok"};
    replay.opening = DeviceOpening{.axis = DeviceAxis::z, .open_device_m = 0.1, .open_m = 0.1};
    clamp.motion = replay;
    ToolSettings coupled;
    coupled.name = "qqplate";
    coupled.shape = BoxShape{Vec3(0.06, 0.004, 0.06)};
    coupled.coupling =
        CouplingSettings{.mass_kg = 0.05, .stiffness_N_m = 3000, .damping_N_s_m = 20, .force = "qqlaw"};
    coupled.force_limit_N = 1;
    coupled.motion = ScriptMotion{.start_m = Vec3(0, 0.1, 0), .segments = {holds(0.005)}};
    scenario.tools = {clamp, coupled};
    scenario.force = {{.name = "qqlaw", .model = ForceModel::linear_elastic, .coefficients = {.k = 10}},
                      {.name = "qqother", .model = ForceModel::hunt_crossley}};
    scenario.pipelines = {{.name = "full", .pipeline = PipelineKind::fukuhara}};
  }
  ~NamedRun() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(NamedRun, WritesTheKeysOfTheTableAndNoOthers) {
  execute();
  std::set<std::string> written, listed;
  for (const auto& [name, value] : seen.summary)
    if (name.find("qq") != std::string::npos) written.insert(name);
  for (const NamedKey& key : namedSummaryKeys(scenario)) listed.insert(key.key);
  for (const char* law : {"qqlaw", "qqother"})  // only where a force overflows
    EXPECT_EQ(listed.erase(std::string("force_non_finite_at_step_") + law), 1u);
  EXPECT_EQ(written, listed);
  EXPECT_GT(written.size(), 30u);
}

}  // namespace
}  // namespace fissure::summary_keys_test
