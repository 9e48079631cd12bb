#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenario/key.h"
#include "sweep/sweep_axes.h"

namespace fissure {

/// One axis of a map. Exactly one of the three optional members is set.
struct StabilityAxis {
  std::string path;
  std::vector<std::string> multiplies;
  std::optional<std::vector<std::string>> values;  ///< each as YAML
  std::optional<AxisRange> linear;
  std::optional<AxisRange> logarithmic;
};

/// How the tool of a cell is led: it comes from a gap before the tissue, is pressed in and rests. Settings
/// that a map leaves out are those of the study.
struct StabilityPress {
  std::optional<int> steps;
  std::optional<int> settle_steps;
  std::optional<double> rest_share;
  std::optional<double> depth_share;

  static constexpr int default_steps = 200;
  static constexpr double default_rest_share = 0.4;
  static constexpr double default_depth_share = 0.1;
};

/// A map: a scenario at the points of one or two axes, through some pipelines.
struct StabilityMap {
  std::string name;
  std::string description;
  std::string base;
  std::vector<std::string> pipelines;
  std::vector<StabilityAxis> axes;
  StabilityPress press;
  std::optional<double> time_s;
};

/// The values of an axis: those written, or those of its range, both ends included.
std::vector<std::string> axisValues(const StabilityAxis& axis);

template <class Io>
void describe(Io& io, StabilityAxis& axis) {
  const char* const one = "one of `values`, `linear` and `logarithmic` is required";
  io.field("path", axis.path,
           Key("Place in the scenario that the axis changes, as for `--set`; `*` in place of an entry of "
               "`pipelines` is the map's pipeline. With `multiplies` a name for people.")
               .required());
  io.field("multiplies", axis.multiplies,
           Key("Places whose values in the scenario, numbers or lists of numbers, are multiplied by the axis "
               "instead."));
  describeValues(
      io, axis.values,
      Key("The values, of any kind that the place takes, each once. Nothing is refined between them.")
          .noUnit()
          .items(1, any_number)
          .otherwise(one));
  describeRanges(io, axis, one);
}

template <class Io>
void describe(Io& io, StabilityPress& press) {
  const char* const of_study = "that of the study";
  io.field("steps", press.steps,
           Key("Steps of a cell, whatever their length. The way of the tool is what it goes at its speed in "
               "those in which it does not rest, at most to its depth.")
               .count(50)
               .otherwise(std::string(of_study) + ", 200 there"));
  io.field("settle_steps", press.settle_steps,
           Key("Steps before, in which tissue comes to rest.")
               .count(0)
               .otherwise(std::string(of_study) + ", 0 there"));
  io.field("rest_share", press.rest_share,
           Key("Share of the steps in which the tool rests at the end.")
               .noUnit()
               .between(0.2, 0.9)
               .otherwise(std::string(of_study) + ", 0.4 there"));
  io.field("depth_share", press.depth_share,
           Key("Depth to which the tool is pressed, as a share of the tissue's length along its way. It "
               "comes from "
               "a tenth of that before the tissue, or from a quarter of its way where that is less.")
               .noUnit()
               .above(0, 3)
               .otherwise(std::string(of_study) + ", 0.1 there"));
}

template <class Io>
void describe(Io& io, StabilityMap& map) {
  io.field(
      "name", map.name,
      Key("Name of the map and of its folder: 1 to 64 letters, digits, '_' and '-'.").itemName().required());
  io.field("description", map.description, Key("One line that says what the map asks.").mayBeEmpty());
  io.field(
      "base", map.base,
      Key("Scenario file whose places the axes change, relative to the folder of the study file. It has one "
          "tool, whose motion is a script that begins with a move at a speed.")
          .otherwise("that of the study"));
  io.field("pipelines", map.pipelines, Key("Names of the scenario's runs that are made; empty for all."));
  io.field("axes", map.axes,
           Key("One axis or two. Boundaries between classes are looked for along the last one.")
               .items(1, 2)
               .required());
  io.field("press", map.press, Key("How the tool is led."));
  io.field("time_s", map.time_s,
           Key("Wall-clock time that a cell may take.").above(0).otherwise("what `limits` says"));
}

}  // namespace fissure
