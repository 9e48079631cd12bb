#include "sweep/plan_text.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/counted.h"
#include "sweep/idle_axis.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string axisText(const SweepPoints& points, std::size_t axis) {
  std::set<std::string> texts;
  std::optional<double> least, most;
  bool numeric = true;
  for (std::size_t point = 0; point < points.size(); ++point) {
    const std::string& text = points.value(point, axis);
    texts.insert(text);
    const std::optional<double> number = toReal(text);
    numeric &= number.has_value();
    if (!number) continue;
    least = std::min(least.value_or(*number), *number);
    most = std::max(most.value_or(*number), *number);
  }
  std::string text = "  " + points.paths()[axis] + ": " + counted(texts.size(), "value");
  if (numeric) return text + ", " + formatReal(*least) + " to " + formatReal(*most);
  if (texts.size() > 6) return text;
  text += ":";
  for (const std::string& value : texts) text += " " + value;
  return text;
}

}  // namespace

std::string planText(const SweepPlan& plan) {
  const SweepManifest& manifest = plan.manifest();
  std::string text = "sweep " + manifest.settings.name + ": " + counted(manifest.points.size(), "point") +
                     " x " + counted(manifest.pipelines.size(), "pipeline");
  if (manifest.settings.repeats > 1) text += " x " + std::to_string(manifest.settings.repeats) + " repeats";
  text += " = " + counted(plan.runs(), "run") + " in " + counted(plan.tasks().size(), "simulation") + "\n";
  for (std::size_t a = 0; a < manifest.points.paths().size(); ++a) {
    text += axisText(manifest.points, a) + (plan.isLawAxis(a) ? " (moves nothing)" : "") + "\n";
    if (const std::string reason = idleReason(plan, a); !reason.empty())
      text += "    warning: changes nothing in any run: " + reason + "\n";
  }
  return text;
}

std::string valuesText(const SweepPlan& plan, const SweepTask& task) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const Override& value : plan.overrides(task)) add(value.path + "=" + value.value);
  if (task.laws.size() > 1) add(counted(task.laws.size(), "set") + " of force laws");
  if (plan.manifest().settings.repeats > 1) add("repeat " + std::to_string(task.repeat));
  return text;
}

}  // namespace fissure
