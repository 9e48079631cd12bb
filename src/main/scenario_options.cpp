#include "main/scenario_options.h"

namespace fissure {

void addScenarioOptions(CLI::App& command, ScenarioOptions& options) {
  command.add_option("SCENARIO", options.files, "scenario files")->required();
  command.add_option("--pipeline", options.pipelines, "only the runs of this name; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--set", options.overrides, "path=value: override one value; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--no-expect", options.no_expect, "check none of the values that the scenario expects");
  command.add_flag("--no-frames", options.no_frames, "draw no pictures, whatever the scenario says");
}

}  // namespace fissure
