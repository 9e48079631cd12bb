#include <algorithm>

#include "scenario/catalog.h"
#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// Highest Poisson's ratio of an element that can change its volume.
constexpr double most_poissons_ratio = 0.49;

}  // namespace

void checkElastic(Checker check, const ElasticSettings& elastic) {
  if (elastic.preset) check.oneOf("preset", *elastic.preset, catalog().elastic_presets);
  check.positive("youngs_modulus_Pa", elastic.youngs_modulus_Pa);
  check.between("poissons_ratio", elastic.poissons_ratio, 0, most_poissons_ratio);
  check.positive("density_kg_m3", elastic.density_kg_m3);
  check.notNegative("viscosity_Pa_s", elastic.viscosity_Pa_s);
  check.notNegative("mass_damping_1_s", elastic.mass_damping_1_s);
  check.notNegative("friction", elastic.friction);
}

void checkElasticScene(Checker check, const Scenario& scenario) {
  const std::vector<BodySettings>& bodies = scenario.bodies;
  const auto elastic =
      std::find_if(bodies.begin(), bodies.end(), [](const BodySettings& body) { return body.isElastic(); });
  if (elastic == bodies.end()) return;
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
  check.require(tetrahedra.has_value(), shape,
                "is a surface without a volume of tetrahedra, expected sphere, box, capsule or lobes for "
                "model elastic");
  if (tetrahedra)
    check.require(
        *tetrahedra <= most_tetrahedra, shape,
        "has " + formatReal(*tetrahedra) + " tetrahedra, expected at most " + formatReal(most_tetrahedra));
  for (const PipelineSettings& entry : scenario.pipelines) {
    Checker run = check.in("pipelines").in(entry.name);
    using enum ContactDetection;
    const ContactDetection detection = entry.traits().detection;
    run.require(detection == nodes || detection == surface || detection == sticking, "pipeline",
                "is " + std::string(entry.traits().name) + ", Bullet's own contact, expected " +
                    pipelinesWith({nodes, surface, sticking}) + " for body " + elastic->name +
                    " of model elastic");
    if (detection == nodes)
      run.require(entry.contactResponse() == ContactResponse::momentum, "response",
                  "is none, which leaves velocities of held tissue growing, expected momentum for body " +
                      elastic->name + " of model elastic");
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
