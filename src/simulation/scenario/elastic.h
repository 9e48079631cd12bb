#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// What a soft body consists of.
enum class BodyModel {
  shell,    ///< Bullet's springs along the edges of the surface
  elastic,  ///< finite elements over the whole volume
};

/// The law of an elastic body's material.
enum class ElasticMaterialKind { neo_hookean, linear_corotated };

/// A body of finite elements: an isotropic material in SI units (METHOD section 10).
struct ElasticSettings {
  /// A name in catalog().elastic_presets: modulus, ratio and density where the file leaves them out.
  std::optional<std::string> preset;
  ElasticMaterialKind material = ElasticMaterialKind::neo_hookean;
  double youngs_modulus_Pa = 10e3;  ///< at small strain, > 0
  double poissons_ratio = 0.4;      ///< 0..0.49
  double density_kg_m3 = 1000;      ///< at rest, > 0
  double viscosity_Pa_s = 0;        ///< of the viscous stress, >= 0; conserves momentum
  /// Deceleration over velocity, >= 0, of the motion of the body as a whole too: a means to bring a scene to
  /// rest, no property of tissue.
  double mass_damping_1_s = 0;
  double friction = 0.2;  ///< Coulomb's coefficient on a tool or the ground is the product of both, >= 0

  bool operator==(const ElasticSettings&) const = default;
};

/// A material by name.
struct ElasticPreset {
  std::string_view name;
  double youngs_modulus_Pa = 0;
  double poissons_ratio = 0;
  double density_kg_m3 = 0;
  std::string_view description;  ///< the numbers and where they are from
};

/// All of them: catalog().elastic_presets lists them.
const std::vector<ElasticPreset>& elasticPresets();

/// Sets what the preset says; without one, or with an unknown one, nothing.
void applyPreset(ElasticSettings& elastic);

}  // namespace fissure
