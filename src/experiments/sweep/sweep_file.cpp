#include "sweep/sweep_file.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "scenario/read_nested.h"
#include "scenario/scenario.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

/// YAML, kept as it was written, to be put into a scenario.
struct YamlTexts {
  std::vector<std::string> texts;
};

/// In the order of SweepDesign.
const std::vector<CatalogEntry>& designs() {
  static const std::vector<CatalogEntry> table = {
      {"grid", "every combination of the values of all axes"},
      {"random", "each axis by itself, evenly distributed"},
      {"latin_hypercube", "random, with every share of each axis hit once"},
      {"sobol", "a Sobol sequence: evenly spread in all axes together"},
  };
  return table;
}

/// In the order of MatchBy.
const std::vector<CatalogEntry>& matches() {
  static const std::vector<CatalogEntry> table = {
      {"time", "at equal times"},
      {"depth", "where the tool has gone as deep since it touched"},
  };
  return table;
}

const std::vector<CatalogEntry>& keeps() {
  static const std::vector<CatalogEntry> table = {
      {"metrics", "the row of the table, and curves"},
      {"results", "besides, the result file of each simulation"},
  };
  return table;
}

}  // namespace

void readValue(const YamlNode& node, const std::string& path, YamlTexts& value) {
  requireList(node, path);
  if (node.children.empty()) failAt(node.origin, path + " is empty, expected at least one value");
  for (const YamlNode& item : node.children) value.texts.push_back(flowText(item));
}

// Not in a namespace of their own: the reader finds them by the types they describe.
template <class Io>
void describe(Io& io, AxisRange& range) {
  io.required("from", range.from);
  io.required("to", range.to);
  io.required("count", range.count);
}

template <class Io>
void readValues(Io& io, std::optional<std::vector<std::string>>& values) {
  std::optional<YamlTexts> read;
  io.field("values", read);
  if (read) values = std::move(read->texts);
}

template <class Io>
void describe(Io& io, SweepAxis& axis) {
  io.required("path", axis.path);
  readValues(io, axis.values);
  io.field("linear", axis.linear);
  io.field("logarithmic", axis.logarithmic);
}

template <class Io>
void describe(Io& io, SweepCondition& condition) {
  io.required("path", condition.path);
  io.field("min", condition.min);
  io.field("max", condition.max);
  readValues(io, condition.values);
}

void readValue(const YamlNode& node, const std::string& path, SweepAxis& axis) {
  MapReader io(node, path);
  describe(io, axis);
  io.finish();
  axis.line = node.origin.line;
}

void readValue(const YamlNode& node, const std::string& path, AxisGroup& group) {
  if (node.kind == YamlNode::Kind::map && node.find("zip")) {
    struct Zip {
      std::vector<SweepAxis> axes;
    } zip;
    MapReader io(node, path);
    io.required("zip", zip.axes);
    io.finish();
    group.axes = std::move(zip.axes);
    return;
  }
  readValue(node, path, group.axes.emplace_back());
}

template <class Io>
void describe(Io& io, SweepCurves& curves) {
  io.required("quantities", curves.quantities);
  io.required("every_s", curves.every_s);
  io.field("until_s", curves.until_s);
}

template <class Io>
void describe(Io& io, SweepFit& fit) {
  io.required("curve", fit.curve);
  io.field("columns", fit.columns);
  io.choice("match", fit.match, matches());
  io.field("law", fit.law);
  io.field("free_offset", fit.free_offset);
}

template <class Io>
void describe(Io& io, SweepLimits& limits) {
  io.field("time_s", limits.time_s);
  io.field("memory_mb", limits.memory_mib);
}

