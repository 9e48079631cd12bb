#include "sweep/sweep_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "scenario/range_check.h"
#include "scenario/read_nested.h"
#include "scenario/scenario.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

const std::vector<CatalogEntry>& sweepDesigns() {
  static const std::vector<CatalogEntry> table = {
      {"grid", "every combination of the values of all axes"},
      {"random", "each axis by itself, evenly distributed"},
      {"latin_hypercube", "random, with every share of each axis hit once"},
      {"sobol", "a Sobol sequence: evenly spread in all axes together"},
  };
  return table;
}

const std::vector<CatalogEntry>& curveMatches() {
  static const std::vector<CatalogEntry> table = {
      {"time", "at equal times"},
      {"depth", "where the tool has gone as deep since it touched"},
  };
  return table;
}

const std::vector<CatalogEntry>& sweepKeeps() {
  static const std::vector<CatalogEntry> table = {
      {"metrics", "the row of the table, and curves"},
      {"results", "besides, the result file of each simulation"},
      {"series", "besides, the result file of each simulation, without pictures"},
  };
  return table;
}

// Not in a namespace of their own: the reader finds them by the types they read.
void readValue(const YamlNode& node, const std::string& path, SweepAxis& axis) {
  MapReader io(node, path);
  describe(io, axis);
  io.finish();
  axis.line = node.origin.line;
}

void readValue(const YamlNode& node, const std::string& path, AxisGroup& group) {
  if (node.kind == YamlNode::Kind::map && node.find("zip")) {
    group.is_zip = true;
    MapReader io(node, path);
    describe(io, group);
    io.finish();
    return;
  }
  readValue(node, path, group.axes.emplace_back());
}

/// An axis by itself or `zip`, whichever the file has.
void describe(KeyCollector& io, AxisGroup& group) {
  group.is_zip = true;
  describe<KeyCollector>(io, group);
  describe(io, group.axes.emplace_back());
}

namespace {

class SweepChecker {
 public:
  SweepChecker(const YamlNode& root, const SweepSettings& sweep) : root_(root), sweep_(sweep) {}

  void check() {
    checkGroups(root_.find("axes")->children, sweep_.axes);
    for (std::size_t i = 0; i < sweep_.exclude.size(); ++i)
      for (std::size_t c = 0; c < sweep_.exclude[i].size(); ++c)
        checkCondition(root_.find("exclude")->children[i].children[c], sweep_.exclude[i][c]);
    checkRest();
  }

  void checkGroups(const std::vector<YamlNode>& nodes, const std::vector<AxisGroup>& axes) {
    for (std::size_t g = 0; g < axes.size(); ++g) checkGroup(nodes[g], axes[g]);
  }

 private:
  static std::size_t length(const SweepAxis& axis) {
    if (axis.values) return axis.values->size();
    return static_cast<std::size_t>(axis.linear ? axis.linear->count : axis.logarithmic->count);
  }

  void checkRest() const {
    if (sweep_.fit) checkFit();
    if (!sweep_.curves) return;
    const double every_s = sweep_.curves->every_s;
    const double until_s = sweep_.curves->until_s.value_or(every_s);
    const auto expect = [&](bool holds, const char* expected) {
      if (!holds)
        failAt(root_.find("curves")->find("until_s")->origin,
               fmt::format("curves.until_s is {}, expected {}", formatReal(until_s), expected));
    };
    expect(until_s >= every_s, "at least every_s");
    expect(until_s / every_s < 1e6, "fewer than a million times");
  }

  /// What is compared must be kept.
  void checkFit() const {
    const bool by_depth = sweep_.fit->match == MatchBy::depth;
    for (const char* needed : {"force", "indentation"}) {
      if (needed == std::string("indentation") && !by_depth) continue;
      const bool kept =
          sweep_.curves && std::find(sweep_.curves->quantities.begin(), sweep_.curves->quantities.end(),
                                     needed) != sweep_.curves->quantities.end();
      if (!kept)
        failAt(root_.find("fit")->origin,
               fmt::format("fit compares the curve {}, expected it among curves.quantities", needed));
    }
  }

  void checkGroup(const YamlNode& node, const AxisGroup& group) {
    for (const SweepAxis& axis : group.axes) checkAxis(node.origin, axis);
    for (const SweepAxis& axis : group.axes) {
      if (length(axis) != length(group.axes.front()))
        failAt(node.origin,
               fmt::format("{} has {} values and {} {}, expected as many of zipped axes", axis.path,
                           length(axis), group.axes.front().path, length(group.axes.front())));
    }
    checkEqual(node.origin, group);
  }

  void checkAxis(const Origin& origin, const SweepAxis& axis) {
    if (!paths_.insert(axis.path).second)
      failAt(origin, fmt::format("a second axis on {}, expected one axis a path", axis.path));
    if (axis.values.has_value() + axis.linear.has_value() + axis.logarithmic.has_value() != 1)
      failAt(origin, fmt::format("axis {} has {} of values, linear and logarithmic, expected one", axis.path,
                                 axis.values || axis.linear || axis.logarithmic ? "several" : "none"));
    if (axis.linear) checkRange(origin, axis.path + " linear", *axis.linear);
    if (!axis.logarithmic) return;
    checkRange(origin, axis.path + " logarithmic", *axis.logarithmic);
    if (!(axis.logarithmic->from > 0 && axis.logarithmic->to > 0))
      failAt(origin,
             fmt::format("axis {} logarithmic: from and to are {} and {}, expected numbers above 0",
                         axis.path, formatReal(axis.logarithmic->from), formatReal(axis.logarithmic->to)));
  }

