#include "contact/triangle_forces.h"

#include <algorithm>
#include <cmath>

namespace fissure {

namespace {

std::size_t index(DeformationKind kind) {
  return static_cast<std::size_t>(kind);
}
std::size_t index(RateSource source) {
  return static_cast<std::size_t>(source);
}

constexpr std::array kKinds = {DeformationKind::paper, DeformationKind::corotated};
constexpr std::array kSources = {RateSource::differences, RateSource::velocities};

/// The larger of both; NaN where one is.
double larger(double a, double b) {
  return std::isnan(b) || b > a ? b : a;
}

/// One more triangle into maximum, minimum and, where the mean will stand, the sum.
void addStatistics(double deformation_m, double rate_m_s, bool first, ForceSample& sample) {
  sample.deformation_max_m = first ? deformation_m : larger(sample.deformation_max_m, deformation_m);
  sample.rate_max_m_s = first ? rate_m_s : larger(sample.rate_max_m_s, rate_m_s);
  sample.rate_min_m_s = first ? rate_m_s : -larger(-sample.rate_min_m_s, -rate_m_s);
  sample.deformation_mean_m += deformation_m;
  sample.rate_mean_m_s += rate_m_s;
}

}  // namespace

TriangleForces::TriangleForces(const Scene& scene, std::vector<TriangleLaw> laws, double step_s,
                               bool keeps_inputs)
    : laws_(std::move(laws)), tool_count_(scene.tools.size()), keeps_inputs_(keeps_inputs) {
  for (const TriangleLaw& law : laws_) asked_[index(law.deformation)][index(law.rate)] = true;
  for (const DeformationKind kind : kKinds) {
    std::vector<RateSource> sources;
    for (const RateSource source : kSources)
      if (asked_[index(kind)][index(source)]) sources.push_back(source);
    if (!sources.empty()) deformations_.emplace_back(scene, kind, sources, step_s);
  }
  const bool areas = keeps_inputs || std::any_of(laws_.begin(), laws_.end(),
                                                 [](const TriangleLaw& law) { return law.per_area; });
  for (const SceneBody& body : scene.bodies) {
    for (const Face& face : body.rest.faces) {
      const int first = body.first_vertex;
      faces_.push_back({face[0] + first, face[1] + first, face[2] + first});
      const std::vector<Vec3>& rest_m = body.rest.vertices_m;
      const Vec3 a = rest_m[face[1]] - rest_m[face[0]], b = rest_m[face[2]] - rest_m[face[0]];
      if (areas) rest_areas_m2_.push_back(a.cross(b).norm() / 2);
    }
  }
}

void TriangleForces::evaluate(const ContactPatch& patch, State& state) {
  state.forces.assign(laws_.size(), ForceSample{});
  state.tool_forces_N.assign(laws_.size() * tool_count_, Vec3::Zero());
  state.colliding_triangles.clear();
  state.triangle_forces_N.clear();
  state.law_inputs.clear();
  for (TriangleDeformation& deformation : deformations_) deformation.update(state);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Face& face = faces_[i];
    if (!patch.vertex_contact[face[0]] && !patch.vertex_contact[face[1]] && !patch.vertex_contact[face[2]])
      continue;
    weight_ = patch.face_weights.empty() ? 1 : patch.face_weights[i];
    if (!(weight_ > 0)) continue;
    shareAmongTools(patch, i);
    measure(i, state);
    for (std::size_t law = 0; law < laws_.size(); ++law) addForce(law, i, state);
    if (keeps_inputs_) addInputs(i, state);
    state.colliding_triangles.push_back(static_cast<int>(i));
  }
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    ForceSample& sample = state.forces[law];
    for (std::size_t tool = 0; tool < tool_count_; ++tool)
      sample.force_on_tool_N += state.tool_forces_N[law * tool_count_ + tool];
    if (state.colliding_triangles.empty()) continue;
    const auto triangles = static_cast<double>(state.colliding_triangles.size());
    sample.deformation_mean_m /= triangles;
    sample.rate_mean_m_s /= triangles;
  }
}

