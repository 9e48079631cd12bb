#include "base/error.h"
#include "scenario/load.h"
#include "target.h"

namespace fissure::fuzz {

/// A scenario that is accepted is the same when its text with all defaults, or the one merged with its bases,
/// is read.
void takeScenario(const std::string& bytes) {
  // Names of meshes and logs start from configs/; the file itself is not looked for.
  const std::filesystem::path file = house() / "configs/fuzzed.yaml";
  LoadedScenario loaded;
  if (!accepts(file.parent_path(), Refusal::line, [&] { loaded = parseScenario(bytes, file); })) return;
  const auto readsBack = [&](const std::string& text) {
    try {
      const LoadedScenario again = parseScenario(text, file);
      require(again.scenario == loaded.scenario, "a written scenario reads back: " + text);
      require(again.resolved == loaded.resolved,
              "a scenario that was read back is written the same: " + text);
    } catch (const InputError& error) {
      require(false, error.what() + (" refuses what was written: " + text));
    }
  };
  readsBack(loaded.resolved);
  readsBack(loaded.composed);
  require(parseStoredScenario(loaded.resolved, "result.h5").scenario.bodies.size() ==
              loaded.scenario.bodies.size(),
          "a stored scenario is read without its files");
}

}  // namespace fissure::fuzz
