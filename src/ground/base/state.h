#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/geometry.h"
#include "base/tool_nodes.h"

namespace fissure {

/// A tool at the end of a step.
struct ToolState {
  Pose pose;
  /// Velocity of the tool's origin in the scene frame: the mean over the step, or, for a tool that contacts
  /// push, the value at the end of the step.
  Vec3 velocity_m_s = Vec3::Zero();
  Vec3 angular_velocity_rad_s = Vec3::Zero();  ///< scene frame, mean over the step
};

/// A clamp at the end of a step; its jaws are tools.
struct ClampState {
  Pose pose;
  double opening = 0;  ///< degrees where jaws are hinged, else metres
};

/// A tool on a virtual coupling at the end of a step.
struct CouplingState {
  std::size_t tool = 0;                 ///< index in Scene::tools
  Vec3 target_m;                        ///< where the prescribed motion puts the tool's origin, scene frame
  Vec3 force_on_tool_N = Vec3::Zero();  ///< force of the virtual coupling, scene frame
};

/// One force law evaluated over all bodies in one step. Forces act ON THE TOOLS, in newtons in the scene
/// frame.
struct ForceSample {
  Vec3 force_on_tool_N = Vec3::Zero();  ///< sum over triangles and tools
  double elastic_N = 0;                 ///< sum of the triangles' elastic terms (magnitudes)
  double viscous_N = 0;                 ///< sum of the triangles' viscous terms (signed magnitudes)
  /// Number of triangles whose formula would have pulled; their force was set to 0.
  int adhesion_clamped = 0;
  /// Over the triangles in a colliding state, by the law's own kind of deformation; 0 when there are none.
  double deformation_max_m = 0, deformation_mean_m = 0;
  double rate_max_m_s = 0, rate_min_m_s = 0, rate_mean_m_s = 0;  ///< positive while deformation grows
};

/// Arguments of a force law for one colliding triangle. The triangle's force on the tools is the law's
/// magnitude (for a law per area: times the area) times `direction`.
struct LawInput {
  double deformation_m = 0;  ///< x of the law (contact/METHOD.md 12)
  double rate_m_s = 0;       ///< x', positive while x grows
  double area_m2 = 0;        ///< area of the triangle at rest
  /// Force on all tools together per newton of the law, scene frame; shorter than 1 where opposing contacts
  /// cancel.
  Vec3 direction = Vec3::Zero();
};

/// Wall time of one step, microseconds; NaN for the initial state.
struct StepTiming {
  double step_us = 0;       ///< the whole step, engine and contacts, without measuring and writing
  double collision_us = 0;  ///< the part of it that contacts between tool and tissue take
};

/// The outcome of the contact stage in one step: which tissue vertices and tool nodes have contacts, the
/// numbers of contacts, and the reactions on the tools in the scene frame. [node] and [vertex] arrays as in
/// State.
struct ContactOutcome {
  std::vector<NodeState> node_states;        ///< [node]; empty when the pipeline uses no nodes
  std::vector<std::uint8_t> vertex_contact;  ///< [vertex] 1: in a colliding state with a tool
  int candidate_count = 0;                   ///< contacts the detector proposed in this step
  int infeasible_count = 0;                  ///< candidates that their partner excluded
  /// Contacts that act on tissue: feasible candidates and contacts of tissue vertices.
  int contact_count = 0;
  int capped_count = 0;  ///< acting contacts that were limited by the displacement cap
  /// Momentum that tool contacts took from the tissue in the step, over dt. With response none it is mass
  /// times displacement over dt squared, which is no change of momentum. NaN where the engine does not report
  /// it.
  Vec3 reaction_on_tool_N = Vec3::Zero();
  /// [tool] the same on each of several tools; empty where the engine does not report the shares.
  std::vector<Vec3> tool_reactions_N;
  /// Momentum that contacts with the ground took from the tissue in the step, over dt; no value where there
  /// is no ground or the engine does not report it.
  std::optional<Vec3> ground_reaction_N;
  /// Work of the tools on the tissue in the step: the force of each contact times the displacement of its
  /// tool point. NaN with response none and for Bullet's own contacts, where it is not known.
  double tool_work_J = std::numeric_limits<double>::quiet_NaN();
};

/// State of the volume of an elastic body beside that of its surface, and its energy (elastic/METHOD.md 8):
/// kinetic + stored + gravity + losses - contact work is constant.
struct VolumeState {
  Vec3 momentum_kg_m_s = Vec3::Zero();  ///< sum over all vertices
  double kinetic_J = 0;                 ///< sum over all vertices
  double stored_J = 0;                  ///< elastic energy; 0 at rest
  double gravity_J = 0;                 ///< potential energy; 0 at rest
  double viscous_loss_J = 0;            ///< cumulative over the run, as are the losses and works below
  double mass_damping_loss_J = 0;
  double contact_work_J = 0;  ///< done by contacts on the tissue
  double tool_work_J = 0;     ///< done by tools; its excess over contact work is lost in contacts
  /// [surface vertex] normal stress of the contacts on the tissue, mean over the step, positive in
  /// compression: the contact force on the vertex along its normal over a third of the area of its triangles.
  std::vector<double> pressures_Pa;
  int substeps = 0;           ///< number of substeps in the step
  int inverted_elements = 0;  ///< tetrahedra turned inside out
};

/// Everything that is known at the end of a step, whatever the engine. [vertex] arrays cover the surface
/// vertices of all bodies and [node] arrays the nodes of all tools, concatenated in the Scene's order; all
/// vectors are in the scene frame. One object lives through a run and is overwritten in every step.
struct State {
  std::int64_t step = 0;  ///< 0: the initial state, after settling
  double time_s = 0;      ///< step number times dt
  bool is_last = false;   ///< no step follows: the run is over, or something is not finite
  /// Whether this is one of each `every`-th states from the first, or the last.
  bool isOneOf(int every) const { return step % every == 0 || is_last; }
  /// [vertex] at the end of the step, scene frame.
  std::vector<Vec3> positions_m;
  /// [vertex] of the engine; with response none they do not follow contact displacements.
  std::vector<Vec3> velocities_m_s;
  std::vector<double> masses_kg;  ///< [vertex] constant over a run; 0: the vertex is fixed
  std::vector<ToolState> tools;
  std::vector<ClampState> clamps;
  std::vector<CouplingState> couplings;

  ContactOutcome contact;
  std::optional<VolumeState> volume;  ///< only where there is an elastic body
  std::vector<ForceSample> forces;    ///< [law], in the scenario's order
  /// [law x number of tools + tool]; over tools they sum up to the law's force.
  std::vector<Vec3> tool_forces_N;
  /// Triangles with at least one vertex in a colliding state, as ascending indices over all bodies; empty
  /// without force laws. Then the force of each on all tools together: [triangle x number of laws + law].
  std::vector<int> colliding_triangles;
  std::vector<Vec3> triangle_forces_N;
  /// Arguments of each law for each of these triangles, in the same order; empty unless the scenario asks for
  /// it.
  std::vector<LawInput> law_inputs;
  StepTiming timing;
};

}  // namespace fissure
