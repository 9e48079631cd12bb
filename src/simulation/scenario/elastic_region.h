#pragma once

#include <optional>
#include <string>

#include "scenario/catalog.h"
#include "scenario/regions.h"

namespace fissure {

/// The largest number of regions of a body; the critical step is searched for each region separately.
inline constexpr std::size_t most_regions = 64;

/// The largest Poisson's ratio that a material may have.
inline constexpr double most_poissons_ratio = 0.4999;

/// A part of an elastic body with its own material coefficients and the body's material law, as a vessel in a
/// liver. Exactly one of tag, box and capsule is given, in the frame of the body's shape: the region has the
/// tetrahedra with this tag, or with their centroid in the box or capsule. Coefficients without a value are
/// those of the body.
struct ElasticRegion {
  std::string name;
  std::optional<int> tag;
  std::optional<BoxRegion> box;
  std::optional<CapsuleRegion> capsule;
  std::optional<std::string> preset;
  std::optional<double> youngs_modulus_Pa;
  std::optional<double> poissons_ratio;
  std::optional<double> density_kg_m3;
  std::optional<double> viscosity_Pa_s;

  bool operator==(const ElasticRegion&) const = default;
};

/// Sets modulus, ratio and density to those of the preset; changes nothing without a preset or with an
/// unknown one.
void applyPreset(ElasticRegion& region);

template <class Io>
void describe(Io& io, ElasticRegion& r) {
  const char* const elsewhere = "`tag`, `box` or `capsule` says where";
  const char* const as_body = "what `preset` of the region says, else the body's";
  io.field("name", r.name, Key("Name of the region, once in the body.").itemName().required());
  io.field("tag", r.tag,
           Key("Physical tag of the region's tetrahedra in the file of a mesh. Exactly one of `tag`, `box` "
               "and `capsule` is given.")
               .noUnit()
               .otherwise(elsewhere));
  io.field(
      "box", r.box,
      Key("The region has the tetrahedra whose centroid is in this box, in the frame of the body's shape.")
          .otherwise(elsewhere));
  io.field("capsule", r.capsule,
           Key("The region has the tetrahedra whose centroid is in this capsule, in the frame of the body's "
               "shape.")
               .otherwise(elsewhere));
  io.field("preset", r.preset,
           Key("A known material, which sets modulus, ratio and density where the region leaves them out.")
               .oneOf(catalog().elastic_presets)
               .otherwise("none"));
  io.whileReading([&] { applyPreset(r); });
  io.field("youngs_modulus_Pa", r.youngs_modulus_Pa,
           Key("Young's modulus of the region at small strain.").above(0).otherwise(as_body));
  io.field("poissons_ratio", r.poissons_ratio,
           Key("Poisson's ratio of the region.").noUnit().between(0, most_poissons_ratio).otherwise(as_body));
  io.field("density_kg_m3", r.density_kg_m3,
           Key("Density of the region at rest.").above(0).otherwise(as_body));
  io.field("viscosity_Pa_s", r.viscosity_Pa_s,
           Key("Viscosity of the region.").atLeast(0).otherwise("the body's"));
}

}  // namespace fissure
