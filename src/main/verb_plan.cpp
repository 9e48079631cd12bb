#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "base/error.h"
#include "batch/pilot_runs.h"
#include "check/run_plan.h"
#include "check/scenario_warnings.h"
#include "main/exit_codes.h"
#include "main/result_table.h"
#include "main/scenario_options.h"
#include "main/text_table.h"
#include "main/verbs.h"
#include "motion/motion.h"
#include "scenario/catalog.h"
#include "scenario/rigid_tools.h"
#include "stepping/substep_plan.h"
#include "text/units.h"
#include "text/wrapped_text.h"

namespace fissure {

namespace {

/// What the rules of a replay have found in its log: "replay: time in ms, 1501 samples, 12 held samples ..."
void printReplay(const ToolMotion& settings, const Motion& motion) {
  const std::string prefix = "replay_";
  std::string counts;
  if (const auto* replay = std::get_if<ReplayMotion>(&settings); replay && replay->timeUnit())
    counts = "time in " + nameIn(catalog().time_units, *replay->timeUnit());
  for (const SummaryValue& value : motion.summary()) {
    std::string what = value.name.substr(value.name.starts_with(prefix) ? prefix.size() : 0);
    std::replace(what.begin(), what.end(), '_', ' ');
    counts += (counts.empty() ? "" : ", ") + summaryText(value) + " " + what;
  }
  if (!counts.empty()) std::cout << "    replay: " << counts << "\n";
}

/// "    motion: at most 0.1 m/s and 3.2 m/s2"
void printPeaks(const MotionPeaks& peaks) {
  std::cout << "    motion: at most " << fourDigits(peaks.speed_m_s()) << " m/s";
  // Of a motion without any there are roundings left.
  if (peaks.acceleration_m_s2() > 1e-6)
    std::cout << " and " << fourDigits(peaks.acceleration_m_s2()) << " m/s2";
  std::cout << "\n";
}

/// "jaws clamp_left and clamp_right, parallel; device axis z opens them by up to 0.04 m ..."
void printClamp(const ToolSettings& clamp) {
  const bool hinged = clamp.clamp->opening == ClampOpening::hinged;
  const auto [left, right] = jawNames(clamp);
  std::cout << "    jaws " << left << " and " << right << (hinged ? ", hinged" : ", parallel");
  if (const auto* replay = std::get_if<ReplayMotion>(&clamp.motion))
    std::cout << "; device axis " << nameIn(catalog().device_axes, replay->opening->axis)
              << " opens them by up to " << replay->opening->open() << (hinged ? " degrees" : " m")
              << ", the others move the clamp";
  std::cout << "\n";
}

/// "elastic, neo_hookean: E 10000 Pa, nu 0.4, 1000 kg/m3; 512 tetrahedra, 1 substep a step ..."
void printElastic(const BodySettings& body, const SubstepPlan& plan) {
  const ElasticSettings& elastic = body.elastic;
  std::cout << "    elastic, " << nameIn(catalog().elastic_materials, elastic.material) << ": E "
            << elastic.youngs_modulus_Pa << " Pa, nu " << elastic.poissons_ratio << ", "
            << elastic.density_kg_m3 << " kg/m3; " << plan.tetrahedra << " tetrahedra, " << plan.substeps
            << (plan.substeps == 1 ? " substep" : " substeps")
            << " a step at rest: the fastest vibration of the mesh allows "
            << fourDigits(1e3 * plan.critical_step_s) << " ms; stretched elements need more\n";
  if (4 * plan.substeps_without_stiffest <= 3 * plan.substeps)
    std::cout << "    " << plan.stiffest << (plan.stiffest == 1 ? " tetrahedron sets" : " tetrahedra set")
              << " this, the stiffest at (" << fourDigits(plan.stiffest_m.x()) << ", "
              << fourDigits(plan.stiffest_m.y()) << ", " << fourDigits(plan.stiffest_m.z())
              << ") m: without them " << plan.substeps_without_stiffest
              << (plan.substeps_without_stiffest == 1 ? " substep\n" : " substeps\n");
  for (std::size_t r = 0; r < plan.regions.size(); ++r) {
    const ElasticSettings region = elastic.materialOf(elastic.regions[r]);
    std::cout << "    region " << elastic.regions[r].name << ": E " << region.youngs_modulus_Pa << " Pa, nu "
              << region.poissons_ratio << ", " << region.density_kg_m3 << " kg/m3; "
              << plan.regions[r].tetrahedra
              << (plan.regions[r].tetrahedra == 1 ? " tetrahedron" : " tetrahedra")
              << ", which alone would allow " << fourDigits(1e3 * plan.regions[r].critical_step_s) << " ms\n";
  }
}

void printScene(const CheckedScenario& checked) {
  const Scenario& scenario = checked.loaded.scenario;
  std::cout << scenario.name << ": " << checked.duration_s << " s in " << checked.steps << " steps of "
            << scenario.time.step_s << " s, " << scenario.pipelines.size() << " runs\n";
  const Scene& scene = checked.prepared.scene;
  for (const SceneBody& body : scene.bodies) {
    std::cout << "  body " << body.name << ": " << body.rest.faces.size() << " triangles, "
              << body.rest.vertices_m.size() << " vertices";
    const std::size_t fixed = body.fixed_vertices.size();
    if (fixed > 0) std::cout << ", " << fixed << " of them fixed";
    std::cout << "\n";
    if (body.volume)
      printElastic(scenario.bodies[0], planSubsteps(scenario.bodies[0], body, scenario.time.step_s));
  }
  for (const std::string& note : checked.notes) std::cout << "  " << note << "\n";
  for (const std::string& warning : scenarioWarnings(checked)) std::cout << "  " << warning << "\n";
  std::size_t rigid = 0;  // the scene's tool; of a clamp, its right jaw, whose shape the clamp names
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const ToolSettings& tool = scenario.tools[t];
    if (tool.clamp) ++rigid;
    std::cout << (tool.clamp ? "  clamp " : "  tool ") << tool.name << ": ";
    if (!std::holds_alternative<BoxShape>(tool.shape))
      std::cout << scene.tools[rigid].surface.faces.size() << " triangles, ";
    ++rigid;
    std::cout << std::visit([](const auto& motion) { return motion.text.in_plan; }, tool.motion);
    if (tool.force_limit_N) std::cout << ", device limit " << *tool.force_limit_N << " N";
    if (tool.coupling)
      std::cout << ", " << tool.coupling->mass_kg << " kg on a virtual coupling, pushed by "
                << tool.coupling->force;
    std::cout << "\n";
    if (tool.clamp) printClamp(tool);
    const Motion& motion = *checked.prepared.motions[t];
    printPeaks(peaksOf(motion, scenario.time.step_s, checked.steps));
    printReplay(tool.motion, motion);
  }
  if (scenario.ground) std::cout << "  ground at " << scenario.ground->height_m << " m\n";
  if (!scenario.expect.empty()) std::cout << "  expect: " << scenario.expect.size() << " values\n";
}

/// Only the stages that this run has: what a scenario does not ask for costs nothing.
void printRun(const Scenario& scenario, const RunPlan& plan) {
  std::cout << "run " << plan.pipeline->name << " (" << plan.pipeline->traits().name << ", "
            << nameIn(catalog().precisions, plan.pipeline->precision) << ", at most "
            << plan.pipeline->time_limit_s << " s of wall time)\n";
  if (plan.settling_steps > 0) std::cout << "  settle: " << plan.settling_steps << " steps\n";
  std::cout << "  simulate: " << plan.steps << " steps\n";
  if (scenario.ground)
    std::cout << "  ground: "
              << (plan.pipeline->ownGround() ? "an obstacle of the pipeline's own contacts"
                                             : "Bullet's contact, which gives way under load")
              << "\n";
  if (plan.nodes > 0) std::cout << "  detect: " << plan.nodes << " tool nodes\n";
  for (const ForceSettings& law : scenario.force)
    std::cout << "  force: " << law.name << " (" << entryOf(law.model).name
              << (law.deformation == DeformationKind::paper
                      ? ""
                      : ", " + nameIn(catalog().deformations, law.deformation))
              << (law.per_area ? ", per area" : "") << ")\n";
  std::vector<std::string> words = {"record:"};
  words.insert(words.end(), plan.series.begin(), plan.series.end());
  words.back() += ";";
  words.push_back(sizeText(plan.record_bytes));
  std::cout << wrappedText(words, 2);
  if (scenario.record.force_inputs)
    std::cout << "  force inputs: what " << scenario.force.size() << " laws see of each colliding triangle; "
              << plan.force_input_bytes << " B a triangle and step, not in the size below\n";
  if (plan.snapshots > 0)
    std::cout << "  snapshots: " << plan.snapshots << "; " << sizeText(plan.snapshot_bytes) << "\n";
  if (plan.frames > 0)
    std::cout << "  frames: " << plan.frames << " of " << scenario.record.frames->width_px << " x "
              << scenario.record.frames->height_px << " px; " << sizeText(plan.frame_bytes)
              << " before compression\n";
}

struct PlanOptions {
  ScenarioOptions scenarios;
  std::optional<int> pilot;
  bool resolved = false;
};

/// The scenario with every default written out, for `run`.
int printResolved(const ScenarioOptions& options) {
  if (options.files.size() > 1) throw InputError("--resolved prints one scenario, expected one file");
  std::cout << checkScenario(options.files.front(), options.selection()).loaded.resolved;
  return exit_good;
}

int printPlans(const PlanOptions& options) {
  int code = exit_good;
  for (const std::string& file : options.scenarios.files) {
    const CheckedScenario checked = checkScenario(file, options.scenarios.selection());
    printScene(checked);
    std::vector<PilotRun> pilots;
    if (options.pilot) {
      std::cout.flush();
      Interrupt interrupt;
      pilots = runPilots(checked, *options.pilot, interrupt);
    }
    double bytes = 0;
    for (const RunPlan& plan : planRuns(checked)) {
      printRun(checked.loaded.scenario, plan);
      bytes += plan.bytes();
      if (pilots.empty()) continue;
      const auto run = static_cast<std::size_t>(plan.pipeline - &checked.loaded.scenario.pipelines.front());
      std::cout << "  time: " << forecastLine(pilots[run], plan.pipeline->time_limit_s) << "\n";
      if (!pilots[run].forecast) code = exit_run_failed;
    }
    std::cout << "result: about " << sizeText(bytes) << "\n";
  }
  return code;
}

}  // namespace

Verb addPlan(Command app) {
  const auto options = std::make_shared<PlanOptions>();
  Command command = app.command("plan", "what each run will do and keep, without running it");
  addScenarioOptions(command, options->scenarios);
  command.flag(
      "--resolved", options->resolved,
      "print the scenario itself, every default written out: YAML for the same folder, which names of "
      "files start from");
  command
      .option(
          "--pilot", options->pilot,
          "simulate about one of so many steps (10, say), with the tools on the same path, to say how long "
          "each run takes; nothing of that is kept")
      .between(2, 1000);
  command.example("fissure plan press.yaml --resolved > press_resolved.yaml");
  return {command,
          [options] { return options->resolved ? printResolved(options->scenarios) : printPlans(*options); }};
}

}  // namespace fissure
