#include "study/stability_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "check/scenario_input.h"
#include "scenario/compose.h"
#include "scene/prepared_scenario.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string vectorText(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", formatReal(v.x()), formatReal(v.y()), formatReal(v.z()));
}

/// The first and last place of points along a direction.
struct Extent {
  double first_m = std::numeric_limits<double>::infinity();
  double last_m = -std::numeric_limits<double>::infinity();

  void add(double place_m) {
    first_m = std::min(first_m, place_m);
    last_m = std::max(last_m, place_m);
  }
};

const ScriptMotion& motionOf(const Scenario& scenario) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(
        fmt::format("{} {}, expected one tool whose motion is a script that begins with a move at a speed",
                    scenario.name, found));
  };
  if (scenario.tools.size() != 1 || scenario.tools[0].clamp) refuse("has not one rigid tool");
  const auto* motion = std::get_if<ScriptMotion>(&scenario.tools[0].motion);
  if (!motion) refuse("replays a log");
  if (motion->segments.empty() || !motion->segments[0].move_to_m || !motion->segments[0].speed_m_s)
    refuse("begins with another segment");
  if ((*motion->segments[0].move_to_m - motion->start_m).norm() == 0)
    refuse("begins with a move to where it is");
  return *motion;
}

double shortestSide_m(const TriangleMesh& surface) {
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (const Vec3& vertex : surface.vertices_m) {
    least = least.cwiseMin(vertex);
    most = most.cwiseMax(vertex);
  }
  return (most - least).minCoeff();
}

/// The places of laws whose coefficients an axis changes: such a scenario is simulated for itself, so that
/// its own result shows what its laws say.
std::vector<std::string> lawsChanged(const std::vector<Override>& overrides) {
  std::vector<std::string> laws;
  for (const Override& change : overrides) {
    const std::vector<std::string> parts = splitPath(change.path);
    if (parts.size() != 3 || parts[0] != "force") continue;
    if (std::find(laws.begin(), laws.end(), parts[1]) == laws.end()) laws.push_back(parts[1]);
  }
  return laws;
}

}  // namespace

