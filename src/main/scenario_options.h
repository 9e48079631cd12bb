#pragma once

#include <string>
#include <vector>

#include "check/scenario_input.h"
#include "main/command.h"

namespace fissure {

/// The options of all verbs that take scenarios.
struct ScenarioOptions {
  std::vector<std::string> files;
  std::vector<std::string> pipelines;
  std::vector<std::string> overrides;
  bool no_frames = false;
  bool no_expect = false;

  Selection selection() const { return {pipelines, overrides, !no_frames, !no_expect}; }
};

/// Adds SCENARIO..., --pipeline, --set, --no-frames and --no-expect; `options` must outlive `command`.
void addScenarioOptions(Command command, ScenarioOptions& options);

}  // namespace fissure
