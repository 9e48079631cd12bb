#include "elastic/critical_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace fissure {

namespace {

constexpr int kMostIterations = 200;
constexpr int kCheckedEvery = 5;
constexpr double kTolerance = 1e-6;

using DegreesOfFreedom = Eigen::VectorXd;  ///< three numbers per vertex

/// Numbers between -1 and 1, the same on every machine; a start that no symmetry of the mesh makes blind.
DegreesOfFreedom deterministicStart(std::span<const double> inverse_masses_1_kg) {
  DegreesOfFreedom start(3 * static_cast<Eigen::Index>(inverse_masses_1_kg.size()));
  std::uint64_t state = 1;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX
    start[i] = inverse_masses_1_kg[i / 3] > 0 ? static_cast<double>(state >> 11) / 4503599627370496.0 - 1 : 0;
  }
  return start;
}

/// Largest eigenvalue of M^-1/2 K M^-1/2 over the vertices that are not fixed, 1/s^2.
class LargestEigenvalue {
 public:
  LargestEigenvalue(ElementForces& forces, std::span<const double> inverse_masses_1_kg)
      : forces_(forces),
        start_(deterministicStart(inverse_masses_1_kg)),
        scale_(start_.size()),
        scaled_(start_.size() + 1) {
    for (Eigen::Index i = 0; i < scale_.size(); ++i) scale_[i] = std::sqrt(inverse_masses_1_kg[i / 3]);
    scaled_.setZero();
  }

  bool nothingMoves() const { return start_.isZero(0); }

  double operator()(std::span<const SmallStrainLaw> laws) {
    std::vector<double> diagonal, beside;
    DegreesOfFreedom before = DegreesOfFreedom::Zero(start_.size()), now = start_ / start_.norm(),
                     next(start_.size());
    double beta = 0, largest = 0;
    while (static_cast<int>(diagonal.size()) < kMostIterations) {
      apply(now, laws, next);
      const double alpha = now.dot(next);
      next -= alpha * now + beta * before;
      beta = next.norm();
      diagonal.push_back(alpha);
      if (diagonal.size() % kCheckedEvery == 0 || beta <= 1e-12 * std::abs(alpha)) {
        const double found = largestOf(diagonal, beside);
        const bool settled = found - largest <= kTolerance * found;
        largest = found;
        if (settled || beta <= 1e-12 * std::abs(alpha)) break;
      }
      beside.push_back(beta);
      before.swap(now);
      now = next / beta;
    }
    return largest;
  }

 private:
  void apply(const DegreesOfFreedom& field, std::span<const SmallStrainLaw> laws, DegreesOfFreedom& result) {
    scaled_.head(field.size()) = scale_.cwiseProduct(field);
    forces_.computeSmall(scaled_.data(), laws);
    const ElementArrays arrays = forces_.arrays();
    for (int vertex = 0; vertex < arrays.vertices; ++vertex) {
      Vec3 force_N = Vec3::Zero();
      for (int slot = arrays.first_slots[vertex]; slot < arrays.first_slots[vertex + 1]; ++slot)
        force_N += Eigen::Map<const Vec3>(forces_.forceSlots() + 4 * static_cast<std::size_t>(slot));
      result.segment<3>(3 * static_cast<Eigen::Index>(vertex)) = -force_N;
    }
    result = result.cwiseProduct(scale_);
  }

  /// The largest eigenvalue of the symmetric tridiagonal matrix with these entries on and beside its
  /// diagonal.
  static double largestOf(const std::vector<double>& diagonal, const std::vector<double>& beside) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), diagonal.size()),
                                  Eigen::Map<const Eigen::VectorXd>(beside.data(), diagonal.size() - 1),
                                  Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
  }

  ElementForces& forces_;
  DegreesOfFreedom start_, scale_, scaled_;
};

/// What sets a step: stiffnesses, viscosities, and mass damping.
struct StepMaterials {
  std::vector<SmallStrainLaw> laws;
  std::vector<double> viscosities_Pa_s;
  double mass_damping_1_s = 0;
};

StepMaterials materialsOf(const ElementForces& forces) {
  StepMaterials found = {forces.smallStrainLaws(), {}, forces.materials()[0].mass_damping_1_s};
  for (const ElasticMaterial& material : forces.materials())
    found.viscosities_Pa_s.push_back(material.viscosity_Pa_s);
  return found;
}

