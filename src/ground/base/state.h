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
  /// Of the tool's origin, mean over the step; of a tool that contacts push, at its end.
  Vec3 velocity_m_s = Vec3::Zero();
  Vec3 angular_velocity_rad_s = Vec3::Zero();  ///< scene frame, mean over the step
};

/// A clamp at the end of a step; its jaws are tools.
struct ClampState {
  Pose pose;
  double opening = 0;  ///< degrees of hinged jaws, else metres
};

/// A tool on a virtual coupling at the end of a step.
struct CouplingState {
  std::size_t tool = 0;                 ///< of the scene
  Vec3 target_m;                        ///< where its motion wants its origin, scene frame
  Vec3 force_on_tool_N = Vec3::Zero();  ///< of the coupling
};

/// One force law evaluated over all bodies in one step. Forces act ON THE TOOLS, scene frame, newtons.
struct ForceSample {
  Vec3 force_on_tool_N = Vec3::Zero();  ///< sum over triangles and tools
  double elastic_N = 0;                 ///< sum of the triangles' elastic terms (magnitudes)
  double viscous_N = 0;                 ///< sum of the triangles' viscous terms (signed magnitudes)
  int adhesion_clamped = 0;  ///< triangles whose formula would have pulled; their force was set to 0
  /// Of the triangles in a colliding state, by the law's own kind of deformation; 0 when there are none.
  double deformation_max_m = 0, deformation_mean_m = 0;
  double rate_max_m_s = 0, rate_min_m_s = 0, rate_mean_m_s = 0;  ///< positive while deformation grows
};

/// What a force law sees of one colliding triangle; its force on the tools is its magnitude (per area: times
/// the area) x direction.
struct LawInput {
  double deformation_m = 0;  ///< x, by the law's kind of deformation
  double rate_m_s = 0;       ///< x', by the law's source of rates; positive while x grows
  double area_m2 = 0;        ///< of the triangle at rest
  /// Force on the tools together, one newton of the law; at most 1 long, as opposing contacts cancel.
  Vec3 direction = Vec3::Zero();
};

/// Wall time of one step, microseconds; NaN for the initial state.
struct StepTiming {
  double step_us = 0;       ///< the whole step: Bullet's and ours, without measuring and writing
  double collision_us = 0;  ///< the collision part of it: tool against tissue
};

/// What the contact stage reports of one step: which tissue and which tool nodes met, how many contacts there
/// were, and what they did to the tools. Arrays as a State has them.
struct ContactOutcome {
  std::vector<NodeState> node_states;        ///< empty when the pipeline uses no nodes
  std::vector<std::uint8_t> vertex_contact;  ///< 1: the vertex is in a colliding state with a tool
  int candidate_count = 0;                   ///< contacts the detector proposed in this step
  int infeasible_count = 0;                  ///< of these, excluded by their pair
  int contact_count = 0;                     ///< acting on the tissue: of these, and of tissue vertices
  int capped_count = 0;                      ///< of these, limited by the displacement cap
  /// Momentum the tool contacts took from the tissue in the step, over dt; with response none mass times
  /// displacement over dt squared, which takes none; NaN where the engine does not say.
  Vec3 reaction_on_tool_N = Vec3::Zero();
  /// The same on each tool, where there are several; empty where the engine does not say how they share it.
  std::vector<Vec3> tool_reactions_N;
  /// The momentum that contacts with the ground took from the tissue in the step, over dt; no value where
  /// there is no ground or the engine does not say.
  std::optional<Vec3> ground_reaction_N;
  /// Work of the tools on the tissue in the step: the force of each contact times the path of its tool point.
  /// NaN where it is not known: with response none, and where Bullet's own contacts act.
  double tool_work_J = std::numeric_limits<double>::quiet_NaN();
};

/// What the inside of an elastic body adds to its surface's state, and where its energy is: kinetic + stored
/// + gravity + losses - contact work stays what it was.
struct VolumeState {
  Vec3 momentum_kg_m_s = Vec3::Zero();  ///< of all vertices
  double kinetic_J = 0;                 ///< of all vertices
  double stored_J = 0;                  ///< elastic; 0 at rest
  double gravity_J = 0;                 ///< potential; 0 at rest
  double viscous_loss_J = 0;            ///< sum over the run, as what follows
  double mass_damping_loss_J = 0;
  double contact_work_J = 0;  ///< that contacts did on the tissue
  double tool_work_J = 0;     ///< that tools did on it; what is more than contact work is lost in contacts
  /// One per surface vertex: the normal stress of the contacts on the tissue, mean over the step, Pa;
  /// positive where they press. Their force on a vertex along its normal over a third of its triangles' area.
  std::vector<double> pressures_Pa;
  int substeps = 0;           ///< of the step
  int inverted_elements = 0;  ///< tetrahedra turned inside out
};

/// Everything one step leaves behind, engine-neutral. Arrays run over all bodies (vertices) or all tools
/// (nodes), concatenated in the Scene's order. One object lives through a run and is overwritten by every
/// step.
struct State {
  std::int64_t step = 0;  ///< 0: the initial state, after settling
  double time_s = 0;      ///< step x dt
  std::vector<Vec3> positions_m;
  std::vector<Vec3> velocities_m_s;  ///< the engine's own; response none leaves them out of its displacement
  std::vector<double> masses_kg;     ///< constant over a run; 0: fixed, has no share in it
  std::vector<ToolState> tools;
  std::vector<ClampState> clamps;
  std::vector<CouplingState> couplings;

  ContactOutcome contact;
  std::optional<VolumeState> volume;  ///< of the elastic body, where there is one
  std::vector<ForceSample> forces;    ///< one a force law, in the scenario's order
  std::vector<Vec3> tool_forces_N;  ///< on each tool: law x number of tools + tool; they sum up to the law's
  /// With at least one vertex in a colliding state: indices over all bodies, ascending; empty without force
  /// laws. What each gives the tools together: triangle x number of laws + law.
  std::vector<int> colliding_triangles;
  std::vector<Vec3> triangle_forces_N;
  /// What each law saw of each: triangle x number of laws + law; empty unless the scenario asks for it.
  std::vector<LawInput> law_inputs;
  StepTiming timing;
};

}  // namespace fissure
