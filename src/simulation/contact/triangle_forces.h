#pragma once

#include <array>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/triangle_deformation.h"
#include "law/force_law.h"

namespace fissure {

/// A force law with its way of measuring deformation and rate.
struct TriangleLaw {
  ForceLaw law;
  RateSource rate = RateSource::differences;
  DeformationKind deformation = DeformationKind::paper;
  bool per_area = false;  ///< the law is a pressure, to be multiplied by the triangle's area at rest
};

/// The interaction force of the paper (section "The interaction force model"; contact/METHOD.md 12). For each
/// tissue triangle with at least one vertex in a colliding state, x = |u| and x' = u . u' / |u| (0 where u =
/// 0), where u is the displacement of its centroid from rest (the body as placed, before settling) by the
/// law's kind of deformation. The total force is the sum of F(x, x') over these triangles. The force of a
/// triangle is divided among the tools whose contacts it has, in proportion to their displacements of it, and
/// acts along each tool's contact normal; a triangle without a contact of its own uses the weighted contacts
/// at its vertices.
class TriangleForces {
 public:
  /// `step_s`: time step. `keeps_inputs`: whether state.law_inputs is filled too.
  TriangleForces(const Scene& scene, std::vector<TriangleLaw> laws, double step_s, bool keeps_inputs = false);

  /// To be called once per step. Fills state.forces (one entry per law), tool_forces_N, colliding_triangles,
  /// triangle_forces_N and, where they are kept, law_inputs. Forces act ON THE TOOLS, in newtons in the scene
  /// frame.
  void evaluate(const ContactPatch& patch, State& state);

  /// Number of rigid fits so far: one per body and step if a law is corotated, else 0.
  long long rigidFits() const;

 private:
  /// A tool's share of the force of one triangle. `direction` points into the tissue; it is zero where
  /// opposing contacts of the tool cancel, and the force then has no direction.
  struct Share {
    std::size_t tool;
    Vec3 direction;
    double part;  ///< share of the force; over the tools they sum up to 1
  };
  /// x and, per RateSource, x' of one triangle.
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
  std::vector<Face> faces_;  ///< faces of all bodies, as indices into [vertex] arrays of a State
  bool keeps_inputs_;
  double weight_ = 1;                              ///< share of the current triangle's force that counts
  std::vector<double> rest_areas_m2_;              ///< empty unless a law is per area or inputs are kept
  std::vector<TriangleDeformation> deformations_;  ///< one per kind that a law uses
  std::array<std::array<bool, 2>, 2> asked_{};     ///< [kind][rate source] whether a law uses it
  std::array<Measured, 2> measured_;               ///< [kind] of the current triangle
  std::vector<Share> shares_;                      ///< shares of the current triangle
};

}  // namespace fissure
