#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/catalog.h"
#include "scenario/elastic_region.h"
#include "scenario/fill.h"

namespace fissure {

/// The model of a soft body.
enum class BodyModel {
  shell,    ///< Bullet's springs along the edges of the surface
  elastic,  ///< finite elements over the whole volume
};

/// The material law of an elastic body (elastic/METHOD.md 2).
enum class ElasticMaterialKind { neo_hookean, linear_corotated, saint_venant_kirchhoff };

/// A body of finite elements: an isotropic material in SI units (elastic/METHOD.md 2).
struct ElasticSettings {
  std::optional<std::string> preset;  ///< a name in catalog().elastic_presets
  ElasticMaterialKind material = ElasticMaterialKind::neo_hookean;
  double youngs_modulus_Pa = 10e3;
  double poissons_ratio = 0.4;
  double density_kg_m3 = 1000;
  double viscosity_Pa_s = 0;
  double mass_damping_1_s = 0;
  double friction = 0.2;
  std::optional<FillSettings> fill;
  std::vector<ElasticRegion> regions;

  /// The material of a region with the body's values filled in, without preset and regions.
  ElasticSettings materialOf(const ElasticRegion& region) const;

  bool operator==(const ElasticSettings&) const = default;
};

/// A named material.
struct ElasticPreset {
  std::string_view name;
  double youngs_modulus_Pa = 0;
  double poissons_ratio = 0;
  double density_kg_m3 = 0;
  std::string_view description;  ///< one line for people: the numbers and their source
};

/// All presets, in the order of catalog().elastic_presets.
const std::vector<ElasticPreset>& elasticPresets();

/// Sets modulus, ratio and density to those of the preset; changes nothing without a preset or with an
/// unknown one.
void applyPreset(ElasticSettings& elastic);

template <class Io>
void describe(Io& io, ElasticSettings& e) {
  const char* const preset = "unless `preset` says another";
  io.field("preset", e.preset,
           Key("A known material, which sets modulus, ratio and density where the file leaves them out.")
               .oneOf(catalog().elastic_presets)
               .otherwise("none"));
  io.whileReading([&] { applyPreset(e); });
  io.field("material", e.material, Key("Law of the material.").oneOf(catalog().elastic_materials));
  io.field("youngs_modulus_Pa", e.youngs_modulus_Pa,
           Key("Young's modulus at small strain.").above(0).except(preset));
  io.field("poissons_ratio", e.poissons_ratio,
           Key("Poisson's ratio. Above 0.45 elements share their pressure with their neighbours, so that "
               "they do not lock.")
               .noUnit()
               .between(0, most_poissons_ratio)
               .except(preset));
  io.field("density_kg_m3", e.density_kg_m3, Key("Density at rest.").above(0).except(preset));
  io.field(
      "viscosity_Pa_s", e.viscosity_Pa_s,
      Key("Viscosity of the viscous stress, which damps deformation and conserves momentum.").atLeast(0));
  io.field("mass_damping_1_s", e.mass_damping_1_s,
           Key("Deceleration over velocity, of the motion of the body as a whole too: a means to bring a "
               "scene to rest, no property of tissue.")
               .atLeast(0));
  io.field("friction", e.friction,
           Key("Coulomb's coefficient of the tissue; contacts rub with its product with the friction of the "
               "tool or the ground.")
               .noUnit()
               .atLeast(0));
  io.field("fill", e.fill,
           Key("How TetGen fills the surface with tetrahedra, for shapes that are a surface alone (`file`, "
               "`triangles`).")
               .otherwise("the defaults of its keys, for such shapes"));
  io.field("regions", e.regions,
           Key("Parts with materials of their own, whose law is the body's. Of several regions that hold a "
               "tetrahedron the last has it; each must have at least one.")
               .items(0, most_regions));
}

}  // namespace fissure
