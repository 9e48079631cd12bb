#pragma once

#include <optional>
#include <string>

#include "scenario/catalog.h"
#include "scenario/deformable.h"
#include "scenario/pipeline_table.h"

namespace fissure {

/// The floating-point precision of the engine's own state.
enum class Precision { f64, f32 };

/// The choice between a pipeline's two sets of defaults for Bullet's contact.
enum class SettingsPreset {
  stock,  ///< Bullet's defaults
  tuned,  ///< finer and harder: PipelineTraits::tuned
};

/// One entry of `pipelines:`: one run in a process of its own, whose result has this `name`. A field without
/// a value has the default of `settings` or of the pipeline's entry in pipeline_table.
struct PipelineSettings {
  std::string name;
  PipelineKind pipeline = PipelineKind::default_sdf;
  Precision precision = Precision::f64;
  SettingsPreset settings = SettingsPreset::stock;
  std::optional<double> sdf_voxel_m;
  std::optional<double> kinematic_hardness;
  DeformableContacts contacts = DeformableContacts::faces;
  DeformableSolver deformable;
  std::optional<double> ray_length_m;
  std::optional<bool> vertex_contacts;
  std::optional<ContactResponse> response;
  std::optional<GroundKind> ground_contact;
  int sweeps = 30;
  double max_displacement_m = 0.005;
  int rounds = 4;
  double time_limit_s = 3600;

  const PipelineTraits& traits() const { return traitsOf(pipeline); }
  bool usesNodes() const { return traits().detection == ContactDetection::nodes; }
  bool usesSurface() const { return traits().detection == ContactDetection::surface; }
  bool usesSdf() const { return traits().detection == ContactDetection::sdf; }
  bool usesVolume() const { return traits().detection == ContactDetection::volume; }
  /// Whether tissue vertices are looked up in cells of a tool's signed distance field.
  bool hasVoxels() const { return usesSdf() || (usesVolume() && contacts == DeformableContacts::nodes); }
  bool usesClusters() const { return traits().detection == ContactDetection::clusters; }
  /// Whether contacts have friction: all but those of nodes with response none.
  bool hasFriction() const { return !usesNodes() || contactResponse() == ContactResponse::momentum; }

  const BulletTuning& tuning() const {
    return settings == SettingsPreset::tuned ? traits().tuned : traits().stock;
  }
  double sdfVoxel_m() const { return sdf_voxel_m.value_or(tuning().sdf_voxel_m); }
  /// The settings for a body of this material, defaults filled in.
  DeformableSolver deformableSolver(ElasticMaterialKind material) const {
    return withDefaults(deformable, settings == SettingsPreset::tuned, material);
  }
  double kinematicHardness() const { return kinematic_hardness.value_or(tuning().kinematic_hardness); }
  bool vertexContacts() const { return vertex_contacts.value_or(traits().vertex_contacts); }
  ContactResponse contactResponse() const { return response.value_or(traits().response); }
  GroundKind groundContact() const { return ground_contact.value_or(traits().ground_contact); }
  /// Whether the ground is an obstacle of the pipeline's own contacts, not of Bullet's.
  bool ownGround() const { return groundContact() == GroundKind::half_space; }

  /// Sets the fields without a value to these defaults, so that a stored scenario has every number that was
  /// used, except the least number of cluster iterations and the substeps of Bullet's deformable world.
  /// `ground_contact` stays as it is. `material`: that of the first body.
  void fillDefaults(ElasticMaterialKind material);

