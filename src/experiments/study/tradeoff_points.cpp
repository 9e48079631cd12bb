#include "study/tradeoff_points.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "study/tradeoff_file.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_points.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string listText(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return "[" + text + "]";
}

void appendTo(std::vector<std::string>& values, const std::vector<std::string>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

std::size_t StudyPoints::find(const std::string& path) const {
  return static_cast<std::size_t>(std::find(paths.begin(), paths.end(), path) - paths.begin());
}

StudyPoints pointsOf(const AxisGroup& group) {
  SweepSettings sweep;
  sweep.axes = {group};
  const SweepPoints points(sweep);
  StudyPoints found{points.paths(), {}};
  for (std::size_t point = 0; point < points.size(); ++point) {
    std::vector<std::string>& values = found.values.emplace_back();
    for (std::size_t axis = 0; axis < found.paths.size(); ++axis) values.push_back(points.value(point, axis));
  }
  return found;
}

StudyPoints settingsOf(const TradeoffStudy& study) {
  std::vector<StudyPoints> groups;
  double all = 1;
  for (const AxisGroup& group : study.axes) {
    groups.push_back(pointsOf(group));
    all *= static_cast<double>(groups.back().values.size());
  }
  if (study.design == StudyDesign::grid && all > many_sweep_runs)
    throw InputError(inFile(study.file), fmt::format("a grid of {:.0f} settings, expected at most {:.0f}, or "
                                                     "design star",
                                                     all, many_sweep_runs));
  StudyPoints settings;
  for (const StudyPoints& group : groups) appendTo(settings.paths, group.paths);
  const auto add = [&](const std::vector<std::size_t>& chosen) {
    std::vector<std::string>& values = settings.values.emplace_back();
    for (std::size_t g = 0; g < groups.size(); ++g) appendTo(values, groups[g].values[chosen[g]]);
  };
  std::vector<std::size_t> chosen(groups.size(), 0);
  add(chosen);
  if (study.design == StudyDesign::star) {
    for (std::size_t g = 0; g < groups.size(); ++g, std::fill(chosen.begin(), chosen.end(), 0))
      for (chosen[g] = 1; chosen[g] < groups[g].values.size(); ++chosen[g]) add(chosen);
    return settings;
  }
  for (std::size_t g = groups.size(); g > 0;) {  // the last axis is the fastest
    if (++chosen[g - 1] < groups[g - 1].values.size()) {
      add(chosen);
      g = groups.size();
    } else {
      chosen[--g] = 0;
    }
  }
  return settings;
}

StudyPoints rungsOf(const TradeoffStudy& study) {
  StudyPoints rungs = pointsOf(study.reference.ladder);
  for (const AxisGroup& group : study.axes) {
    const StudyPoints of = pointsOf(group);
    for (std::size_t a = 0; a < of.paths.size(); ++a) {
      if (rungs.find(of.paths[a]) < rungs.paths.size()) continue;
      rungs.paths.push_back(of.paths[a]);
      for (std::vector<std::string>& values : rungs.values) values.push_back(of.values.front()[a]);
    }
  }
  return rungs;
}

std::string sweepTextOf(const TradeoffStudy& study, const std::string& name, const std::string& base,
                        const std::vector<std::string>& pipelines, const StudyPoints& points, int repeats) {
  std::string text = fmt::format("format: 1\nname: {}\nbase: {}\nkeep: series\nrepeats: {}\n",
                                 formatText(name), formatText(base), repeats);
  std::vector<std::string> entries;
  for (const std::string& entry : pipelines) entries.push_back(formatText(entry));
  text += fmt::format("pipelines: {}\n", listText(entries));
  std::vector<std::string> limits;
  if (study.limits.time_s) limits.push_back("time_s: " + formatReal(*study.limits.time_s));
  if (study.limits.memory_mib) limits.push_back("memory_mb: " + formatReal(*study.limits.memory_mib));
  if (!limits.empty()) {
    const std::string list = listText(limits);
    text += "limits: {" + list.substr(1, list.size() - 2) + "}\n";
  }
  text += "axes:\n  - zip:\n";
  for (std::size_t axis = 0; axis < points.paths.size(); ++axis) {
    std::vector<std::string> values;
    for (const std::vector<std::string>& point : points.values) values.push_back(point[axis]);
    text +=
        fmt::format("      - {{path: {}, values: {}}}\n", formatText(points.paths[axis]), listText(values));
  }
  return text;
}

}  // namespace fissure
