#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/half_space.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts of tissue with the ground, one a vertex, for ContactImpulses. A plane has a normal at every
/// distance, so that tissue needs no margin above it: it stands on the ground itself, where scenarios put it.
/// Linear in the number of vertices, without any search.
class GroundContact {
 public:
  /// Vertices that start or end a step lower than `reach_m` get a contact. frictions: one a vertex, of its
  /// body.
  GroundContact(const HalfSpace& ground, double reach_m, std::vector<double> frictions);
  /// Under all bodies, each with its own margin, of which the reach is three of the largest, and its own
  /// coefficient; no coefficients: frictionless.
  GroundContact(const HalfSpace& ground, const Scene& scene, std::span<const double> margins_m,
                std::span<const double> body_frictions);

  /// Forgets the contacts of the last step, and notes the vertices that are in reach before this one or after
  /// the engine's solve in it.
  void begin(const StepView& step);

  /// Notes the vertices that are in reach after a response too. Is one below that is not fixed?
  /// inverse_masses: one a vertex in 1/kg, 0: fixed.
  bool findBelow(std::span<const Vec3> positions_m, std::span<const double> inverse_masses);

  /// Appends the contact of each noted vertex. They belong after those of tools: the last contact of a sweep
  /// is the one that holds exactly.
  void append(std::vector<ContactConstraint>& constraints) const;

  /// Where a tool presses tissue down, its target is at most half the way to the ground.
  void makeRoomUnder(ContactConstraint& of_tool) const;

 private:
  HalfSpace ground_;
  double reach_m_;
  std::vector<double> frictions_;
  std::vector<std::uint8_t> noted_;  ///< per vertex
};

}  // namespace fissure