std::string multiplied(const YamlNode& value, double factor) {
  if (value.kind == YamlNode::Kind::list) {
    std::vector<std::string> items;
    for (const YamlNode& item : value.children) items.push_back(multiplied(item, factor));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  const std::optional<double> number =
      value.kind == YamlNode::Kind::scalar ? toReal(value.text) : std::nullopt;
  if (!number) failAt(value.origin, "no number, expected one, because an axis multiplies it");
  return formatReal(*number * factor);
}

StabilityCells::StabilityCells(const LoadedScenario& base, const std::filesystem::path& file,
                               const StabilityMap& map, const StabilityPress& press,
                               const std::string& pipeline)
    : base_(base), file_(file), map_(map), press_(press), pipeline_(pipeline) {}

std::vector<Override> StabilityCells::axisOverrides(const std::vector<std::string>& values) const {
  std::vector<Override> overrides;
  for (std::size_t a = 0; a < map_.axes.size(); ++a) {
    const StabilityAxis& axis = map_.axes[a];
    if (axis.multiplies.empty()) {
      std::string path = axis.path;
      if (const std::size_t star = path.find(".*."); star != std::string::npos)
        path.replace(star + 1, 1, pipeline_);
      overrides.push_back({path, values[a]});
      continue;
    }
    YamlNode root = parseYaml(base_.resolved, inFile(file_, 1));
    for (const std::string& path : axis.multiplies) {
      const YamlNode* node = findNode(root, path);
      if (!node)
        throw InputError(inFile(file_),
                         fmt::format("has no {}, expected what axis {} multiplies", path, axis.path));
      overrides.push_back({path, multiplied(*node, *toReal(values[a]))});
    }
  }
  return overrides;
}

StabilityCell StabilityCells::cell(const std::vector<std::string>& values) const {
  StabilityCell cell;
  cell.values = values;
  cell.overrides = axisOverrides(values);
  for (const std::string& law : lawsChanged(cell.overrides))
    for (const ForceSettings& own : base_.scenario.force)
      if (own.name == law)
        cell.overrides.push_back({fmt::format("force.{}.model", law), std::string(entryOf(own.model).name)});
  try {
    addTimes(cell);
    leadTool(cell);
    cell.refused = refusalOf(cell);
  } catch (const InputError& error) {
    std::string point;
    for (std::size_t a = 0; a < values.size(); ++a)
      point += fmt::format(", {}={}", map_.axes[a].path, values[a]);
    throw InputError(error.origin(),
                     fmt::format("{} (map {}, pipeline {}{})", error.text(), map_.name, pipeline_, point));
  }
  return cell;
}

bool StabilityCells::lastAxisIsWhole() const {
  if (map_.axes.back().values || !map_.axes.back().multiplies.empty()) return false;
  std::vector<std::string> values;
  for (const StabilityAxis& axis : map_.axes) values.push_back(axisValues(axis).front());
  const auto isTaken = [&](const std::string& value) {
    values.back() = value;
    try {
      parseScenario(base_.composed, file_, axisOverrides(values));
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  // A place inside the range that no range check minds.
  const std::vector<std::string> ends = axisValues(map_.axes.back());
  const double first = *toReal(ends[0]), second = *toReal(ends[1]);
  double between = first + 0.37 * (second - first);
  if (between == std::round(between)) between += second > first ? 0.5 : -0.5;
  return isTaken(ends[0]) && !isTaken(formatReal(between));
}

/// What is valid in every value may still be refused as a whole.
std::string StabilityCells::refusalOf(const StabilityCell& cell) const {
  LoadedScenario loaded = parseScenario(base_.composed, file_, cell.overrides);
  try {
    checkLoaded(file_, std::move(loaded), {{pipeline_}, {}, false, false});
    return {};
  } catch (const InputError& error) {
    return error.text();
  }
}

/// Steps are counted, however long they are; what is recorded at times of its own is left out.
void StabilityCells::addTimes(StabilityCell& cell) const {
  cell.step_s = base_.scenario.time.step_s;
  for (const Override& change : cell.overrides) {
    if (change.path != "time.step_s") continue;
    const std::optional<double> step_s = toReal(change.value);
    if (!step_s || !(*step_s > 0))
      throw InputError(ofAxis(change.path), change.value + ", expected a number above 0");
    cell.step_s = *step_s;
  }
  cell.overrides.push_back({"time.settle_s", formatReal(*press_.settle_steps * cell.step_s)});
  cell.overrides.push_back({"time.duration_s", formatReal(*press_.steps * cell.step_s)});
  cell.overrides.push_back({"record", "{}"});
  cell.overrides.push_back({"measure.every", "1"});
}

void StabilityCells::leadTool(StabilityCell& cell) const {
  const Scenario scenario = parseScenario(base_.composed, file_, cell.overrides).scenario;
  const ScriptMotion& motion = motionOf(scenario);
  const MotionSegment& press = motion.segments[0];
  const PreparedScenario prepared = prepareScenario(scenario, false);
  const Vec3 direction = (*press.move_to_m - motion.start_m).normalized();
  Extent tissue, tool;
  for (const SceneBody& body : prepared.scene.bodies)
    for (const Vec3& vertex : body.rest.vertices_m) tissue.add(direction.dot(vertex));
  for (const Vec3& vertex : prepared.scene.tools[0].surface.vertices_m)
    tool.add(direction.dot(motion.start_orientation * vertex));

  const double step_s = cell.step_s, speed_m_s = *press.speed_m_s;
  const int steps = *press_.steps;
  const double led_steps = std::floor(steps * (1 - *press_.rest_share));
  const double depth_m = *press_.depth_share * (tissue.last_m - tissue.first_m);
  const double longest_m = speed_m_s * step_s * led_steps;
  const double gap_m = std::min(depth_m / 10, longest_m / 4);
  const double way_m = std::min(gap_m + depth_m, longest_m);
  const Vec3 aside = motion.start_m - direction * direction.dot(motion.start_m);
  const Vec3 start = aside + direction * (tissue.first_m - tool.last_m - gap_m);
  const Vec3 end = start + direction * way_m;
  const auto& turn = motion.start_orientation;
  const std::string& name = scenario.tools[0].name;
  cell.thickness_m = shortestSide_m(prepared.scene.tools[0].surface);
  cell.rest_from = static_cast<std::size_t>(std::ceil(way_m / speed_m_s / step_s)) + 1;
  // What an axis says of the motion is in the new one.
  std::erase_if(cell.overrides, [](const Override& change) {
    const std::vector<std::string> parts = splitPath(change.path);
    return parts.size() > 2 && parts[0] == "tools" && parts[2] == "motion";
  });
  cell.overrides.push_back(
      {fmt::format("tools.{}.motion", name),
       fmt::format(
           "{{type: script, start_m: {}, start_orientation: [{}, {}, {}, {}], segments: [{{move_to_m: {}, "
           "speed_m_s: {}, timing: constant}}, {{hold_s: {}}}]}}",
           vectorText(start), formatReal(turn.x()), formatReal(turn.y()), formatReal(turn.z()),
           formatReal(turn.w()), vectorText(end), formatReal(speed_m_s), formatReal(steps * step_s))});
}

}  // namespace fissure
