#include "sweep/sweep_manifest.h"
#include "sweep/sweep_plan.h"
#include "target.h"

namespace fissure::fuzz {

/// A manifest that is accepted is written and read as the same one, and its plan has runs that all can be
/// told.
void takeManifest(const std::string& bytes) {
  const std::filesystem::path file = put("sweep/manifest.json", bytes);
  const std::filesystem::path folder = file.parent_path();
  SweepManifest manifest;
  if (!accepts(file, Refusal::file, [&] { manifest = readManifest(folder); })) return;
  const std::string text = manifestText(manifest);
  put("sweep/manifest.json", text);
  require(manifestText(readManifest(folder)) == text, "a manifest reads back");
  accepts("", Refusal::file, [&] {
    const SweepPlan plan(manifest, folder);
    require(plan.runs() > 0 && !plan.tasks().empty(), "a plan has runs");
    for (const SweepTask& task : plan.tasks()) {
      plan.overrides(task);
      plan.precision(task);
      for (const std::size_t point : task.laws) plan.lawsAt(point);
    }
    for (std::size_t i = 0; i < plan.runs(); ++i)
      require(plan.run(i).task < plan.tasks().size(), "a run has a task");
  });
}

}  // namespace fissure::fuzz
