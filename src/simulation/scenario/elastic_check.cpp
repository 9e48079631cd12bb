#include <fmt/core.h>

#include <algorithm>

#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// What has no effect in Bullet's deformable world.
void checkDeformable(Checker run, const PipelineSettings& entry, const BodySettings& body) {
  const ElasticSettings& elastic = body.elastic;
  run.require(elastic.material != ElasticMaterialKind::neo_hookean || elastic.mass_damping_1_s == 0,
              "pipeline",
              fmt::format("is deformable, and Bullet damps no mass of a neo-Hookean body, expected "
                          "bodies.{}.elastic.mass_damping_1_s 0",
                          body.name));
  run.require(elastic.material != ElasticMaterialKind::saint_venant_kirchhoff, "pipeline",
              fmt::format("is deformable, and Bullet has no Saint Venant-Kirchhoff law, expected "
                          "bodies.{}.elastic.material neo_hookean or linear_corotated",
                          body.name));
  run.require(elastic.regions.empty(), "pipeline",
              fmt::format("is deformable, and a body of Bullet's has one material, expected "
                          "bodies.{}.elastic.regions left out",
                          body.name));
  if (*entry.deformableSolver(elastic.material).implicit) return;
  Checker solver = run.in("deformable");
  // A stored scenario has every number; what differs from the default was meant.
  const DeformableSolver unset = withDefaults({}, entry.settings == SettingsPreset::tuned, elastic.material);
  const auto unused = [&](const char* key, bool meant) {
    solver.require(!meant, key, "is of no effect without deformable.implicit true, expected it left out");
  };
  unused("line_search", entry.deformable.line_search.value_or(false));
  unused("newton_iterations",
         entry.deformable.newton_iterations.value_or(*unset.newton_iterations) != *unset.newton_iterations);
  unused("newton_tolerance",
         entry.deformable.newton_tolerance.value_or(*unset.newton_tolerance) != *unset.newton_tolerance);
}

}  // namespace

void checkElasticRegion(Checker check, const ElasticRegion& region) {
  check.require(region.tag.has_value() + region.box.has_value() + region.capsule.has_value() == 1, "",
                "expected exactly one of tag, box and capsule");
  if (region.box) checkBox(check.in("box"), *region.box);
}

void checkElasticScene(Checker check, const Scenario& scenario) {
  const std::vector<BodySettings>& bodies = scenario.bodies;
  const auto elastic =
      std::find_if(bodies.begin(), bodies.end(), [](const BodySettings& body) { return body.isElastic(); });
  if (elastic == bodies.end()) {
    for (const PipelineSettings& entry : scenario.pipelines)
      check.in("pipelines")
          .in(entry.name)
          .require(!entry.usesVolume(), "pipeline",
                   "is deformable, Bullet's world of tetrahedra, expected a body of model elastic alone");
    return;
  }
  check.require(bodies.size() == 1, "bodies." + elastic->name + ".model",
                "is elastic, and the scenario has other bodies, expected it alone: elastic bodies do not "
                "meet others");
  const std::string this_body = fmt::format("body {} of model elastic", elastic->name);
  const std::string without_effect = fmt::format("is of no effect on {}, expected it left out", this_body);
  const WorldSettings unset;
  Checker world = check.in("world");
  world.require(scenario.world.air_density_kg_m3 == unset.air_density_kg_m3, "air_density_kg_m3",
                without_effect);
  world.require(scenario.world.max_displacement_m == unset.max_displacement_m, "max_displacement_m",
                without_effect);
  if (scenario.ground)
    check.in("ground").require(
        scenario.ground->hardness == GroundSettings().hardness, "hardness",
        fmt::format("is Bullet's, of no effect on {}, expected it left out", this_body));
  const std::string shape = "bodies." + elastic->name + ".shape";
  const std::optional<double> tetrahedra = tetrahedraOf(elastic->shape);
  check.require(!elastic->elastic.fill || elastic->isFilledByMesher(),
                "bodies." + elastic->name + ".elastic.fill",
                "is of no effect, expected it left out: the shape has tetrahedra of its own");
  if (tetrahedra)
    check.require(*tetrahedra <= most_tetrahedra, shape,
                  fmt::format("has {} tetrahedra, expected at most {}", formatReal(*tetrahedra),
                              formatReal(most_tetrahedra)));
  for (const PipelineSettings& entry : scenario.pipelines) {
    Checker run = check.in("pipelines").in(entry.name);
    using enum ContactDetection;
    const ContactDetection detection = entry.traits().detection;
    run.require(detection == nodes || detection == surface || detection == sticking || detection == volume,
                "pipeline",
                fmt::format("is {}, Bullet's own contact, expected {} for {}", entry.traits().name,
                            pipelinesWith({nodes, surface, sticking, volume}), this_body));
    if (detection == nodes)
      run.require(
          entry.contactResponse() == ContactResponse::momentum, "response",
          "is none, which leaves velocities of held tissue growing, expected momentum for " + this_body);
    if (detection == volume) checkDeformable(run, entry, *elastic);
    run.require(entry.precision == Precision::f64, "precision", "is f32, expected f64 for " + this_body);
    if (detection == nodes || detection == sticking)
      run.require(
          !scenario.ground || entry.ownGround(), detection == nodes ? "ground_contact" : "pipeline",
          fmt::format("stands on Bullet's ground, expected {} for {}",
                      detection == nodes ? "half_space" : "another pipeline, or no ground", this_body));
  }
}

}  // namespace fissure