template <class Io>
void describe(Io& io, SweepSettings& sweep) {
  io.required("format", sweep.format);
  io.required("name", sweep.name);
  io.text("description", sweep.description);
  io.required("base", sweep.base);
  io.field("pipelines", sweep.pipelines);
  io.required("axes", sweep.axes);
  io.field("exclude", sweep.exclude);
  io.choice("design", sweep.design, designs());
  const bool sampled = sweep.design != SweepDesign::grid;
  io.fieldIf(sampled, "design random, latin_hypercube or sobol", "count", sweep.count);
  io.fieldIf(sampled, "design random, latin_hypercube or sobol", "seed", sweep.seed);
  io.field("repeats", sweep.repeats);
  io.choice("keep", sweep.keep, keeps());
  io.field("curves", sweep.curves);
  io.field("fit", sweep.fit);
  io.field("limits", sweep.limits);
}

namespace {

class SweepChecker {
 public:
  SweepChecker(const YamlNode& root, const SweepSettings& sweep) : root_(root), sweep_(sweep) {}

  void check() {
    if (sweep_.format != 1)
      failAt(root_.find("format")->origin, "format is " + std::to_string(sweep_.format) + ", expected 1");
    if (!isName(sweep_.name))
      failAt(root_.find("name")->origin,
             "name is \"" + sweep_.name + "\", expected 1 to 64 letters, digits, '_' and '-'");
    const YamlNode& groups = *root_.find("axes");
    if (sweep_.axes.empty()) failAt(groups.origin, "axes is empty, expected at least one");
    for (std::size_t g = 0; g < sweep_.axes.size(); ++g) checkGroup(groups.children[g], sweep_.axes[g]);
    for (std::size_t i = 0; i < sweep_.exclude.size(); ++i)
      for (std::size_t c = 0; c < sweep_.exclude[i].size(); ++c)
        checkCondition(root_.find("exclude")->children[i].children[c], sweep_.exclude[i][c]);
    checkRest();
    if (sweep_.design == SweepDesign::grid) return;
    for (const char* key : {"count", "seed"})
      if (!root_.find(key))
        failAt(root_.find("design")->origin, std::string("needs ") + key + ", expected it");
    if (*sweep_.count < 1)
      failAt(root_.find("count")->origin,
             "count is " + std::to_string(*sweep_.count) + ", expected at least 1");
    if (*sweep_.seed < 0)
      failAt(root_.find("seed")->origin, "seed is " + std::to_string(*sweep_.seed) + ", expected at least 0");
  }

 private:
  static std::size_t length(const SweepAxis& axis) {
    if (axis.values) return axis.values->size();
    return static_cast<std::size_t>(axis.linear ? axis.linear->count : axis.logarithmic->count);
  }