/// The stiffness and the viscosity of one material alone.
StepMaterials only(std::size_t material, const StepMaterials& all) {
  StepMaterials one = {std::vector<SmallStrainLaw>(all.laws.size()), std::vector<double>(all.laws.size()), 0};
  one.laws[material] = all.laws[material];
  one.viscosities_Pa_s[material] = all.viscosities_Pa_s[material];
  return one;
}

/// The damping matrix is a stiffness with mu = eta and no lambda. 4 - h^2 lambda_max(K + 2 C / h) falls with
/// h: its root lies between that of C = K times the largest eta / mu, which is no smaller damping, and that
/// without viscosity.
StepLimit limitOf(LargestEigenvalue& largest, const StepMaterials& materials) {
  StepLimit limit = {largest(materials.laws), materials.mass_damping_1_s};
  std::vector<SmallStrainLaw> viscous = materials.laws;
  double most_viscous_s = 0;  // viscosity over mu
  for (std::size_t m = 0; m < viscous.size(); ++m)
    if (materials.viscosities_Pa_s[m] > 0)
      most_viscous_s = std::max(most_viscous_s, materials.viscosities_Pa_s[m] / viscous[m].mu_Pa);
  if (most_viscous_s == 0 || limit.stiffness_1_s2 == 0) return limit;

  const auto excess = [&](double h) {
    for (std::size_t m = 0; m < viscous.size(); ++m)
      viscous[m].mu_Pa = materials.laws[m].mu_Pa + 2 * materials.viscosities_Pa_s[m] / h;
    return h * h * largest(viscous) + 2 * h * materials.mass_damping_1_s - 4;
  };
  double low_s =
      StepLimit{limit.stiffness_1_s2, limit.damping_1_s + most_viscous_s * limit.stiffness_1_s2}.step_s();
  double high_s = limit.step_s();
  if (!(low_s > 0)) {  // the damping is beyond all numbers, and no step is stable
    limit.damping_1_s = std::numeric_limits<double>::infinity();
    return limit;
  }
  while (high_s - low_s > 1e-4 * low_s) {
    const double middle_s = std::sqrt(low_s * high_s);
    (excess(middle_s) > 0 ? high_s : low_s) = middle_s;
  }
  limit.damping_1_s = (4 - low_s * low_s * limit.stiffness_1_s2) / (2 * low_s);
  return limit;
}

}  // namespace

double StepLimit::step_s() const {
  if (stiffness_1_s2 == 0) return std::numeric_limits<double>::infinity();
  // The positive h with h^2 omega^2 + 2 h c = 4.
  return 4 / (damping_1_s + std::sqrt(damping_1_s * damping_1_s + 4 * stiffness_1_s2));
}

CriticalStep::CriticalStep(ElementForces& forces, std::span<const double> inverse_masses_1_kg) {
  const StepMaterials materials = materialsOf(forces);
  alone_.resize(materials.laws.size());
  LargestEigenvalue largest(forces, inverse_masses_1_kg);
  if (largest.nothingMoves()) return;
  all_ = limitOf(largest, materials);
  for (std::size_t m = 0; m < alone_.size() && alone_.size() > 1; ++m) {
    StepMaterials one = only(m, materials);
    alone_[m].stiffness_1_s2 = largest(one.laws);
    one.laws[m] = {.mu_Pa = one.viscosities_Pa_s[m], .lambda = {}};
    if (one.viscosities_Pa_s[m] > 0) alone_[m].damping_1_s = largest(one.laws);
  }
}

double criticalStepAlone_s(ElementForces& forces, std::span<const double> inverse_masses_1_kg,
                           std::size_t material) {
  LargestEigenvalue largest(forces, inverse_masses_1_kg);
  if (largest.nothingMoves()) return std::numeric_limits<double>::infinity();
  return limitOf(largest, only(material, materialsOf(forces))).step_s();
}

double CriticalStep::step_s(std::span<const Growth> growths) const {
  const auto grown = [&](double StepLimit::*part, double Growth::*growth) {
    double most = 1, sum = all_.*part;
    for (std::size_t m = 0; m < growths.size(); ++m) {
      most = std::max(most, growths[m].*growth);
      sum += (growths[m].*growth - 1) * alone_[m].*part;
    }
    const double of_most = all_.*part * most;
    return growths.size() == 1 ? of_most : std::min(of_most, sum);
  };
  return StepLimit{grown(&StepLimit::stiffness_1_s2, &Growth::stiffness),
                   grown(&StepLimit::damping_1_s, &Growth::viscous)}
      .step_s();
}

}  // namespace fissure
