#pragma once

#include <array>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/triangle_deformation.h"
#include "law/force_law.h"

namespace fissure {

struct TriangleLaw {
  ForceLaw law;
  RateSource rate = RateSource::differences;
  DeformationKind deformation = DeformationKind::paper;
  bool per_area = false;  ///< the law gives a pressure: times the triangle's area at rest
};

/// The interaction force of the paper (section "The interaction force model"): for each soft triangle with at
/// least one vertex in a colliding state, x = |u| and x' = u . u' / |u| (0 where u = 0), u the displacement
/// of its centroid from rest (time zero of the bodies as placed, before settling) by the law's kind of
/// deformation; the total of F(x, x') is the sum. A triangle's force goes to the tools whose contacts it
/// carries, in proportion to how far these displace it, and acts along each one's contact normal; a triangle
/// without a contact of its own takes the contacts at its vertices, weighted.
class TriangleForces {
 public:
  /// `keeps_inputs`: fills state.law_inputs too.
  TriangleForces(const Scene& scene, std::vector<TriangleLaw> laws, double step_s, bool keeps_inputs = false);

  /// Once a step: fills state.forces, one entry a law, tool_forces_N, colliding_triangles, triangle_forces_N
  /// and, where they are kept, law_inputs: forces ON THE TOOLS, newtons.
  void evaluate(const ContactPatch& patch, State& state);

  /// Best fits of a rigid motion made so far: none unless a law is corotated, else one a body and step.
  long long rigidFits() const;

 private:
  /// A tool's part of one triangle's force; `direction` points into the tissue, zero where opposing contacts
  /// of one tool cancel: then the magnitude has no direction.
  struct Share {
    std::size_t tool;
    Vec3 direction;
    double part;  ///< sums up to 1 over the tools
  };
  /// x and, by RateSource, x' of one triangle.
  struct Measured {
    double deformation_m = 0;
    std::array<double, 2> rates_m_s{};
  };

  void shareAmongTools(const ContactPatch& patch, std::size_t triangle);
  void measure(std::size_t triangle, const State& state);
  void addForce(std::size_t law, std::size_t triangle, State& state) const;
  void addInputs(std::size_t triangle, State& state) const;

  std::vector<TriangleLaw> laws_;
  std::size_t tool_count_;
  std::vector<Face> faces_;  ///< all bodies, vertex indices into State arrays
  bool keeps_inputs_;
  double weight_ = 1;                              ///< share of the current triangle's force that counts
  std::vector<double> rest_areas_m2_;              ///< empty unless a law is per area or inputs are kept
  std::vector<TriangleDeformation> deformations_;  ///< one a kind that a law asks for
  std::array<std::array<bool, 2>, 2> asked_{};     ///< by kind and rate source
  std::array<Measured, 2> measured_;               ///< by kind, of one triangle
  std::vector<Share> shares_;                      ///< of one triangle
};

}  // namespace fissure
