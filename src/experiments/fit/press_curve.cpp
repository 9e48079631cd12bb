#include "fit/press_curve.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/error.h"
#include "base/geometry.h"
#include "fit/curve_rank.h"
#include "fit/simulated_model.h"
#include "scenario/catalog.h"
#include "scenario/load.h"
#include "store/result_file.h"
#include "store/run_reader.h"
#include "text/units.h"

namespace fissure {

namespace {

/// Most kinetic energy and viscous loss of a press that counts as slow, as a share of its stored energy.
constexpr double kMostLostShare = 0.03;

std::vector<double> seriesOf(const RunReader& reader, const std::string& name, std::size_t columns) {
  const StoredQuantity* quantity = reader.find(name);
  if (quantity == nullptr || quantity->row_axis != "time" || quantity->columns() != columns)
    throw InputError(inFile(reader.file()),
                     fmt::format("no series {} of {} a step, expected the result of a run with a tool", name,
                                 counted(columns, "number")));
  return reader.all(*quantity);
}

/// What does not scale with the modulus, or keeps its share of it.
void noteWhatDoesNotScale(const Scenario& scenario, const RunReader& reader, PressCurve& press) {
  const BodySettings& body = scenario.bodies.front();
  if (!body.elastic.regions.empty())
    press.notes.push_back(
        "E is that of the body outside of its regions, whose moduli keep their ratio to it");
  if (scenario.world.gravity_m_s2.norm() > 0)
    press.notes.emplace_back("gravity acts in the simulation, whose share of the force does not go with E");
  double lost_J = 0, stored_J = 0;
  for (const char* name : {"kinetic_energy", "viscous_loss", "mass_damping_loss", "stored_energy"}) {
    const StoredQuantity* energy = reader.find(name);
    if (energy == nullptr || energy->columns() != 1) return;
    const std::vector<double> values_J = reader.all(*energy);
    (name == std::string("stored_energy") ? stored_J : lost_J) +=
        *std::max_element(values_J.begin(), values_J.end());
  }
  if (stored_J > 0 && lost_J > kMostLostShare * stored_J)
    press.notes.push_back(
        fmt::format("motion and damping took {} of the energy stored in the simulation: a slower press is "
                    "nearer to E alone",
                    fourDigits(lost_J / stored_J)));
}

}  // namespace

double PressCurve::force(double at_m) const {
  if (!(at_m > 0)) return 0;
  const auto after =
      std::clamp<std::ptrdiff_t>(std::lower_bound(depth_m.begin(), depth_m.end(), at_m) - depth_m.begin(), 1,
                                 static_cast<std::ptrdiff_t>(depth_m.size()) - 1);
  const auto b = static_cast<std::size_t>(after), a = b - 1;
  const double share = (at_m - depth_m[a]) / (depth_m[b] - depth_m[a]);
  return force_N[a] + share * (force_N[b] - force_N[a]);
}

void takePress(const std::vector<double>& positions_m, const std::vector<double>& reactions_N,
               PressCurve& press) {
  const std::size_t steps = positions_m.size() / 3;
  const auto position = [&](std::size_t step) { return Vec3::Map(&positions_m[3 * step]); };
  const auto reaction = [&](std::size_t step) { return Vec3::Map(&reactions_N[3 * step]); };
  std::size_t touched = 0;
  while (touched < steps && reaction(touched).norm() == 0) ++touched;
  if (touched == steps) throw InputError("its tool never meets the body, expected a press");
  const std::size_t start = touched == 0 ? 0 : touched - 1;
  std::size_t deepest = start;
  for (std::size_t step = start; step < steps; ++step) {
    if (!std::isfinite(reaction(step).norm()))
      throw InputError("its reaction is not measured, expected a pipeline that measures reaction_force");
    if ((position(step) - position(start)).norm() > (position(deepest) - position(start)).norm())
      deepest = step;
  }
  if (deepest == start) throw InputError("its tool does not move in contact, expected a press");
  const Vec3 along = (position(deepest) - position(start)).normalized();
  for (std::size_t step = 0; step <= deepest; ++step) {
    press.depth_m.push_back(step <= start ? 0 : along.dot(position(step) - position(start)));
    press.force_N.push_back(step <= start && touched > 0 ? 0 : -along.dot(reaction(step)));
  }
  press.first_step_m = press.depth_m[touched];
  keepDeepening(press.depth_m, press.force_N);
}

void requirePress(const Scenario& scenario, const std::filesystem::path& file) {
  if (scenario.bodies.size() != 1)
    throw InputError(inFile(file), counted(scenario.bodies.size(), "body", "bodies") +
                                       ", expected one, with model: elastic");
  if (scenario.bodies.front().model != BodyModel::elastic)
    throw InputError(inFile(file), "its body has no modulus, expected one with model: elastic");
  if (scenario.tools.size() != 1)
    throw InputError(inFile(file), counted(scenario.tools.size(), "tool") + ", expected one");
}

PressCurve readPress(const std::filesystem::path& file, const std::string& run) {
  const ResultInfo info = readResultInfo(file);
  if (info.reference)
    throw InputError(inFile(file), "a reference, which holds a few steps alone, expected a whole result");
  const std::string name = run.empty() ? onlyRun(info, file) : run;
  const Scenario scenario = parseStoredScenario(info.scenario_resolved, file).scenario;
  requirePress(scenario, file);
  const BodySettings& body = scenario.bodies.front();
  PressCurve press{.label = file.string() + ":" + name,
                   .material = std::string(nameIn(catalog().elastic_materials, body.elastic.material)),
                   .youngs_modulus_Pa = body.elastic.youngs_modulus_Pa,
                   .poissons_ratio = body.elastic.poissons_ratio};
  const RunReader reader(file, name);
  const std::vector<double> positions_m = seriesOf(reader, "tool_position", 3),
                            reactions_N = seriesOf(reader, "reaction_force", 3);
  if (positions_m.size() != reactions_N.size())
    throw InputError(inFile(file), "tool_position and reaction_force differ in length, expected one a step");
  try {
    takePress(positions_m, reactions_N, press);
  } catch (const InputError& error) {
    throw InputError(inFile(file), fmt::format("run {}: {}", name, error.what()));
  }
  noteWhatDoesNotScale(scenario, reader, press);
  return press;
}

}  // namespace fissure
