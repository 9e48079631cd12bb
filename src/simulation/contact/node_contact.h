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
  bool association = true;  ///< false: ray casting alone (paper, Fig. 3 right)
  /// Whether tissue that slips between nodes is held too: vertices (VertexSides) and edges (RimEdges). A tool
  /// that starts inside tissue is pushed out by its nodes alone.
  bool vertex_contacts = false;
  ContactResponse response = ContactResponse::none;
  int sweeps = 30;  ///< Gauss-Seidel sweeps over the contacts
  /// Length of node rays, at least the node's displacement in the step; no value: each body's largest extent.
  std::optional<double> ray_length_m = {};
  double max_displacement_m = 0.005;  ///< cap on displacement in a step beyond the approach in that step
  std::vector<double> margins_m;      ///< [body] distance at which contacts hold tissue in front of a tool
  std::vector<double> time_scales;    ///< [body] its own time over the scene's; empty: 1 each
  /// [body] and [tool]: the friction coefficient of a contact is the product of the two, as in Bullet's SDF
  /// contact; empty: frictionless. Only with response momentum, because friction needs a normal force.
  std::vector<double> body_frictions, tool_frictions;
  /// No value: the ground is not this method's; response momentum only.
  std::optional<HalfSpace> ground = {};
};

/// Wall time of NodeContact's steps so far, seconds.
struct ContactTimes {
  double rays_s = 0;             ///< refitting the tree of triangles, casting rays
  double association_s = 0;      ///< node association, collecting the contacts
  double vertex_contacts_s = 0;  ///< finding contacts of vertices and edges
  double displacement_s = 0;     ///< displacing tissue, with its response
  double report_s = 0;           ///< node states, counts and the contact patch
};

/// The collision method of the paper on plain arrays: node ray casting, feasibility by node association,
/// enforced displacement with or without momentum (contact/METHOD.md 3 to 6). One object belongs to one run.
class NodeContact {
 public:
  NodeContact(const Scene& scene, NodeContactSettings settings);

  /// One step, after the engine's own solve: moves the step's positions_m in place, and tool_bodies with
  /// response momentum. inverse_masses: [vertex] 1/kg, 0: fixed. Fills `patch` and all of `outcome` except
  /// vertex_contact, which is in the patch.
  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch);

  /// [vertex] part of its displacement in the last step that changes its velocity; empty with response none.
  std::span<const Vec3> motion_m() const;

  /// Rays cast and ray-triangle tests made so far.
  long long rays() const { return rays_.rays(); }
  long long rayTests() const { return rays_.tests(); }
  const DisplacementCounts& displacementCounts() const;
  const ContactTimes& times() const { return times_; }

 private:
  void detect(const StepView& step, StageClock& clock);
  void collectConstraints();
  /// Moves the tissue and returns the reaction on the tools, newtons: momentum in each body's own time over
  /// that time.
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
  std::vector<NodeAssociation> associations_;  ///< one per body
  std::optional<VertexSides> vertex_sides_;
  std::optional<RimEdges> rim_edges_;
  EnforcedDisplacement displacement_;
  std::optional<ContactImpulses> impulses_;  ///< only with response momentum
  std::optional<GroundContact> ground_;
  int node_count_;
  std::vector<double> force_factors_;  ///< [vertex] square of the scene's time over the body's own
  std::vector<double> frictions_;      ///< [vertex] coefficient of its body; empty: no contact has friction
  ContactTimes times_;

  /// [tool] 1: it was deeper in tissue than a margin in the first step and its nodes have had contact ever
  /// since, so that contacts of vertices and edges are left out.
  std::vector<std::uint8_t> put_inside_;
  bool first_step_ = true;
  std::vector<NodeCandidate> candidates_;
  /// Contacts of the acting candidates, then of vertices and edges, then, during a response, of the ground.
  std::vector<ContactConstraint> constraints_;
  std::vector<Vec3> solved_m_;        ///< positions before the contacts; only with a ground
  std::size_t node_constraints_ = 0;  ///< number of constraints that stem from candidates
  /// [constraint] its shortfall from the target before the response; empty for a single tool.
  std::vector<double> displacements_m_;
};

}  // namespace fissure
