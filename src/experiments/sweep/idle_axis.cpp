#include "sweep/idle_axis.h"

#include <algorithm>

#include "scenario/compose.h"

namespace fissure {

namespace {

/// Whether one of the runs is so, or may become so by an axis that chooses its pipeline.
template <class IsSo>
bool someRun(const SweepPlan& plan, IsSo isSo) {
  const SweepManifest& manifest = plan.manifest();
  const std::vector<std::string>& paths = manifest.points.paths();
  if (std::any_of(paths.begin(), paths.end(), [](const auto& path) { return path.ends_with(".pipeline"); }))
    return true;
  for (std::size_t entry = 0; entry < manifest.pipelines.size(); ++entry)
    if (isSo(plan.entry(entry))) return true;
  return false;
}

}  // namespace

std::string idleReason(const SweepPlan& plan, std::size_t axis) {
  const std::vector<std::string> parts = splitPath(plan.manifest().points.paths()[axis]);
  const std::string third = parts.size() > 2 ? parts[2] : "";
  if (parts[0] == "record") return "it says what is recorded, not what happens";
  if (parts[0] == "pipelines" && third == "time_limit_s") return "it only ends runs that take longer";
  if (parts[0] == "tools" && third == "nodes" &&
      !someRun(plan, [](const PipelineSettings& run) { return run.usesNodes(); }))
    return "no run has nodes";
  if (parts[0] == "tools" && third == "clamp" && parts.size() > 3 && parts[3] == "handle")
    return "handles are drawn and touch nothing";
  const std::vector<BodySettings>& bodies = plan.base().scenario.bodies;
  const bool meet = std::any_of(bodies.begin(), bodies.end(), [](const BodySettings& body) {
    return body.soft_contact == SoftContact::clusters;
  });
  if (parts[0] == "bodies" && third == "clusters" && !meet &&
      !someRun(plan, [](const PipelineSettings& run) { return run.usesClusters(); }))
    return "no run has clusters";
  return "";
}

}  // namespace fissure
