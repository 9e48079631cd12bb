#include "run/run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/frame_text.h"
#include "base/steps.h"
#include "engine/simulation.h"
#include "explicit/elastic_simulation.h"
#include "motion/jaw_poses.h"
#include "scenario/rigid_tools.h"
#include "scene/build_scene.h"

namespace fissure {

namespace {

/// Beyond this no scene of surgery lies, and nothing can be measured: the simulation has exploded.
constexpr double kFarthest_m = 1e4;

bool isUsable(const Vec3& position_m) {
  return (position_m.array().abs() <= kFarthest_m).all();
}  // NaN is not

/// NaN and infinity are none.
bool hasFiniteEnergy(const State& state) {
  double energy_J = state.volume ? state.volume->kinetic_J : 0;
  for (std::size_t i = 0; i < state.masses_kg.size(); ++i)
    energy_J += 0.5 * state.masses_kg[i] * state.velocities_m_s[i].squaredNorm();
  return std::isfinite(energy_J);
}

/// What is wrong with the state: what first left the finite scene, or "".
std::string whatLeftTheScene(const State& state) {
  constexpr const char* gone = "is not finite or more than 10 km away";
  for (std::size_t i = 0; i < state.positions_m.size(); ++i) {
    if (!isUsable(state.positions_m[i])) return fmt::format("tissue vertex {} {}", i, gone);
  }
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    if (!isUsable(state.tools[t].pose.position_m)) return fmt::format("tool {} {}", t, gone);
  }
  return hasFiniteEnergy(state) ? "" : "the kinetic energy of the tissue is not finite";
}

/// "name: repair; repair; other name: repair", or "".
std::string repairsOf(const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& name, const std::vector<std::string>& repairs) {
    for (std::size_t i = 0; i < repairs.size(); ++i)
      text += (text.empty() ? "" : "; ") + (i == 0 ? name + ": " : "") + repairs[i];
  };
  for (const SceneBody& body : scene.bodies) add(body.name, body.repairs);
  for (const SceneTool& tool : scene.tools) add(tool.name, tool.repairs);
  return text;
}

/// `is_measured`: whether depth and certificate of this row were looked at.
FrameMeasures depthsIn(const RecordLayout& layout, const RecordRow& row, bool is_measured) {
  const auto value = [&](const char* name) {
    const Series* series = layout.find(name);
    return series ? std::optional(row[series->first_column]) : std::nullopt;
  };
  FrameMeasures measures = {.ground_m = value("ground_depth"), .pressure_Pa = value("max_pressure")};
  if (!is_measured) return measures;
  measures.depth_m = value("penetration_depth");
  measures.inversion_aware_m = value("inversion_aware_depth");
  measures.certified = value("certified");
  return measures;
}

}  // namespace

Run::Run(const Scenario& scenario, const PipelineSettings& pipeline, PreparedScenario prepared)
    : scenario_(scenario), engine_scenario_(scenario), pipeline_(pipeline), prepared_(std::move(prepared)) {
  adaptTo(pipeline, prepared_.scene);
  engine_scenario_.tools = rigidTools(scenario.tools);
  const double duration_s = scenario.time.duration_s.value_or(prepared_.longestMotion_s());
  steps_ = static_cast<std::int64_t>(stepsToCover(duration_s, scenario.time.step_s));
  settling_steps_ = static_cast<std::int64_t>(stepsToCover(scenario.time.settle_s, scenario.time.step_s));
  const auto make = !isElastic()            ? &makeSimulation
                    : pipeline.usesVolume() ? &makeDeformableSimulation
                                            : &makeElasticSimulation;
  simulation_ = make(engine_scenario_, pipeline, prepared_.scene, posesAt(0));
  makeCouplings();
}

bool Run::isElastic() const {
  return prepared_.scene.bodies.at(0).volume.has_value();
}

bool Run::isExplicit() const {
  return isElastic() && !pipeline_.usesVolume();
}