  /// Points that are equal would fill a table twice, with one simulation.
  static void checkEqual(const Origin& origin, const AxisGroup& group) {
    const auto joined = [&](const auto& textOf) {
      std::string text;
      for (const SweepAxis& axis : group.axes) text += (text.empty() ? "" : ", ") + textOf(axis);
      return text;
    };
    if (std::any_of(group.axes.begin(), group.axes.end(), [](const SweepAxis& axis) { return !axis.values; }))
      return;  // a range has no equal values
    std::map<std::string, std::string> seen;
    for (std::size_t i = 0; i < length(group.axes.front()); ++i) {
      const std::string written = joined([&](const SweepAxis& axis) { return (*axis.values)[i]; });
      const auto [same, is_new] = seen.try_emplace(
          joined([&](const SweepAxis& axis) { return plainValue((*axis.values)[i]); }), written);
      if (!is_new)
        failAt(inFile(origin.file, group.axes.front().line),
               fmt::format("axis {}: {} is {} again, expected each value once",
                           joined([](const SweepAxis& axis) { return axis.path; }), written, same->second));
    }
  }

  static void checkRange(const Origin& origin, const std::string& what, const AxisRange& range) {
    if (range.from == range.to)
      failAt(origin,
             fmt::format("axis {}: from and to are {}, expected a range", what, formatReal(range.from)));
  }

  void checkCondition(const YamlNode& node, const SweepCondition& condition) {
    if (!paths_.contains(condition.path))
      failAt(node.origin, fmt::format("exclude: {} is no axis, expected the path of one", condition.path));
    if (condition.values) checkValues(node, condition);
    if (!condition.min && !condition.max && !condition.values)
      failAt(node.origin,
             fmt::format("exclude: {} without a condition, expected min, max or values", condition.path));
  }

  /// A value that the axis never has would exclude nothing, and nobody would notice.
  void checkValues(const YamlNode& node, const SweepCondition& condition) const {
    for (const AxisGroup& group : sweep_.axes) {
      for (const SweepAxis& axis : group.axes) {
        if (axis.path != condition.path) continue;
        if (!axis.values)
          failAt(node.origin, fmt::format("exclude: axis {} is a range, expected min and max", axis.path));
        for (const std::string& value : *condition.values)
          if (std::none_of(axis.values->begin(), axis.values->end(),
                           [&](const std::string& other) { return plainValue(value) == plainValue(other); }))
            failAt(node.origin,
                   fmt::format("exclude: {} is no value of axis {}, expected one of them", value, axis.path));
      }
    }
  }

  const YamlNode& root_;
  const SweepSettings& sweep_;
  std::set<std::string> paths_;
};

}  // namespace

void checkAxisGroups(const std::vector<YamlNode>& nodes, const std::vector<AxisGroup>& axes) {
  const YamlNode nothing;
  const SweepSettings none;
  SweepChecker(nothing, none).checkGroups(nodes, axes);
}

std::string designName(SweepDesign design) {
  return std::string(sweepDesigns()[static_cast<std::size_t>(design)].name);
}

std::string plainValue(const std::string& yaml) {
  const ScalarKind kind = scalarKind(yaml);
  if (kind != ScalarKind::integer && kind != ScalarKind::real) return yaml;
  const std::optional<double> number = toReal(yaml);
  return number ? formatReal(*number) : yaml;
}

bool isSweepFile(const std::filesystem::path& file) {
  const YamlNode root = parseYaml(readYamlFile(file), inFile(file, 1));
  return root.kind == YamlNode::Kind::map && root.find("axes") != nullptr;
}

SweepSettings loadSweep(const std::filesystem::path& file) {
  SweepSettings sweep;
  sweep.source = readYamlFile(file);
  const YamlNode root = parseYaml(sweep.source, inFile(file, 1));
  if (root.kind == YamlNode::Kind::nothing) failAt(inFile(file, 1), "empty, expected a sweep");
  for (const char* key : {"bodies", "tools", "time", "force"})
    if (const YamlNode* of_scenario = root.find(key); of_scenario && !root.find("axes"))
      failAt(of_scenario->origin,
             fmt::format("a scenario (it has {} and no axes), expected a sweep; type: fissure run {}", key,
                         file.string()));
  if (const YamlNode* of_study = root.find("reference"))
    failAt(of_study->origin,
           fmt::format("a study (it has a reference), expected a sweep; type: fissure study tradeoff {}",
                       file.string()));
  readValue(root, "", sweep);
  requireRanges(root, sweep);
  SweepChecker(root, sweep).check();
  const std::filesystem::path parent = file.parent_path();
  sweep.directory = parent.empty() ? std::filesystem::path(".") : parent;
  return sweep;
}

KeyNode sweepKeys() {
  return keyTree<SweepSettings>("sweep");
}

}  // namespace fissure
