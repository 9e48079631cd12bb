#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/contact_response.h"
#include "base/scene.h"
#include "base/stage_times.h"
#include "base/state.h"
#include "contact/contact_impulses.h"
#include "contact/contact_patch.h"
#include "contact/enforced_displacement.h"
#include "contact/ground_contact.h"
#include "contact/node_association.h"
#include "contact/node_rays.h"
#include "contact/rim_edges.h"
#include "contact/step_view.h"
#include "contact/vertex_sides.h"

namespace fissure {

struct NodeContactSettings {
  bool association = true;  ///< false: ray casting only, step one without step two (paper, Fig. 3 right)
  /// Also hold tissue that slips in between the nodes: vertices (VertexSides) and edges (RimEdges). A tool
  /// that starts inside tissue is pushed free by its nodes alone.
  bool vertex_contacts = false;
  ContactResponse response = ContactResponse::none;
  int sweeps = 30;  ///< Gauss-Seidel sweeps over the contacts
  std::optional<double> ray_length_m =
      {};                             ///< default: each body's extent, at least the node's travel in the step
  double max_displacement_m = 0.005;  ///< of tissue at a node, beyond the approach of the step itself
  std::vector<double> margins_m;      ///< one a body: how far in front of the tool the tissue is held
  std::vector<double> time_scales;    ///< one a body: its own time over the scene's; empty: 1 each
  /// Coulomb's coefficient of tissue on tool is the product of the body's and the tool's (as Bullet's SDF
  /// contact has it); empty: frictionless. Response momentum only: without it there is no force to rub with.
  std::vector<double> body_frictions, tool_frictions;
  std::optional<HalfSpace> ground = {};  ///< no value: none of this method's; response momentum only
};

/// Wall time of NodeContact's steps so far, seconds.
struct ContactTimes {
  double rays_s = 0;             ///< fitting the tree of triangles, casting the nodes' rays
  double association_s = 0;      ///< feasibility, and the contacts that it leaves
  double vertex_contacts_s = 0;  ///< of vertices and edges
  double displacement_s = 0;     ///< of the tissue, with its response
  double report_s = 0;           ///< states, counts and the patch of contacts
};

/// The collision method of the paper on plain arrays: node ray casting, feasibility by node association,
/// enforced displacement with or without momentum (METHOD sections 3 to 5). One object belongs to one run.
class NodeContact {
 public:
  NodeContact(const Scene& scene, NodeContactSettings settings);

  /// One step, after the engine's own solve: moves its positions_m in place, and tool_bodies with response
  /// momentum. inverse_masses: one per vertex
  /// in 1/kg, 0: fixed. Fills `patch` and all of `outcome` but vertex_contact, which the patch has.
  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch);

  /// The share of each vertex's displacement in the last step that changes its velocity; empty for response
  /// none.
  std::span<const Vec3> motion_m() const;

  long long rays() const { return rays_.rays(); }
  long long rayTests() const { return rays_.tests(); }
  const DisplacementCounts& displacementCounts() const;
  const ContactTimes& times() const { return times_; }

 private:
  void detect(const StepView& step, StageClock& clock);
  void collectConstraints();
  /// Moves the tissue; the reaction on the tools, newtons: a body's momentum over its own time.
  Vec3 respond(const StepView& step, std::span<const double> inverse_masses);
  void respondOnGround(const StepView& step, std::span<const double> inverse_masses);
  void shareReaction(double dt_s, std::vector<Vec3>& tool_reactions_N) const;
  void noteToolsPutInside();
  void limitDisplacement(NodeCandidate& candidate) const;
  void setFriction();
  void noteDisplacements(std::span<const Vec3> positions_m);
  void report(ContactOutcome& outcome, ContactPatch& patch) const;

  NodeContactSettings settings_;
  NodeRays rays_;
  std::vector<NodeAssociation> associations_;  ///< one a body
  std::optional<VertexSides> vertex_sides_;
  std::optional<RimEdges> rim_edges_;
  EnforcedDisplacement displacement_;
  std::optional<ContactImpulses> impulses_;  ///< response momentum
  std::optional<GroundContact> ground_;
  int node_count_;
  std::vector<double> force_factors_;  ///< one a vertex: the scene's time over its own, squared
  std::vector<double> frictions_;      ///< one a vertex: its body's; empty: no contact has friction
  ContactTimes times_;

  /// One a tool, 1: in the first step it was deeper in tissue than a margin, and its nodes have had contact
  /// ever since: vertices and edges are left to them.
  std::vector<std::uint8_t> put_inside_;
  bool first_step_ = true;
  std::vector<NodeCandidate> candidates_;
  /// Of the acting candidates, then of vertices and edges; in a response those of the ground follow.
  std::vector<ContactConstraint> constraints_;
  std::vector<Vec3> solved_m_;        ///< positions before the contacts; only with a ground
  std::size_t node_constraints_ = 0;  ///< how many of them are candidates'
  /// Of each constraint before it acts: how far it is short of its target. Empty where one tool takes all.
  std::vector<double> displacements_m_;
};

}  // namespace fissure
