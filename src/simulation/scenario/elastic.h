#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/regions.h"

namespace fissure {

/// What a soft body consists of.
enum class BodyModel {
  shell,    ///< Bullet's springs along the edges of the surface
  elastic,  ///< finite elements over the whole volume
};

/// The law of an elastic body's material.
enum class ElasticMaterialKind { neo_hookean, linear_corotated };

/// How the mesher (TetGen) fills a closed surface with tetrahedra.
struct FillSettings {
  /// true: the body's triangles are those of the surface, and every new vertex lies inside. false: the mesher
  /// may cut triangles where that makes better tetrahedra; the body's surface is then what it made of them.
  bool keep_surface = true;
  /// Largest radius of a tetrahedron's circumscribed sphere over its shortest edge, 1.1..10. Smaller: more
  /// and rounder tetrahedra. Slivers can have good values: least_dihedral_deg is against them.
  double radius_edge_ratio = 1.4;
  double least_dihedral_deg = 15;  ///< between sides of a tetrahedron, 0..20; where the surface allows it
  /// No tetrahedron is larger than a regular one of this edge, > 0. Where the surface is kept, new vertices
  /// stay clear of its triangles, so that tetrahedra beside large ones may be larger: make these smaller
  /// first
  /// (`max_edge_m` of the shape).
  std::optional<double> max_edge_m;

  bool operator==(const FillSettings&) const = default;
};

/// The most regions of a body: what each alone would allow is looked for.
inline constexpr std::size_t most_regions = 64;

/// Part of an elastic body with a material of its own, whose law is the body's: a vessel in a liver.
/// Tetrahedra belong to it whose centroid is where exactly one of tag, box and capsule says, in the frame of
/// the body's shape. What has no value is the body's own.
struct ElasticRegion {
  std::string name;        ///< unique in the body
  std::optional<int> tag;  ///< the physical tag of the tetrahedra in the file of a mesh
  std::optional<BoxRegion> box;
  std::optional<CapsuleRegion> capsule;
  std::optional<std::string> preset;  ///< as the body's
  std::optional<double> youngs_modulus_Pa;
  std::optional<double> poissons_ratio;
  std::optional<double> density_kg_m3;
  std::optional<double> viscosity_Pa_s;

  bool operator==(const ElasticRegion&) const = default;
};

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
  std::optional<FillSettings> fill;  ///< of shapes that are a surface alone; no value: its defaults
  /// Each must hold a tetrahedron that is in none after it: the later one has it.
  std::vector<ElasticRegion> regions;

  /// The material of a region: numbers alone, without a preset and without regions.
  ElasticSettings materialOf(const ElasticRegion& region) const;

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
void applyPreset(ElasticRegion& region);

}  // namespace fissure
