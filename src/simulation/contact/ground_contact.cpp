#include "contact/ground_contact.h"

#include <algorithm>

namespace fissure {

namespace {
constexpr double kOpposed = -0.5;    ///< cosine between normals of contacts that press against each other
constexpr double kReachMargins = 3;  ///< vertices nearer than this many margins get a contact

std::vector<double> vertexFrictions(const Scene& scene, std::span<const double> body_frictions) {
  std::vector<double> frictions;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    frictions.insert(frictions.end(), scene.bodies[b].rest.vertices_m.size(),
                     body_frictions.empty() ? 0 : body_frictions[b]);
  return frictions;
}

}  // namespace

GroundContact::GroundContact(const HalfSpace& ground, double reach_m, std::vector<double> frictions)
    : ground_(ground), reach_m_(reach_m), frictions_(std::move(frictions)), noted_(frictions_.size()) {}

GroundContact::GroundContact(const HalfSpace& ground, const Scene& scene, std::span<const double> margins_m,
                             std::span<const double> body_frictions)
    : GroundContact(ground, kReachMargins * *std::max_element(margins_m.begin(), margins_m.end()),
                    vertexFrictions(scene, body_frictions)) {}

void GroundContact::begin(const StepView& step) {
  for (std::size_t v = 0; v < noted_.size(); ++v)
    noted_[v] =
        std::min(ground_.height_m(step.before_m[v]), ground_.height_m(step.positions_m[v])) < reach_m_;
}

bool GroundContact::findBelow(std::span<const Vec3> positions_m, std::span<const double> inverse_masses) {
  bool any = false;
  for (std::size_t v = 0; v < noted_.size(); ++v) {
    if (ground_.height_m(positions_m[v]) < reach_m_) noted_[v] = 1;
    any |= inverse_masses[v] > 0 && ground_.holdsInside(positions_m[v]);
  }
  return any;
}

void GroundContact::append(std::vector<ContactConstraint>& constraints) const {
  for (std::size_t v = 0; v < noted_.size(); ++v) {
    if (!noted_[v]) continue;
    const int vertex = static_cast<int>(v);
    constraints.push_back({.vertices = {vertex, vertex, vertex},
                           .weights = {1, 0, 0},
                           .position_m = ground_.point_m,
                           .normal = ground_.normal,
                           .tool = kGround,
                           .target_m = 0,
                           .friction = ground_.friction * frictions_[v]});
  }
}

void GroundContact::makeRoomUnder(ContactConstraint& of_tool) const {
  if (of_tool.normal.dot(ground_.normal) > kOpposed) return;
  const double room_m = std::max(ground_.height_m(of_tool.position_m), 0.0);
  of_tool.target_m = std::min(of_tool.target_m, 0.5 * room_m);
}

}  // namespace fissure
