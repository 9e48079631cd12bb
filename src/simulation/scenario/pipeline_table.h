#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/contact_response.h"

namespace fissure {

/// A collision pipeline: how tools meet tissue. `default_sdf` is called "default" and `null_sdf` "null" in
/// files.
enum class PipelineKind { default_sdf, null_sdf, cluster, deformable, raycast, fukuhara, swept, prescribed };

/// The method by which a pipeline finds contacts.
enum class ContactDetection {
  sdf,       ///< Bullet tests tissue vertices against the tool's signed distance field
  clusters,  ///< Bullet tests clusters of tissue vertices against the tool
  volume,    ///< Bullet's world of tetrahedra tests tissue vertices or triangles against the tool
  nodes,     ///< rays are cast from nodes on the tool; the run's `response` says how contacts act
  surface,   ///< all of the tool's surface is tested against all of the tissue's
  sticking,  ///< tissue vertices stick to a tool that reaches them
};

/// The requirement of a pipeline on every rigid tool.
enum class ToolNeed {
  convex_and_closed,  ///< a surface that bounds a convex solid
  box,
  surface,  ///< any surface
  nodes,    ///< a surface on which at least one node can stand
};

/// The method for contact of tissue with the ground.
enum class GroundKind {
  bullet,      ///< Bullet's own contact
  half_space,  ///< a further obstacle of the pipeline's own contacts (contact/METHOD.md 11)
};

/// The values of Bullet's own contact that `settings` chooses together.
struct BulletTuning {
  double sdf_voxel_m = 0;
  double kinematic_hardness = 0;
  int least_cluster_iterations = 1;  ///< a lower bound on a body's own number
};

inline constexpr BulletTuning stock_tuning{.sdf_voxel_m = 0.25, .kinematic_hardness = 0.1};
inline constexpr BulletTuning fine_tuning{.sdf_voxel_m = 0.0005, .kinematic_hardness = 1.0};
inline constexpr BulletTuning stock_deformable_tuning{.sdf_voxel_m = 0.005};
inline constexpr BulletTuning fine_cluster_tuning{
    .sdf_voxel_m = 0.0005, .kinematic_hardness = 1.0, .least_cluster_iterations = 20};

/// The static properties of a pipeline.
struct PipelineTraits {
  PipelineKind kind;
  std::string_view name;         ///< its name in files, results and messages
  std::string_view description;  ///< one line, for people; results store it
  ContactDetection detection;
  ToolNeed need;
  /// Whether infeasible candidates are excluded by node association (contact/METHOD.md 4); detection by nodes
  /// only.
  bool association = false;
  /// Default of a run's `vertex_contacts` and `response`; detection by nodes only.
  bool vertex_contacts = false;
  ContactResponse response = ContactResponse::none;
  /// Default of a run's `ground_contact`; only detection by nodes can have either.
  GroundKind ground_contact = GroundKind::bullet;
  /// The values of settings "stock" and "tuned" for this pipeline.
  BulletTuning stock = stock_tuning;
  BulletTuning tuned = fine_tuning;
};

/// Every pipeline, in the order of PipelineKind. Reading, writing, validation, `list`, the plan and stored
/// descriptions read this table; the engine has a factory for each entry (engine/pipeline.h).
inline constexpr auto pipeline_table = std::to_array<PipelineTraits>({
    {.kind = PipelineKind::default_sdf,
     .name = "default",
     .description =
         "Bullet's own soft-rigid contact: tissue vertices against the tool's signed distance field",
     .detection = ContactDetection::sdf,
     .need = ToolNeed::convex_and_closed},
    {.kind = PipelineKind::null_sdf,
     .name = "null",
     .description = "(write it in quotes) default behind a detector of ours that only delegates; must equal "
                    "default bit for bit",
     .detection = ContactDetection::sdf,
     .need = ToolNeed::convex_and_closed},
    {.kind = PipelineKind::cluster,
     .name = "cluster",
     .description = "Bullet's own contact of clusters: pieces of tissue against the convex tool (GJK)",
     .detection = ContactDetection::clusters,
     .need = ToolNeed::convex_and_closed,
     .tuned = fine_cluster_tuning},
    {.kind = PipelineKind::deformable,
     .name = "deformable",
     .description = "Bullet's own world of finite elements with its own contact, for a body of model elastic",
     .detection = ContactDetection::volume,
     .need = ToolNeed::convex_and_closed,
     .stock = stock_deformable_tuning},
    {.kind = PipelineKind::raycast,
     .name = "raycast",
     .description =
         "node ray casting and enforced displacement, without node association (paper, Fig. 3 right)",
     .detection = ContactDetection::nodes,
     .need = ToolNeed::nodes},
    {.kind = PipelineKind::fukuhara,
     .name = "fukuhara",
     .description = "the full method: node ray casting, infeasible pairs excluded, contacts as impulses",
     .detection = ContactDetection::nodes,
     .need = ToolNeed::nodes,
     .association = true,
     .vertex_contacts = true,
     .response = ContactResponse::momentum},
    {.kind = PipelineKind::swept,
     .name = "swept",
     .description =
         "to use where no tool may enter tissue, nor tissue the ground: all of its surface against all of "
         "the tissue's, on the path of the step; not tissue on tissue",
     .detection = ContactDetection::surface,
     .need = ToolNeed::surface,
     .response = ContactResponse::momentum,
     .ground_contact = GroundKind::half_space},
    {.kind = PipelineKind::prescribed,
     .name = "prescribed",
     .description =
         "reference without contact detection: tissue vertices that a box tool reaches stick to it",
     .detection = ContactDetection::sticking,
     .need = ToolNeed::box},
});

/// The table entry of a pipeline.
constexpr const PipelineTraits& traitsOf(PipelineKind kind) {
  return pipeline_table[static_cast<std::size_t>(kind)];
}

/// The defaults of one value in words: "stock 0.25, tuned 0.0005 (pipeline deformable: stock 0.005 ...)".
std::string tuningDefault(double BulletTuning::*value);

/// The texts that `textOf` returns for the pipelines that use nodes, as in "raycast false, fukuhara true".
std::string nodeDefault(std::string (*textOf)(const PipelineTraits&));

/// The names of the pipelines with one of these detections, for messages: "pipelines default, null and
/// cluster", or "pipeline cluster".
std::string pipelinesWith(std::initializer_list<ContactDetection> detections);

}  // namespace fissure
