#pragma once

#include <optional>
#include <string>

#include "scenario/deformable.h"
#include "scenario/pipeline_table.h"

namespace fissure {

/// The floating-point precision of the engine's own state.
enum class Precision { f64, f32 };

/// Which of a pipeline's two tunings of Bullet's contact stands where a field has no value of its own.
enum class SettingsPreset {
  stock,  ///< Bullet's defaults
  tuned,  ///< finer and harder: what PipelineTraits::tuned says
};

/// One entry of `pipelines:`: one run, in a process of its own; `name` keys the result.
struct PipelineSettings {
  std::string name;  ///< unique; default: the pipeline's
  PipelineKind pipeline = PipelineKind::default_sdf;
  Precision precision = Precision::f64;
  /// Says the default of the two fields below, and for pipeline `cluster` the least number of iterations.
  SettingsPreset settings = SettingsPreset::stock;

  /// Bullet's own contact with the tool (pipelines `default`, `null`); no value: as `settings` says.
  std::optional<double> sdf_voxel_m;         ///< cell of btSparseSdf, > 0; Bullet's default 0.25
  std::optional<double> kinematic_hardness;  ///< kKHR, 0..1; Bullet's default 0.1

  /// Bullet's deformable world (pipeline `deformable`).
  DeformableContacts contacts = DeformableContacts::faces;
  DeformableSolver deformable;

  /// Ray casting pipelines.
  /// L; default: the extent of each body at rest, at least the travel in a step.
  std::optional<double> ray_length_m;
  /// Beyond the paper: also hold tissue vertices and edges that slip in between the nodes of a box tool, each
  /// on the side it came from; a tool that starts inside tissue has its nodes alone until it has been free of
  /// it. Default: the pipeline's, yes for fukuhara, no for raycast; `false` is the paper's method alone.
  std::optional<bool> vertex_contacts;
  /// What contacts do to the tissue's momentum. Default: the pipeline's, momentum for fukuhara, none (the
  /// paper's) for raycast.
  std::optional<ContactResponse> response;
  /// What tissue stands on. Default: the pipeline's, Bullet's contact for both; `half_space` is the ground of
  /// swept, and asks for response momentum: displacement alone carries no weight.
  std::optional<GroundKind> ground_contact;

  /// Ray casting pipelines, and swept.
  int sweeps = 30;  ///< Gauss-Seidel sweeps over the contacts, 1..1000
  /// How far a contact may move tissue in one step beyond what node and tissue approached in it (METHOD:
  /// feasibility): a tool that starts inside is pushed free over several steps; what it stretched by then
  /// snaps back as elastic tissue does. Swept: how far such a tool is freed in a step. > 0
  double max_displacement_m = 0.005;
  /// Swept: responses in a step to what crosses a tool after the one to what is near it, 0..10. Each looks
  /// for crossings that the last one left or made; tissue that still crosses a tool then is stopped on its
  /// way
  /// (`truncated_steps` of the summary). 0: no response at all.
  int rounds = 4;

  double time_limit_s = 3600;  ///< wall clock; a run beyond it is stopped and recorded as "timeout"; > 0

  const PipelineTraits& traits() const { return traitsOf(pipeline); }
  bool usesNodes() const { return traits().detection == ContactDetection::nodes; }
  bool usesSurface() const { return traits().detection == ContactDetection::surface; }
  bool usesSdf() const { return traits().detection == ContactDetection::sdf; }
  bool usesVolume() const { return traits().detection == ContactDetection::volume; }
  /// Whether tissue vertices are looked up in cells of a tool's signed distance field.
  bool hasVoxels() const { return usesSdf() || (usesVolume() && contacts == DeformableContacts::nodes); }
  bool usesClusters() const { return traits().detection == ContactDetection::clusters; }
  /// Whether contacts rub: those of nodes only displace tissue unless they respond with momentum.
  bool hasFriction() const { return !usesNodes() || contactResponse() == ContactResponse::momentum; }

  /// What `settings` chooses.
  const BulletTuning& tuning() const {
    return settings == SettingsPreset::tuned ? traits().tuned : traits().stock;
  }
  /// The optional fields with their defaults applied.
  double sdfVoxel_m() const { return sdf_voxel_m.value_or(tuning().sdf_voxel_m); }
  /// Of a body of this material.
  DeformableSolver deformableSolver(ElasticMaterialKind material) const {
    return withDefaults(deformable, settings == SettingsPreset::tuned, material);
  }
  double kinematicHardness() const { return kinematic_hardness.value_or(tuning().kinematic_hardness); }
  bool vertexContacts() const { return vertex_contacts.value_or(traits().vertex_contacts); }
  ContactResponse contactResponse() const { return response.value_or(traits().response); }
  GroundKind groundContact() const { return ground_contact.value_or(traits().ground_contact); }
  /// Whether the ground is an obstacle of the method's own contacts; else it is one of Bullet's.
  bool ownGround() const { return groundContact() == GroundKind::half_space; }

  /// Writes these defaults into their fields, so that a stored scenario says every number that was used (but
  /// for the least number of cluster iterations and the substeps of Bullet's deformable world, which
  /// `settings` stands for). The ground is stored where an entry names it. `material`: of the first body.
  void fillDefaults(ElasticMaterialKind material) {
    if (usesNodes()) {
      vertex_contacts = vertexContacts();
      response = contactResponse();
    }
    if (hasVoxels()) sdf_voxel_m = sdfVoxel_m();
    if (usesSdf()) kinematic_hardness = kinematicHardness();
    if (usesVolume()) deformable = deformableSolver(material);
  }

  bool operator==(const PipelineSettings&) const = default;
};

}  // namespace fissure
