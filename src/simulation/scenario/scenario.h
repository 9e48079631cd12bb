#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/bodies.h"
#include "scenario/forces.h"
#include "scenario/pipelines.h"
#include "scenario/record.h"
#include "scenario/surroundings.h"
#include "scenario/tools.h"

namespace fissure {

/// A scenario: what is simulated, with which pipelines, and what is recorded. Plain data with all defaults.
struct Scenario {
  int format = 1;
  std::string name;
  std::string description;
  TimeSettings time;
  WorldSettings world;
  std::optional<GroundSettings> ground;
  std::vector<BodySettings> bodies;
  std::vector<ToolSettings> tools;
  std::vector<PipelineSettings> pipelines;
  std::vector<ForceSettings> force;
  RecordSettings record;
  MeasureSettings measure;
  std::vector<Expectation> expect;

  /// The folder from which relative file names of this scenario start. No key of the file.
  std::filesystem::path directory = ".";

  bool operator==(const Scenario&) const = default;
};

template <class Io>
void describe(Io& io, Scenario& s) {
  io.field("format", s.format, Key("Format of the file.").count(1, 1).required());
  io.field("name", s.name,
           Key("Name of the scenario and of its result file: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.field("description", s.description, Key("One line that says what the scenario shows.").mayBeEmpty());
  io.field("time", s.time, Key("Step and duration."));
  io.field("world", s.world, Key("What surrounds the bodies: gravity and air."));
  io.field("ground", s.ground,
           Key("A horizontal ground under the tissue; {} takes its defaults.").otherwise("no ground"));
  io.field("bodies", s.bodies, Key("Soft bodies: the tissue.").items(1).required());
  io.field("tools", s.tools, Key("Rigid tools and clamps.").items(0));
  io.field("pipelines", s.pipelines,
           Key("Collision pipelines: each entry is one run, in a process of its own.").items(1).required());
  io.field("force", s.force, Key("Force laws, all evaluated in every run.").items(0));
  io.field("record", s.record, Key("What a result keeps beside its series and summary."));
  io.field("measure", s.measure, Key("How penetration is measured and proved."));
  io.field("expect", s.expect,
           Key("What the summaries must say, checked after every run; where it does not hold the exit code "
               "is 1."));
}

/// Whether `text` can name a scenario or an item of it: 1 to 64 letters, digits, '_' and '-' (ASCII).
bool isName(std::string_view text);

/// The largest number of recorded steps, and of settling steps.
constexpr double max_steps = 1e8;

/// An error in a scenario. `path` leads to the value by keys and names or indices of items, as
/// `tools.spatula.shape.size_m` or `pipelines.0.sweeps`.
struct Problem {
  std::string path;
  std::string message;                   ///< what is wrong and what was expected
  std::vector<std::string> others = {};  ///< paths of further values that it concerns
};

/// Checks all values, and all relations between them that can be checked without reading files. Returns the
/// problems; none: the scenario can be run.
std::vector<Problem> validate(const Scenario& scenario);
/// The same for the settings of pictures, with paths as `camera.up`.
std::vector<Problem> validate(const FrameSettings& frames);

}  // namespace fissure