void TriangleForces::shareAmongTools(const ContactPatch& patch, std::size_t triangle) {
  const Face& face = faces_[triangle];
  const bool own = std::any_of(patch.tools.begin(), patch.tools.end(),
                               [&](const ToolTouch& tool) { return !tool.face_normals[triangle].isZero(0); });
  const bool several = patch.tools.size() > 1;
  shares_.clear();
  double displacement_m = 0;
  for (std::size_t t = 0; t < patch.tools.size(); ++t) {
    const ToolTouch& tool = patch.tools[t];
    const Vec3 normal = own ? tool.face_normals[triangle]
                            : Vec3(tool.vertex_normals[face[0]] + tool.vertex_normals[face[1]] +
                                   tool.vertex_normals[face[2]]);
    const double length = normal.norm();
    if (several && length == 0) continue;
    const std::vector<double>& at = own ? tool.face_displacements_m : tool.vertex_displacements_m;
    const double part_m = !several ? 1 : own ? at[triangle] : at[face[0]] + at[face[1]] + at[face[2]];
    shares_.push_back({t, length > 0 ? Vec3(normal / length) : Vec3::Zero(), part_m});
    displacement_m += part_m;
  }
  for (Share& share : shares_)  // contacts that only hold displace nothing: alike
    share.part = displacement_m > 0 ? share.part / displacement_m : 1.0 / static_cast<double>(shares_.size());
}

void TriangleForces::measure(std::size_t triangle, const State& state) {
  for (const TriangleDeformation& deformation : deformations_) {
    const std::size_t kind = index(deformation.kind());
    const Vec3 displacement_m = deformation.displacement(triangle);
    const double length_m = displacement_m.norm();
    const Vec3 direction = length_m > 0 ? Vec3(displacement_m / length_m) : Vec3::Zero();
    measured_[kind].deformation_m = length_m;
    for (const RateSource source : kSources) {
      if (!asked_[kind][index(source)]) continue;
      measured_[kind].rates_m_s[index(source)] = direction.dot(deformation.rate(triangle, source, state));
    }
  }
}

void TriangleForces::addForce(std::size_t law, std::size_t triangle, State& state) const {
  const Measured& measured = measured_[index(laws_[law].deformation)];
  const double rate_m_s = measured.rates_m_s[index(laws_[law].rate)];
  const LawForce force = laws_[law].law.at(measured.deformation_m, rate_m_s);
  const double area = weight_ * (laws_[law].per_area ? rest_areas_m2_[triangle] : 1);
  ForceSample& sum = state.forces[law];
  sum.elastic_N += area * force.elastic_N;
  sum.viscous_N += area * force.viscous_N;
  sum.adhesion_clamped += force.adhesion_clamped ? 1 : 0;
  addStatistics(measured.deformation_m, rate_m_s, state.colliding_triangles.empty(), sum);
  Vec3& of_triangle_N = state.triangle_forces_N.emplace_back(Vec3::Zero());
  for (const Share& share : shares_) {
    const Vec3 on_tissue_N = area * (force.elastic_N + force.viscous_N) * share.part * share.direction;
    state.tool_forces_N[law * tool_count_ + share.tool] -= on_tissue_N;
    of_triangle_N -= on_tissue_N;
  }
}

void TriangleForces::addInputs(std::size_t triangle, State& state) const {
  Vec3 direction = Vec3::Zero();
  for (const Share& share : shares_) direction -= weight_ * share.part * share.direction;
  for (const TriangleLaw& law : laws_) {
    const Measured& measured = measured_[index(law.deformation)];
    state.law_inputs.push_back(
        {measured.deformation_m, measured.rates_m_s[index(law.rate)], rest_areas_m2_[triangle], direction});
  }
}

long long TriangleForces::rigidFits() const {
  long long fits = 0;
  for (const TriangleDeformation& deformation : deformations_) fits += deformation.rigidFits();
  return fits;
}

}  // namespace fissure
