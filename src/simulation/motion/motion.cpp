#include "motion/motion.h"

#include "motion/replayed_motion.h"
#include "motion/scripted_motion.h"

namespace fissure {
namespace {

std::unique_ptr<Motion> make(const ScriptMotion& settings, const std::filesystem::path&,
                             const std::string& where, const LogFiles&) {
  return std::make_unique<ScriptedMotion>(settings, where);
}

std::unique_ptr<Motion> make(const ReplayMotion& settings, const std::filesystem::path& directory,
                             const std::string& where, const LogFiles& files) {
  return std::make_unique<ReplayedMotion>(settings, directory, where, files);
}

}  // namespace

MotionPeaks peaksOf(const Motion& motion, double step_s, std::int64_t steps) {
  MotionPeaks peaks(step_s);
  for (std::int64_t step = 0; step <= steps; ++step)
    peaks.add(motion.poseAt(static_cast<double>(step) * step_s).position_m);
  return peaks;
}

std::unique_ptr<Motion> makeMotion(const ToolSettings& tool, const std::filesystem::path& directory,
                                   const LogFiles& files) {
  const std::string where = "tools." + tool.name + ".motion";
  return std::visit([&](const auto& settings) { return make(settings, directory, where, files); },
                    tool.motion);
}

}  // namespace fissure