void Run::makeCouplings() {
  const std::vector<Pose> poses = posesAt(0);
  for (std::size_t t = 0; t < engine_scenario_.tools.size(); ++t) {
    const std::optional<CouplingSettings>& settings = engine_scenario_.tools[t].coupling;
    if (!settings) continue;
    const auto law = std::find_if(scenario_.force.begin(), scenario_.force.end(),
                                  [&](const ForceSettings& force) { return force.name == settings->force; });
    coupled_.push_back(
        {t, std::nullopt, VirtualCoupling(*settings, poses[t].position_m, scenario_.time.step_s)});
    Coupled& coupled = coupled_.back();
    if (!settings->isPushedByContacts()) {
      coupled.law = static_cast<std::size_t>(law - scenario_.force.begin());
      continue;
    }
    tool_inverse_masses_1_kg_.resize(poses.size());
    tool_inverse_masses_1_kg_[t] = coupled.coupling.inverseMass_1_kg();
  }
}

// A law's force is that of the step before: this step's follows from where the tool goes. In steps of a
// micronewton, so that a last bit of a shell's force, which may differ between processors, does not reach the
// motion (engine/METHOD.md 6).
void Run::moveCoupled(std::vector<Pose>& poses) {
  for (Coupled& coupled : coupled_) {
    Pose& pose = poses[coupled.tool];
    if (!coupled.law) {
      pose.position_m = coupled.coupling.advance(pose.position_m, Vec3::Zero());
      continue;
    }
    const Vec3& force_N =
        simulation_->state().tool_forces_N[*coupled.law * prepared_.scene.tools.size() + coupled.tool];
    const Vec3 felt_N = (1e6 * force_N).array().round() / 1e6;
    pose.position_m = coupled.coupling.advance(pose.position_m, felt_N);
  }
}

void Run::notePushes() {
  for (Coupled& coupled : coupled_) {
    if (coupled.law) continue;
    const ToolState& tool = simulation_->state().tools[coupled.tool];
    coupled.coupling.push(tool.pose.position_m, tool.velocity_m_s);
  }
}

std::vector<Pose> Run::posesAt(double time_s) const {
  std::vector<Pose> poses;
  for (std::size_t t = 0; t < prepared_.motions.size(); ++t) {
    const ToolSettings& tool = scenario_.tools[t];
    const Pose pose = prepared_.motions[t]->poseAt(time_s);
    if (!tool.clamp) {
      poses.push_back(pose);
      continue;
    }
    const auto jaws = jawPoses(*tool.clamp, closedJaws(tool), pose, prepared_.motions[t]->openingAt(time_s));
    poses.insert(poses.end(), jaws.begin(), jaws.end());
  }
  return poses;
}

void Run::noteClamps(double time_s) {
  std::vector<ClampState>& clamps = simulation_->state().clamps;
  clamps.clear();
  for (std::size_t t = 0; t < prepared_.motions.size(); ++t) {
    if (scenario_.tools[t].clamp)
      clamps.push_back({prepared_.motions[t]->poseAt(time_s), prepared_.motions[t]->openingAt(time_s)});
  }
}

void Run::noteCouplings() {
  std::vector<CouplingState>& couplings = simulation_->state().couplings;
  couplings.clear();
  for (const Coupled& coupled : coupled_)
    couplings.push_back({coupled.tool, coupled.coupling.target_m(), coupled.coupling.force_on_tool_N()});
}

