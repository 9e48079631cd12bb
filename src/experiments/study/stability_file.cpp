#include "study/stability_file.h"

#include <fmt/core.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "base/reproducible.h"
#include "scenario/range_check.h"
#include "scenario/read_nested.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// "maps.axes" of the file, or its nearest existing node above.
Origin originOf(const YamlNode& root, std::size_t map, const std::string& key) {
  return locate(root, fmt::format("maps.{}{}{}", map, key.empty() ? "" : ".", key));
}

void checkRange(const Origin& origin, const StabilityAxis& axis) {
  const AxisRange& range = axis.linear ? *axis.linear : *axis.logarithmic;
  if (range.from == range.to)
    failAt(origin,
           fmt::format("axis {}: from and to are {}, expected a range", axis.path, formatReal(range.from)));
  if (axis.logarithmic && !(range.from > 0 && range.to > 0))
    failAt(origin, fmt::format("axis {} logarithmic: from and to are {} and {}, expected numbers above 0",
                               axis.path, formatReal(range.from), formatReal(range.to)));
}

void checkAxis(const Origin& origin, const StabilityAxis& axis) {
  const int ways = axis.values.has_value() + axis.linear.has_value() + axis.logarithmic.has_value();
  if (ways != 1)
    failAt(origin, fmt::format("axis {} has {} of values, linear and logarithmic, expected one", axis.path,
                               ways > 1 ? "several" : "none"));
  if (!axis.values) return checkRange(origin, axis);
  std::set<std::string> seen;
  for (const std::string& value : *axis.values) {
    if (!seen.insert(plainValue(value)).second)
      failAt(origin, fmt::format("axis {}: {} twice, expected each value once", axis.path, value));
    if (!axis.multiplies.empty() && !toReal(value))
      failAt(origin, fmt::format("axis {}: {}, expected a number, because it multiplies", axis.path, value));
  }
}

void checkMap(const YamlNode& root, const StabilitySettings& study, std::size_t index) {
  const StabilityMap& map = study.maps[index];
  if (map.base.empty() && study.base.empty())
    failAt(originOf(root, index, ""),
           fmt::format("map {} has no base, expected one here or in the study", map.name));
  std::set<std::string> paths;
  for (std::size_t a = 0; a < map.axes.size(); ++a) {
    const Origin origin = originOf(root, index, fmt::format("axes.{}", a));
    checkAxis(origin, map.axes[a]);
    if (!paths.insert(map.axes[a].path).second)
      failAt(origin, fmt::format("a second axis on {}, expected one axis a path", map.axes[a].path));
  }
}

}  // namespace

std::filesystem::path StabilitySettings::baseOf(const StabilityMap& map) const {
  return (directory / (map.base.empty() ? base : map.base)).lexically_normal();
}

StabilityPress StabilitySettings::pressOf(const StabilityMap& map) const {
  const auto either = [](const auto& own, const auto& of_study, auto otherwise) {
    return own ? *own : of_study.value_or(otherwise);
  };
  return {either(map.press.steps, press.steps, StabilityPress::default_steps),
          either(map.press.settle_steps, press.settle_steps, 0),
          either(map.press.rest_share, press.rest_share, StabilityPress::default_rest_share),
          either(map.press.depth_share, press.depth_share, StabilityPress::default_depth_share)};
}

StabilitySettings loadStability(const std::filesystem::path& file) {
  const YamlNode root = parseYaml(readYamlFile(file), inFile(file, 1));
  if (root.kind == YamlNode::Kind::nothing) failAt(inFile(file, 1), "empty, expected a study of stability");
  for (const char* key : {"bodies", "axes"})
    if (const YamlNode* other = root.find(key); other && !root.find("maps"))
      failAt(other->origin, fmt::format("a {} (it has {} and no maps), expected a study of stability",
                                        key == std::string("axes") ? "sweep" : "scenario", key));
  StabilitySettings study;
  readValue(root, "", study);
  requireRanges(root, study);
  std::set<std::string> names;
  for (std::size_t i = 0; i < study.maps.size(); ++i) {
    if (!names.insert(study.maps[i].name).second)
      failAt(originOf(root, i, "name"),
             fmt::format("a second map {}, expected another name", study.maps[i].name));
    checkMap(root, study, i);
  }
  const std::filesystem::path parent = file.parent_path();
  study.directory = parent.empty() ? std::filesystem::path(".") : parent;
  return study;
}

KeyNode stabilityKeys() {
  return keyTree<StabilitySettings>("stability");
}

std::vector<std::string> axisValues(const StabilityAxis& axis) {
  if (axis.values) return *axis.values;
  const AxisRange& range = axis.linear ? *axis.linear : *axis.logarithmic;
  std::vector<std::string> texts;
  for (int i = 0; i < range.count; ++i) {
    const double share = i / static_cast<double>(range.count - 1);
    const double value = axis.linear ? range.from + share * (range.to - range.from)
                                     : range.from * reproducible::pow(range.to / range.from, share);
    const double rounded = *toReal(fmt::format("{:.12g}", value));  // 0.001, not 0.0009999999999999998
    texts.push_back(formatReal(i == 0 ? range.from : i + 1 == range.count ? range.to : rounded));
  }
  return texts;
}

}  // namespace fissure
