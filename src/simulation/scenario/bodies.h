#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/elastic.h"
#include "scenario/regions.h"
#include "scenario/shapes.h"

namespace fissure {

/// Bullet's btSoftBody::Material, for all links of a body. Dimensionless, 0..1.
struct MaterialSettings {
  double linear_stiffness = 1.0;   ///< m_kLST
  double angular_stiffness = 1.0;  ///< m_kAST
  double volume_stiffness = 1.0;   ///< m_kVST

  bool operator==(const MaterialSettings&) const = default;
};

/// Where drag and lift act on a soft body: Bullet's eAeroModel, in its order.
enum class AeroModel {
  V_Point,
  V_TwoSided,
  V_TwoSidedLiftDrag,
  V_OneSided,
  F_TwoSided,
  F_TwoSidedLiftDrag,
  F_OneSided,
};

/// What two soft bodies do when they meet.
enum class SoftContact {
  none,      ///< they ignore each other
  vertices,  ///< Bullet's vertices of each against faces of the other
  clusters,  ///< Bullet's clusters of both
};

/// Bullet's btSoftBody::Config, field by field, with Bullet's own defaults.
struct SolverSettings {
  double velocity_correction = 1.0;  ///< kVCF, Baumgarte factor of the drift solver, >= 0
  double damping = 0.0;              ///< kDP, share of velocity lost in a step, 0..1
  double drag = 0.0;                 ///< kDG, >= 0
  double lift = 0.0;                 ///< kLF, >= 0
  double pressure = 0.0;             ///< kPR
  double volume_conservation = 0.0;  ///< kVC, >= 0
  double dynamic_friction = 0.2;     ///< kDF, 0..1
  double pose_matching = 0.0;        ///< kMT, 0..1: share of the way to the matched rest shape in a step
  double rigid_hardness = 1.0;       ///< kCHR, 0..1: contacts with dynamic bodies
  double soft_hardness = 1.0;        ///< kSHR, 0..1: contacts with soft bodies
  double anchor_hardness = 0.7;      ///< kAHR, 0..1
  double max_volume = 1.0;           ///< maxvolume, of pose matching, > 0
  double time_scale = 1.0;           ///< timescale, > 0: its own time over the scene's (reaction: README)
  int velocity_iterations = 0;       ///< viterations, 0..1000
  int position_iterations = 1;       ///< piterations, 1..1000
  int drift_iterations = 0;          ///< diterations, 0..1000
  AeroModel aero_model = AeroModel::V_Point;  ///< aeromodel, for drag and lift

  bool operator==(const SolverSettings&) const = default;
};

/// Bullet's clusters of tissue vertices, each moved as one rigid piece by its contacts. Built only where the
/// pipeline `cluster` or `soft_contact: clusters` needs them; Bullet's own defaults but the count, which has
/// none.
struct ClusterSettings {
  int count = 32;                   ///< 0: one for each triangle, else 1..65536
  int iterations = 4;               ///< citerations, 1..1000
  double rigid_hardness = 0.1;      ///< kSRHR_CL, 0..1: with dynamic bodies
  double kinematic_hardness = 1.0;  ///< kSKHR_CL, 0..1: with tools
  double soft_hardness = 0.5;       ///< kSSHR_CL, 0..1: with soft bodies
  double rigid_split = 0.5;         ///< kSR_SPLT_CL, 0..1: share of the overlap removed as displacement
  double kinematic_split = 0.5;     ///< kSK_SPLT_CL, 0..1
  double soft_split = 0.5;          ///< kSS_SPLT_CL, 0..1
  double node_damping = 0.0;        ///< m_ndamping, 0..1
  double linear_damping = 0.0;      ///< m_ldamping, 0..1
  double angular_damping = 0.0;     ///< m_adamping, 0..1
  double matching = 0.0;            ///< m_matching, 0..1

  bool operator==(const ClusterSettings&) const = default;
};

/// Vertices of a body that never move, wherever they are at time zero: exactly one of the two.
struct FixedRegion {
  std::optional<double> below_m;  ///< those at this height or below it
  std::optional<BoxRegion> box;   ///< those inside, in the scene's frame

  bool operator==(const FixedRegion&) const = default;
};

/// Vertices of a body whose mean displacement is a result: how far an opening was opened, a rim pushed.
struct GaugeSettings {
  std::string name;  ///< unique in the scenario
  BoxRegion box;     ///< those inside, in the scene's frame, where the body is placed; at least one

  bool operator==(const GaugeSettings&) const = default;
};

/// A soft body over a closed triangle surface: Bullet's spring shell, or finite elements inside. Fields from
/// mass_kg to pose_frame but margin_m, soft_contact, material, solver and clusters are the shell's.
struct BodySettings {
  std::string name;
  SurfaceShape shape;
  Vec3 position_m = Vec3::Zero();       ///< of the shape's own origin at time zero
  Quat orientation = Quat::Identity();  ///< x, y, z, w in files
  double mass_kg = 0.1;                 ///< of the whole body, > 0; the share of fixed vertices never moves
  bool mass_from_faces = false;  ///< false: the same mass for each vertex; true: by the area of its faces
  double margin_m = 0.0005;      ///< collision margin, > 0; Bullet's own default is 0.25
  int bending_distance = 2;      ///< links between vertices this many links apart; 0: none, else 2..5
  bool randomize_links = true;   ///< Bullet's fixed shuffle of links and faces
  bool pose_volume = true;       ///< setPose(volume, .): remember the rest volume
  bool pose_frame = true;        ///< setPose(., frame): remember the rest shape, for pose matching
  SoftContact soft_contact = SoftContact::none;  ///< with another body that says the same
  std::vector<FixedRegion> fixed;  ///< an organ on its bed; each must hold at least one vertex, all not all
  MaterialSettings material;
  SolverSettings solver;
  ClusterSettings clusters;
  std::vector<GaugeSettings> gauges;
  BodyModel model = BodyModel::shell;
  ElasticSettings elastic;

  bool isElastic() const { return model == BodyModel::elastic; }
  /// Whether it is elastic and its shape a surface alone, whose inside the mesher fills.
  bool isFilledByMesher() const {
    return isElastic() &&
           (std::holds_alternative<TrianglesShape>(shape) || std::holds_alternative<FileShape>(shape));
  }
  /// Coulomb's coefficient of the tissue; times that of what it touches.
  double friction() const { return isElastic() ? elastic.friction : solver.dynamic_friction; }
  /// The body's own time over the scene's.
  double timeScale() const { return isElastic() ? 1 : solver.time_scale; }

  /// Writes the mesher's defaults into their field, so that a stored scenario says every number that was
  /// used.
  void fillDefaults() {
    if (isFilledByMesher() && !elastic.fill) elastic.fill.emplace();
  }

  bool operator==(const BodySettings&) const = default;
};

}  // namespace fissure