// The simulation's step, and what clock, clamps and couplings add to its state. False: tissue is no longer
// finite.
bool Run::advance(std::int64_t step) {
  const double time_s = static_cast<double>(step) * scenario_.time.step_s;
  std::vector<Pose> poses = posesAt(time_s);
  const bool settles = step == 0;  // then hand and tool wait
  if (!settles) moveCoupled(poses);
  const auto start = std::chrono::steady_clock::now();
  simulation_->step(poses, settles ? std::span<const double>() : tool_inverse_masses_1_kg_);
  const auto end = std::chrono::steady_clock::now();
  if (!settles) notePushes();
  State& state = simulation_->state();
  state.step = step;
  state.time_s = time_s;
  noteClamps(time_s);
  noteCouplings();
  state.timing.step_us = std::chrono::duration<double, std::micro>(end - start).count();
  const bool is_sound = whatLeftTheScene(state).empty();
  state.is_last = step == steps_ || !is_sound;
  return is_sound;
}

void Run::emit(const Outputs& outputs, RecordRow& row, FrameSource* frames) {
  const State& state = simulation_->state();
  std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
  row[0] = state.time_s;
  for (const auto& probe : outputs.probes) probe->sample(state, row);
  const RecordSettings& record = scenario_.record;
  if (state.isOneOf(stepsPerRow(record, scenario_.measure))) {
    if (record.force_inputs) outputs.sink.forceInputs(state);
    outputs.sink.append(row);
  }
  const double step_s = scenario_.time.step_s;
  if (record.snapshots_every_s && isDue(state.step, step_s, *record.snapshots_every_s))
    outputs.sink.snapshot(state);
  if (frames && isDue(state.step, step_s, record.frames->every_s)) {
    const bool is_measured = state.isOneOf(stepsPerMeasurement(scenario_.measure));
    const auto text = frameText(pipeline_.name, state.time_s, depthsIn(outputs.layout, row, is_measured));
    outputs.sink.frame(state.time_s, frames->draw(state, text));
  }
}

void Run::changeTempo(double factor) {
  simulation_->changeTempo(factor);
  for (Coupled& coupled : coupled_) {
    coupled.coupling.changeTempo(factor);
    if (factor < 1) simulation_->state().tools[coupled.tool].velocity_m_s *= factor;
  }
}

RunStatus Run::execute(const Outputs& outputs) {
  State& state = simulation_->state();
  RecordRow row(outputs.layout.columns());
  RunStatus status;
  const std::int64_t total = settling_steps_ + steps_;
  bool finite = true;
  for (std::int64_t i = 0; i < settling_steps_ && finite; ++i) {
    finite = advance(0);
    if (outputs.progress) outputs.progress(i + 1, total);
  }
  if (settling_steps_ == 0) {
    noteClamps(0);
    noteCouplings();
  }
  state.timing = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

  std::unique_ptr<FrameSource> frames;
  if (scenario_.record.frames) frames = outputs.make_frame_source(state);
  std::int64_t step = 0;
  emit(outputs, row, frames.get());
  while (finite && step < steps_) {
    finite = advance(++step);
    emit(outputs, row, frames.get());
    if (outputs.progress) outputs.progress(settling_steps_ + step, total);
  }

  Summary summary = {{"provenance/engine_version", isExplicit() ? elasticEngineVersion() : engineVersion()}};
  if (frames) {
    for (const auto& [name, value] : frames->versions()) summary.push_back({"provenance/" + name, value});
  }
  summary.push_back({"non_finite_at_step", finite ? -1LL : static_cast<long long>(step)});
  if (!finite) {
    status.end = RunEnd::non_finite;
    status.detail = fmt::format("{} at step {} (t = {:g} s)", whatLeftTheScene(state), step, state.time_s);
  }
  for (const auto& probe : outputs.probes) probe->summarize(summary);
  if (const std::string repairs = repairsOf(prepared_.scene); !repairs.empty())
    summary.push_back({"repairs", repairs});
  for (const SummaryValue& value : simulation_->counters()) summary.push_back(value);
  for (std::size_t t = 0; t < prepared_.motions.size(); ++t) {
    for (SummaryValue value : prepared_.motions[t]->summary()) {
      value.name = scenario_.tools[t].name + "_" + value.name;
      summary.push_back(std::move(value));
    }
  }
  outputs.sink.finish(status, summary);
  return status;
}

}  // namespace fissure
