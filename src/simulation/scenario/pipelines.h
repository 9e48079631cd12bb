#pragma once

#include <optional>
#include <string>

namespace fissure {

/// One entry of `pipelines:`: one run, in a process of its own; `name` keys the result.
struct PipelineSettings {
  std::string name;               ///< unique; default: the pipeline's
  std::string pipeline;           ///< a name in catalog().pipelines
  std::string precision = "f64";  ///< of the engine's own state
  /// "stock": Bullet's defaults for the two fields below; "tuned": 0.0005 m and 1. For pipeline `cluster`,
  /// "tuned" is at least 20 cluster iterations.
  std::string settings = "stock";

  /// Bullet's own contact with the tool (pipelines `default`, `null`); no value: as `settings` says.
  std::optional<double> sdf_voxel_m;         ///< cell of btSparseSdf, > 0; Bullet's default 0.25
  std::optional<double> kinematic_hardness;  ///< kKHR, 0..1; Bullet's default 0.1

  /// Ray casting pipelines.
  /// L; default: the extent of each body at rest, at least the travel in a step.
  std::optional<double> ray_length_m;
  /// Beyond the paper: also hold tissue vertices and edges that slip in between the nodes of a box tool, each
  /// on the side it came from; a tool that starts inside tissue has its nodes alone until it has been free of
  /// it. Default: yes for fukuhara, no for raycast; `false` is the paper's method alone.
  std::optional<bool> vertex_contacts;
  /// A name in catalog().responses: what contacts do to the tissue's momentum. Default: momentum for
  /// fukuhara, none (the paper's) for raycast.
  std::optional<std::string> response;
  int sweeps = 30;  ///< Gauss-Seidel sweeps over the contacts, 1..1000
  /// How far a contact may move tissue in one step beyond what node and tissue approached in it (METHOD:
  /// feasibility): a tool that starts inside is pushed free over several steps; what it stretched by then
  /// snaps back as elastic tissue does. > 0
  double max_displacement_m = 0.005;

  double time_limit_s = 3600;  ///< wall clock; a run beyond it is stopped and recorded as "timeout"; > 0

  /// Whether this pipeline detects contacts with tool nodes.
  bool usesNodes() const { return pipeline == "raycast" || pipeline == "fukuhara"; }
  /// Whether Bullet tests tissue vertices against the tool's signed distance field.
  bool usesSdf() const { return pipeline == "default" || pipeline == "null"; }
  /// Whether Bullet tests clusters of tissue vertices against the tool.
  bool usesClusters() const { return pipeline == "cluster"; }
  /// The fewest cluster iterations that `settings` asks for.
  int leastClusterIterations() const { return usesClusters() && settings == "tuned" ? 20 : 1; }

  /// The optional fields with their defaults applied.
  double sdfVoxel_m() const { return sdf_voxel_m.value_or(settings == "tuned" ? 0.0005 : 0.25); }
  double kinematicHardness() const { return kinematic_hardness.value_or(settings == "tuned" ? 1.0 : 0.1); }
  bool vertexContacts() const { return vertex_contacts.value_or(pipeline == "fukuhara"); }
  std::string contactResponse() const {
    return response.value_or(pipeline == "fukuhara" ? "momentum" : "none");
  }

  /// Writes these defaults into their fields, so that a stored scenario says every number that was used (but
  /// for leastClusterIterations, which `settings` stands for).
  void fillDefaults() {
    if (usesNodes()) {
      vertex_contacts = vertexContacts();
      response = contactResponse();
    }
    if (usesSdf()) {
      sdf_voxel_m = sdfVoxel_m();
      kinematic_hardness = kinematicHardness();
    }
  }

  bool operator==(const PipelineSettings&) const = default;
};

}  // namespace fissure