  bool operator==(const PipelineSettings&) const = default;
};

template <class Io>
void describe(Io& io, PipelineSettings& p) {
  using enum ContactDetection;
  using Traits = PipelineTraits;
  io.field("name", p.name,
           Key("Name of the run, once in the scenario; it keys the result.").itemName().sameAs("pipeline"));
  io.field("pipeline", p.pipeline, Key("How tools meet tissue.").oneOf(catalog().pipelines).required());
  const bool rays = p.usesNodes(), ours = rays || p.usesSurface(), world = p.usesVolume();
  const std::string with_rays = pipelinesWith({nodes}), with_ours = pipelinesWith({nodes, surface}),
                    with_volume = pipelinesWith({volume}), with_sdf = pipelinesWith({sdf});
  io.field("precision", p.precision,
           Key("Floating-point precision of Bullet's own state.").oneOf(catalog().precisions));
  io.field("settings", p.settings,
           Key("Which values stand for settings of Bullet's contact that have none of their own.")
               .oneOf(catalog().settings)
               .onlyIf(p.usesSdf() || p.usesClusters() || world, pipelinesWith({sdf, clusters, volume})));
  io.field("contacts", p.contacts,
           Key("What of the tissue Bullet's deformable world tests against tools.")
               .oneOf(catalog().deformable_contacts)
               .onlyIf(world, with_volume));
  io.field("sdf_voxel_m", p.sdf_voxel_m,
           Key("Cell of the signed distance field of tools [btSparseSdf].")
               .above(0)
               .otherwise(tuningDefault(&BulletTuning::sdf_voxel_m))
               .onlyIf(p.hasVoxels(), with_sdf + ", or " + with_volume + " with contacts nodes"));
  io.field("kinematic_hardness", p.kinematic_hardness,
           Key("Share of the overlap with a tool that Bullet's contact removes in an iteration [kKHR].")
               .share()
               .otherwise(tuningDefault(&BulletTuning::kinematic_hardness))
               .onlyIf(p.usesSdf(), with_sdf));
  io.field("deformable", p.deformable,
           Key("Settings of Bullet's deformable world, under Bullet's names where it has some.")
               .onlyIf(world, with_volume));
  io.field("ray_length_m", p.ray_length_m,
           Key("Length L of the rays cast from nodes.")
               .above(0)
               .otherwise("the extent of each body at rest, at least the travel in a step")
               .onlyIf(rays, with_rays));
  io.field("vertex_contacts", p.vertex_contacts,
           Key("Whether tissue vertices and edges that slip in between the nodes of a box tool are held too, "
               "each on the side it came from (beyond the paper). A tool that starts inside tissue has its "
               "nodes alone until it has been free of it.")
               .otherwise(nodeDefault(
                   [](const Traits& of) { return std::string(of.vertex_contacts ? "true" : "false"); }))
               .onlyIf(rays, with_rays));
  io.field(
      "response", p.response,
      Key("What contacts do to the tissue's momentum; none is the paper's.")
          .oneOf(catalog().responses)
          .otherwise(nodeDefault([](const Traits& of) { return nameIn(catalog().responses, of.response); }))
          .onlyIf(rays, with_rays));
  io.field("ground_contact", p.ground_contact,
           Key("What tissue stands on; half_space is the ground of swept and needs response momentum, "
               "because displacement alone carries no weight.")
               .oneOf(catalog().ground_contacts)
               .otherwise(nodeDefault(
                   [](const Traits& of) { return nameIn(catalog().ground_contacts, of.ground_contact); }))
               .onlyIf(rays, with_rays));
  io.field("sweeps", p.sweeps,
           Key("Gauss-Seidel sweeps over the contacts in a step.").count(1, 1000).onlyIf(ours, with_ours));
  io.field("max_displacement_m", p.max_displacement_m,
           Key("How far a contact may move tissue in a step beyond what node and tissue approached in it: a "
               "tool that starts inside tissue is freed over several steps. In swept: how far such a tool is "
               "freed in a step.")
               .above(0)
               .onlyIf(ours, with_ours));
  io.field("rounds", p.rounds,
           Key("Responses in a step to what crosses a tool after the one to what is near it. Tissue that "
               "still crosses then is stopped on its way (`truncated_steps` of the summary).")
               .count(0, 10)
               .onlyIf(p.usesSurface(), pipelinesWith({surface})));
  io.field("time_limit_s", p.time_limit_s,
           Key("Wall-clock time after which the run is stopped and recorded as timeout.").above(0));
}

}  // namespace fissure
