#include <algorithm>

#include "scenario/catalog.h"
#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// Highest Poisson's ratio of an element that can change its volume.
constexpr double most_poissons_ratio = 0.49;

/// What has no effect in Bullet's deformable world.
void checkDeformable(Checker run, const PipelineSettings& entry, const BodySettings& body) {
  const ElasticSettings& elastic = body.elastic;
  run.require(elastic.material != ElasticMaterialKind::neo_hookean || elastic.mass_damping_1_s == 0,
              "pipeline",
              "is deformable, and Bullet damps no mass of a neo-Hookean body, expected bodies." + body.name +
                  ".elastic.mass_damping_1_s 0");
  run.require(elastic.regions.empty(), "pipeline",
              "is deformable, and a body of Bullet's has one material, expected bodies." + body.name +
                  ".elastic.regions left out");
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

void checkElastic(Checker check, const ElasticSettings& elastic) {
  if (elastic.preset) check.oneOf("preset", *elastic.preset, catalog().elastic_presets);
  check.positive("youngs_modulus_Pa", elastic.youngs_modulus_Pa);
  check.between("poissons_ratio", elastic.poissons_ratio, 0, most_poissons_ratio);
  check.positive("density_kg_m3", elastic.density_kg_m3);
  check.notNegative("viscosity_Pa_s", elastic.viscosity_Pa_s);
  check.notNegative("mass_damping_1_s", elastic.mass_damping_1_s);
  check.notNegative("friction", elastic.friction);
  check.require(elastic.regions.size() <= most_regions, "regions",
                "has " + std::to_string(elastic.regions.size()) + " items, expected at most " +
                    std::to_string(most_regions));
  if (!elastic.fill) return;
  Checker fill = check.in("fill");
  fill.between("radius_edge_ratio", elastic.fill->radius_edge_ratio, 1.1, 10);
  fill.between("least_dihedral_deg", elastic.fill->least_dihedral_deg, 0, 20);
  if (elastic.fill->max_edge_m) fill.positive("max_edge_m", *elastic.fill->max_edge_m);
}

void checkElasticRegion(Checker check, const ElasticRegion& region) {
  check.require(region.tag.has_value() + region.box.has_value() + region.capsule.has_value() == 1, "",
                "expected exactly one of tag, box and capsule");
  if (region.box) checkBox(check.in("box"), *region.box);
  if (region.capsule) {
    Checker capsule = check.in("capsule");
    capsule.finite("from_m", region.capsule->from_m);
    capsule.finite("to_m", region.capsule->to_m);
    capsule.positive("radius_m", region.capsule->radius_m);
  }
  if (region.preset) check.oneOf("preset", *region.preset, catalog().elastic_presets);
  if (region.youngs_modulus_Pa) check.positive("youngs_modulus_Pa", *region.youngs_modulus_Pa);
  if (region.poissons_ratio) check.between("poissons_ratio", *region.poissons_ratio, 0, most_poissons_ratio);
  if (region.density_kg_m3) check.positive("density_kg_m3", *region.density_kg_m3);
  if (region.viscosity_Pa_s) check.notNegative("viscosity_Pa_s", *region.viscosity_Pa_s);
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
  const WorldSettings unset;
  Checker world = check.in("world");
  world.require(scenario.world.air_density_kg_m3 == unset.air_density_kg_m3, "air_density_kg_m3",
                "is of no effect on body " + elastic->name + " of model elastic, expected it left out");
  world.require(scenario.world.max_displacement_m == unset.max_displacement_m, "max_displacement_m",
                "is of no effect on body " + elastic->name + " of model elastic, expected it left out");
  if (scenario.ground)
    check.in("ground").require(
        scenario.ground->hardness == GroundSettings().hardness, "hardness",
        "is Bullet's, of no effect on body " + elastic->name + " of model elastic, expected it left out");
  const std::string shape = "bodies." + elastic->name + ".shape";
  const std::optional<double> tetrahedra = tetrahedraOf(elastic->shape);
  check.require(!elastic->elastic.fill || elastic->isFilledByMesher(),
                "bodies." + elastic->name + ".elastic.fill",
                "is of no effect, expected it left out: the shape has tetrahedra of its own");
  if (tetrahedra)
    check.require(
        *tetrahedra <= most_tetrahedra, shape,
        "has " + formatReal(*tetrahedra) + " tetrahedra, expected at most " + formatReal(most_tetrahedra));
  for (const PipelineSettings& entry : scenario.pipelines) {
    Checker run = check.in("pipelines").in(entry.name);
    using enum ContactDetection;
    const ContactDetection detection = entry.traits().detection;
    run.require(detection == nodes || detection == surface || detection == sticking || detection == volume,
                "pipeline",
                "is " + std::string(entry.traits().name) + ", Bullet's own contact, expected " +
                    pipelinesWith({nodes, surface, sticking, volume}) + " for body " + elastic->name +
                    " of model elastic");
    if (detection == nodes)
      run.require(entry.contactResponse() == ContactResponse::momentum, "response",
                  "is none, which leaves velocities of held tissue growing, expected momentum for body " +
                      elastic->name + " of model elastic");
    if (detection == volume) checkDeformable(run, entry, *elastic);
    run.require(entry.precision == Precision::f64, "precision",
                "is f32, expected f64 for body " + elastic->name + " of model elastic");
    if (detection == nodes || detection == sticking)
      run.require(!scenario.ground || entry.ownGround(), detection == nodes ? "ground_contact" : "pipeline",
                  "stands on Bullet's ground, expected " +
                      std::string(detection == nodes ? "half_space" : "another pipeline, or no ground") +
                      " for body " + elastic->name + " of model elastic");
  }
}

}  // namespace fissure