  void checkRest() const {
    const auto expect = [&](bool holds, const char* section, const char* key, double value,
                            const char* expected) {
      if (holds) return;
      const YamlNode* node = root_.find(section);
      if (*key) node = node->find(key);
      failAt(node->origin, std::string(section) + (*key ? "." : "") + key + " is " + formatReal(value) +
                               ", expected " + expected);
    };
    expect(sweep_.repeats >= 1, "repeats", "", sweep_.repeats, "at least 1");
    if (const auto& time_s = sweep_.limits.time_s)
      expect(*time_s > 0, "limits", "time_s", *time_s, "a number above 0");
    if (const auto& memory_mib = sweep_.limits.memory_mib)
      expect(*memory_mib > 0, "limits", "memory_mb", *memory_mib, "a number above 0");
    if (sweep_.fit) checkFit();
    if (!sweep_.curves) return;
    const double every_s = sweep_.curves->every_s;
    expect(every_s > 0, "curves", "every_s", every_s, "a number above 0");
    const double until_s = sweep_.curves->until_s.value_or(every_s);
    expect(until_s >= every_s, "curves", "until_s", until_s, "at least every_s");
    expect(until_s / every_s < 1e6, "curves", "until_s", until_s, "fewer than a million times");
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
               std::string("fit compares the curve ") + needed + ", expected it among curves.quantities");
    }
  }

  void checkGroup(const YamlNode& node, const AxisGroup& group) {
    if (group.axes.empty()) failAt(node.origin, "zip is empty, expected axes");
    for (const SweepAxis& axis : group.axes) checkAxis(node.origin, axis);
    for (const SweepAxis& axis : group.axes) {
      if (length(axis) != length(group.axes.front()))
        failAt(node.origin, axis.path + " has " + std::to_string(length(axis)) + " values and " +
                                group.axes.front().path + " " + std::to_string(length(group.axes.front())) +
                                ", expected as many of zipped axes");
    }
    checkEqual(node.origin, group);
  }

  void checkAxis(const Origin& origin, const SweepAxis& axis) {
    if (!paths_.insert(axis.path).second)
      failAt(origin, "a second axis on " + axis.path + ", expected one axis a path");
    if (axis.values.has_value() + axis.linear.has_value() + axis.logarithmic.has_value() != 1)
      failAt(origin, "axis " + axis.path + " has " +
                         (axis.values || axis.linear || axis.logarithmic ? "several of" : "none of") +
                         " values, linear and logarithmic, expected one");
    if (axis.linear) checkRange(origin, axis.path + " linear", *axis.linear);
    if (!axis.logarithmic) return;
    checkRange(origin, axis.path + " logarithmic", *axis.logarithmic);
    if (!(axis.logarithmic->from > 0 && axis.logarithmic->to > 0))
      failAt(origin, "axis " + axis.path + " logarithmic: from and to are " +
                         formatReal(axis.logarithmic->from) + " and " + formatReal(axis.logarithmic->to) +
                         ", expected numbers above 0");
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
               "axis " + joined([](const SweepAxis& axis) { return axis.path; }) + ": " + written + " is " +
                   same->second + " again, expected each value once");
    }
  }

  static void checkRange(const Origin& origin, const std::string& what, const AxisRange& range) {
    if (range.count < 2)
      failAt(origin, "axis " + what + ": count is " + std::to_string(range.count) + ", expected at least 2");
    if (range.from == range.to)
      failAt(origin, "axis " + what + ": from and to are " + formatReal(range.from) + ", expected a range");
  }

  void checkCondition(const YamlNode& node, const SweepCondition& condition) {
    if (!paths_.contains(condition.path))
      failAt(node.origin, "exclude: " + condition.path + " is no axis, expected the path of one");
    if (condition.values) checkValues(node, condition);
    if (!condition.min && !condition.max && !condition.values)
      failAt(node.origin, "exclude: " + condition.path + " without a condition, expected min, max or values");
  }

  /// A value that the axis never has would exclude nothing, and nobody would notice.
  void checkValues(const YamlNode& node, const SweepCondition& condition) const {
    for (const AxisGroup& group : sweep_.axes) {
      for (const SweepAxis& axis : group.axes) {
        if (axis.path != condition.path) continue;
        if (!axis.values)
          failAt(node.origin, "exclude: axis " + axis.path + " is a range, expected min and max");
        for (const std::string& value : *condition.values)
          if (std::none_of(axis.values->begin(), axis.values->end(),
                           [&](const std::string& other) { return plainValue(value) == plainValue(other); }))
            failAt(node.origin,
                   "exclude: " + value + " is no value of axis " + axis.path + ", expected one of them");
      }
    }
  }

  const YamlNode& root_;
  const SweepSettings& sweep_;
  std::set<std::string> paths_;
};

}  // namespace

std::string designName(SweepDesign design) {
  return std::string(designs()[static_cast<std::size_t>(design)].name);
}

std::string plainValue(const std::string& yaml) {
  const ScalarKind kind = scalarKind(yaml);
  if (kind != ScalarKind::integer && kind != ScalarKind::real) return yaml;
  const std::optional<double> number = toReal(yaml);
  return number ? formatReal(*number) : yaml;
}

SweepSettings loadSweep(const std::filesystem::path& file) {
  SweepSettings sweep;
  sweep.source = readYamlFile(file);
  const YamlNode root = parseYaml(sweep.source, inFile(file, 1));
  if (root.kind == YamlNode::Kind::nothing) failAt(inFile(file, 1), "empty, expected a sweep");
  readValue(root, "", sweep);
  SweepChecker(root, sweep).check();
  const std::filesystem::path parent = file.parent_path();
  sweep.directory = parent.empty() ? std::filesystem::path(".") : parent;
  return sweep;
}

}  // namespace fissure
