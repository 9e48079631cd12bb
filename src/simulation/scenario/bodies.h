#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/clusters.h"
#include "scenario/elastic.h"
#include "scenario/shapes.h"
#include "scenario/shell.h"
#include "scenario/vertex_groups.h"

namespace fissure {

/// A soft body over a closed triangle surface: Bullet's spring shell, or finite elements inside.
struct BodySettings {
  std::string name;
  SurfaceShape shape;
  Vec3 position_m = Vec3::Zero();
  Quat orientation = Quat::Identity();
  double mass_kg = 0.1;
  bool mass_from_faces = false;
  double margin_m = 0.0005;
  int bending_distance = 2;
  bool randomize_links = true;
  bool pose_volume = true;
  bool pose_frame = true;
  SoftContact soft_contact = SoftContact::none;
  std::vector<FixedRegion> fixed;
  MaterialSettings material;
  SolverSettings solver;
  ClusterSettings clusters;
  std::vector<GaugeSettings> gauges;
  BodyModel model = BodyModel::shell;
  ElasticSettings elastic;

  bool isElastic() const { return model == BodyModel::elastic; }
  /// Whether it is elastic and its shape only a surface, so that the mesher must fill it with tetrahedra.
  bool isFilledByMesher() const {
    return isElastic() &&
           (std::holds_alternative<TrianglesShape>(shape) || std::holds_alternative<FileShape>(shape));
  }
  /// Friction coefficient of the tissue (Coulomb); contacts have its product with that of the tool or the
  /// ground.
  double friction() const { return isElastic() ? elastic.friction : solver.dynamic_friction; }
  /// The body's own time over the scene's (contact/METHOD.md 6).
  double timeScale() const { return isElastic() ? 1 : solver.time_scale; }

  /// Sets `elastic.fill` to the mesher's defaults where it is needed, so that a stored scenario has every
  /// number that was used.
  void fillDefaults() {
    if (isFilledByMesher() && !elastic.fill) elastic.fill.emplace();
  }

  bool operator==(const BodySettings&) const = default;
};

template <class Io>
void describe(Io& io, BodySettings& b) {
  io.field("name", b.name,
           Key("Name of the body, once among the bodies: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.tagged(
      "shape", b.shape,
      Key("Closed surface of the body, in the body's own frame.").oneOf(catalog().body_shapes).required());
  io.field("position_m", b.position_m,
           Key("Where the shape's own origin is at time zero, in the scene's frame."));
  io.field("orientation", b.orientation,
           Key("Rotation of the body at time zero, a unit quaternion [x, y, z, w].").noUnit());
  io.field("model", b.model,
           Key("What the body consists of: springs along its surface, or finite elements in its volume.")
               .oneOf(catalog().body_models));
  const bool shell = !b.isElastic();
  const char* const of_shell = "model shell";
  io.field("mass_kg", b.mass_kg,
           Key("Mass of the whole body, that of fixed vertices included.").above(0).onlyIf(shell, of_shell));
  io.field(
      "mass_from_faces", b.mass_from_faces,
      Key("Whether a vertex has the mass of the area of its faces; else all vertices have the same mass.")
          .onlyIf(shell, of_shell));
  io.field(
      "margin_m", b.margin_m,
      Key("Collision margin around the surface, within which contact begins. Bullet's own default is 0.25 m.")
          .above(0));
  io.field("bending_distance", b.bending_distance,
           Key("Vertices that are this many links apart are joined by bending links; 0 makes none.")
               .count(2, 5)
               .orZero("no bending links")
               .onlyIf(shell, of_shell));
  io.field("randomize_links", b.randomize_links,
           Key("Whether links and faces are shuffled, always alike, as Bullet does against drift.")
               .onlyIf(shell, of_shell));
  io.field("pose_volume", b.pose_volume,
           Key("Whether the volume at rest is remembered, for `solver.volume_conservation` [setPose].")
               .onlyIf(shell, of_shell));
  io.field("pose_frame", b.pose_frame,
           Key("Whether the shape at rest is remembered, for `solver.pose_matching` [setPose].")
               .onlyIf(shell, of_shell));
  io.field("soft_contact", b.soft_contact,
           Key("How the body meets another one that says the same.")
               .oneOf(catalog().soft_contacts)
               .onlyIf(shell, of_shell));
  io.field("fixed", b.fixed,
           Key("Regions whose vertices never move, as an organ is fixed on its bed; each must hold at least "
               "one vertex, and some vertex must be in none."));
  io.field("elastic", b.elastic,
           Key("Material of finite elements, in SI units.").onlyIf(b.isElastic(), "model elastic"));
  io.field("material", b.material,
           Key("Stiffness of Bullet's links: shares without a unit, no moduli.").onlyIf(shell, of_shell));
  io.field("solver", b.solver,
           Key("Settings of Bullet's soft-body solver, with Bullet's own defaults.").onlyIf(shell, of_shell));
  io.field("clusters", b.clusters,
           Key("Bullet's clusters of vertices, built where the pipeline `cluster` or `soft_contact: "
               "clusters` needs them.")
               .onlyIf(shell, of_shell));
  io.field("gauges", b.gauges,
           Key("Groups of vertices whose mean displacement since time zero is recorded.").items(0));
}

}  // namespace fissure
