#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenario/key.h"
#include "scenario/key_tree.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// `count` numbers from `from` to `to`, both included, with equal differences or equal factors.
struct AxisRange {
  double from = 0;
  double to = 0;
  int count = 0;
};

/// The values of one key of the scenario. Exactly one of the three optional members is set.
struct SweepAxis {
  std::string path;
  std::optional<std::vector<std::string>> values;  ///< each as YAML
  std::optional<AxisRange> linear;
  std::optional<AxisRange> logarithmic;
  int line = 0;  ///< line of the sweep file
};

/// Axes whose values are varied together, index by index. A single axis is a group of one.
struct AxisGroup {
  std::vector<SweepAxis> axes;  ///< axes with equal numbers of values
  bool is_zip = false;          ///< written as `zip` in the file
};

/// A condition on the value of one axis; all members that are set must hold.
struct SweepCondition {
  std::string path;
  std::optional<double> min, max;
  std::optional<std::vector<std::string>> values;  ///< the value must be one of these, as YAML
};

/// Readers of axes and groups, for files that have them: a group is an axis by itself or `zip`.
void readValue(const YamlNode& node, const std::string& path, SweepAxis& axis);
void readValue(const YamlNode& node, const std::string& path, AxisGroup& group);
void describe(KeyCollector& io, AxisGroup& group);

/// Refuses an empty range, equal values of an axis, two axes on a path and zipped axes of unequal lengths.
/// `nodes`: those from which the groups were read. Throws InputError with file and line.
void checkAxisGroups(const std::vector<YamlNode>& nodes, const std::vector<AxisGroup>& axes);

template <class Io>
void describe(Io& io, AxisRange& range) {
  io.field("from", range.from,
           Key("First value, one of the values.").unit("the unit of the place").required());
  io.field("to", range.to,
           Key("Last value, one of the values; another one than `from`.")
               .unit("the unit of the place")
               .required());
  io.field(
      "count", range.count,
      Key("How many values a grid takes; other designs take any number in between.").count(2).required());
}

/// Describes the key `values`, a list of values of any kind, which are kept as YAML.
template <class Io>
void describeValues(Io& io, std::optional<std::vector<std::string>>& values, const Key& key) {
  std::optional<std::vector<AnyValue>> list;
  if (values) list.emplace();
  for (std::size_t i = 0; values && i < values->size(); ++i) list->push_back({(*values)[i]});
  io.field("values", list, key);
  if (!list) return;
  values.emplace();
  for (AnyValue& value : *list) values->push_back(std::move(value.yaml));
}

/// The keys of the ranges of an axis, of which it has at most one; `one` says what is required without them.
template <class Io, class Axis>
void describeRanges(Io& io, Axis& axis, const char* one) {
  io.field("linear", axis.linear, Key("Evenly spaced numbers.").otherwise(one));
  io.field("logarithmic", axis.logarithmic,
           Key("Numbers by equal factors; both ends are above 0.").otherwise(one));
}

template <class Io>
void describe(Io& io, SweepAxis& axis) {
  const char* const one = "one of `values`, `linear` and `logarithmic` is required";
  io.field("path", axis.path,
           Key("Place in the scenario that the axis changes, as for `--set`; list items by name or index.")
               .required());
  describeValues(io, axis.values,
                 Key("The values, of any kind that the place takes, each once.")
                     .noUnit()
                     .items(1, any_number)
                     .otherwise(one));
  describeRanges(io, axis, one);
}

template <class Io>
void describe(Io& io, AxisGroup& group) {
  if (!group.is_zip) return describe(io, group.axes.front());
  io.field("zip", group.axes,
           Key("Axes whose values go together, side by side: as many values of each.")
               .items(1, any_number)
               .otherwise("the axis stands by itself")
               .alone());
}

template <class Io>
void describe(Io& io, SweepCondition& condition) {
  const char* const one = "one of `min`, `max` and `values` is required";
  io.field("path", condition.path, Key("Path of an axis.").required());
  io.field("min", condition.min,
           Key("The axis has this value or a larger one.").unit("the unit of the place").otherwise(one));
  io.field("max", condition.max,
           Key("The axis has this value or a smaller one.").unit("the unit of the place").otherwise(one));
  describeValues(io, condition.values,
                 Key("The axis has one of these values, each of them a value of the axis.")
                     .noUnit()
                     .items(1, any_number)
                     .otherwise(one));
}

}  // namespace fissure
