#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/half_space.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts of tissue vertices with the ground, for ContactImpulses (contact/METHOD.md 11). A plane has a
/// normal at every distance, so that tissue needs no margin and stands on the ground itself. The cost is
/// linear in the number of vertices, without a search.
class GroundContact {
 public:
  /// Vertices that start or end a step lower than `reach_m` above the ground get a contact. frictions:
  /// [vertex] coefficient of the vertex's body.
  GroundContact(const HalfSpace& ground, double reach_m, std::vector<double> frictions);
  /// The same for all bodies of a scene, with a reach of three times the largest margin. margins_m,
  /// body_frictions: [body]; empty frictions: frictionless.
  GroundContact(const HalfSpace& ground, const Scene& scene, std::span<const double> margins_m,
                std::span<const double> body_frictions);

  /// Begins a step: forgets the contacts of the last one, and marks the vertices that are in reach at the
  /// start of this step or after the engine's solve.
  void begin(const StepView& step);

  /// Marks further vertices that are in reach at `positions_m`, after a response. Returns whether a vertex
  /// that is not fixed is below the ground. inverse_masses: [vertex] 1/kg, 0: fixed.
  bool findBelow(std::span<const Vec3> positions_m, std::span<const double> inverse_masses);

  /// Appends the contacts of the marked vertices. They must follow those of tools, because the last contact
  /// of a sweep is the one that holds exactly.
  void append(std::vector<ContactConstraint>& constraints) const;

  /// Reduces the target distance of a tool's contact that presses tissue down to at most half the distance
  /// from the tool to the ground.
  void makeRoomUnder(ContactConstraint& of_tool) const;

 private:
  HalfSpace ground_;
  double reach_m_;
  std::vector<double> frictions_;
  std::vector<std::uint8_t> noted_;  ///< [vertex] 1: marked
};

}  // namespace fissure
