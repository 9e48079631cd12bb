#include "measure/soundness.h"

#include <fmt/core.h>

#include <span>

#include "measure/statistics.h"

namespace fissure {

namespace {

double extent_m(std::span<const Vec3> points_m) {
  Vec3 low = points_m.front(), high = low;
  for (const Vec3& point_m : points_m) {
    low = low.cwiseMin(point_m);
    high = high.cwiseMax(point_m);
  }
  return (high - low).maxCoeff();
}

}  // namespace

Soundness::Soundness(const Scene& scene) {
  for (const SceneBody& body : scene.bodies)
    bodies_.push_back({body.name, static_cast<std::size_t>(body.first_vertex), body.rest.vertices_m.size(),
                       static_cast<long long>(body.rest.faces.size()), extent_m(body.rest.vertices_m)});
}

std::string Soundness::problemOf(const Body& body, const BodyStep& step, const State& state) const {
  const double inverted = static_cast<double>(step.inverted), all = static_cast<double>(body.triangles);
  if (!step.touched && inverted > all / 2)
    return fmt::format("{} is inside out: {:.0f} % of its triangles, while no tool touches it", body.name,
                       100 * inverted / all);
  if (!step.touched && !step.touched_before && step.inverted > 0)
    return fmt::format("{} has {} of {} triangles inverted before any tool touched it", body.name,
                       step.inverted, body.triangles);
  const double now_m = extent_m(std::span(state.positions_m).subspan(body.first_vertex, body.vertex_count));
  if (now_m > kExplodedExtent * body.extent_m)
    return fmt::format("{} explodes: {:.3g} m long, {:.3g} m at rest", body.name, now_m, body.extent_m);
  return "";
}

void Soundness::add(const State& state, const std::vector<BodyStep>& bodies) {
  sampled_ = true;
  std::string problem;
  for (std::size_t b = 0; b < bodies_.size() && problem.empty(); ++b)
    problem = problemOf(bodies_[b], bodies[b], state);
  if (problem.empty()) return;
  ++unsound_steps_;
  if (first_step_) return;
  first_step_ = state.step;
  first_problem_ = problem;
}

void Soundness::summarize(Summary& summary) const {
  summary.push_back(countOrMissing("unsound_steps", sampled_, unsound_steps_));
  if (!first_step_) return;
  summary.push_back({"first_unsound_step", *first_step_});
  summary.push_back({"unsound_tissue", first_problem_});
}

}  // namespace fissure
