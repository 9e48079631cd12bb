#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/key_tree.h"
#include "study/stability_class.h"
#include "study/stability_map.h"
#include "sweep/sweep_file.h"

namespace fissure {

/// The contents of a study file of stability.
struct StabilitySettings {
  int format = 1;
  std::string name;
  std::string description;
  std::string base;
  std::vector<StabilityMap> maps;
  StabilityPress press;
  SweepLimits limits;
  double refine_to = 0.05;
  bool alone = true;
  StabilityCriteria criteria;
  std::filesystem::path directory;  ///< folder of the study file

  /// The scenario file of a map, as it is called from the working directory.
  std::filesystem::path baseOf(const StabilityMap& map) const;
  /// The press of a map, with all values.
  StabilityPress pressOf(const StabilityMap& map) const;
};

/// Reads a study file as strictly as a sweep. Throws InputError with file and line, also for an axis without
/// values, two maps or two axes of a name, an empty range.
StabilitySettings loadStability(const std::filesystem::path& file);

/// The keys of such files.
KeyNode stabilityKeys();

template <class Io>
void describe(Io& io, StabilitySettings& study) {
  io.field("format", study.format, Key("Format of the file.").count(1, 1).required());
  io.field("name", study.name,
           Key("Name of the study and of its folder: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.field("description", study.description, Key("One line that says what the study is for.").mayBeEmpty());
  io.field("base", study.base,
           Key("Scenario of maps that name none, relative to the folder of the study file.")
               .otherwise("each map names its own"));
  io.field("maps", study.maps, Key("Maps of classes, each over one axis or two.").items(1).required());
  io.field("press", study.press, Key("How the tool is led, where a map does not say it."));
  io.field("limits", study.limits, Key("What each cell may take."));
  io.field("refine_to", study.refine_to,
           Key("Boundaries are halved until the cells on both sides differ by at most this share.")
               .noUnit()
               .above(0, 1));
  io.field(
      "alone", study.alone,
      Key("Whether cells that are not stable are also run without their tool, to see whether their tissue "
          "is sound by itself."));
  io.field("criteria", study.criteria, Key("The thresholds of the classes."));
}

}  // namespace fissure
