#include "main/scenario_options.h"

namespace fissure {

void addScenarioOptions(Command command, ScenarioOptions& options) {
  command.option("SCENARIO", options.files, "scenario files").required();
  command.option("--pipeline", options.pipelines, "only the runs of this name; may be repeated").repeated();
  command.option("--set", options.overrides, "path=value: override one value; may be repeated").repeated();
  command.flag("--no-expect", options.no_expect, "check none of the values that the scenario expects");
  command.flag("--no-frames", options.no_frames, "draw no pictures, whatever the scenario says");
}

}  // namespace fissure
