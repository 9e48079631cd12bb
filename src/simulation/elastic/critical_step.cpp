#include "elastic/critical_step.h"

#include <Eigen/Eigenvalues>
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

  double operator()(double added_shear_Pa) {
    std::vector<double> diagonal, beside;
    DegreesOfFreedom before = DegreesOfFreedom::Zero(start_.size()), now = start_ / start_.norm(),
                     next(start_.size());
    double beta = 0, largest = 0;
    while (static_cast<int>(diagonal.size()) < kMostIterations) {
      apply(now, added_shear_Pa, next);
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
  void apply(const DegreesOfFreedom& field, double added_shear_Pa, DegreesOfFreedom& result) {
    scaled_.head(field.size()) = scale_.cwiseProduct(field);
    forces_.computeSmall(scaled_.data(), added_shear_Pa);
    const ElementArrays arrays = forces_.arrays();
    for (int vertex = 0; vertex < arrays.vertices; ++vertex) {
      Vec3 force_N = Vec3::Zero();
      for (int slot = arrays.first_slots[vertex]; slot < arrays.first_slots[vertex + 1]; ++slot)
        force_N += Eigen::Map<const Vec3>(forces_.forceSlots() + 4 * static_cast<std::size_t>(slot));
      result.segment<3>(3 * static_cast<Eigen::Index>(vertex)) = -force_N;
    }
    result = result.cwiseProduct(scale_);
  }

  /// Of a symmetric tridiagonal matrix.
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

/// The positive h with h^2 omega^2 + 2 h c = 4.
double limit_s(double stiffness_1_s2, double damping_1_s) {
  return 4 / (damping_1_s + std::sqrt(damping_1_s * damping_1_s + 4 * stiffness_1_s2));
}

}  // namespace

CriticalStep::CriticalStep(ElementForces& forces, const ElasticMaterial& material,
                           std::span<const double> inverse_masses_1_kg) {
  LargestEigenvalue largest(forces, inverse_masses_1_kg);
  if (largest.nothingMoves()) return;
  stiffness_1_s2_ = largest(0);
  damping_1_s_ = material.mass_damping_1_s;
  if (material.viscosity_Pa_s == 0) return;

  // The damping matrix is a stiffness with mu = eta and no lambda. 4 - h^2 lambda_max(K + 2 C / h) falls with
  // h: its root lies between that of C = eta / mu K, which is the larger damping, and that without viscosity.
  const double mu_Pa = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio).mu_Pa;
  const auto excess = [&](double h) {
    return h * h * largest(2 * material.viscosity_Pa_s / h) + 2 * h * material.mass_damping_1_s - 4;
  };
  double low_s = limit_s(stiffness_1_s2_, damping_1_s_ + material.viscosity_Pa_s / mu_Pa * stiffness_1_s2_);
  double high_s = limit_s(stiffness_1_s2_, damping_1_s_);
  if (!(low_s > 0)) {  // the damping is beyond all numbers, and no step is stable
    damping_1_s_ = std::numeric_limits<double>::infinity();
    return;
  }
  while (high_s - low_s > 1e-4 * low_s) {
    const double middle_s = std::sqrt(low_s * high_s);
    (excess(middle_s) > 0 ? high_s : low_s) = middle_s;
  }
  damping_1_s_ = (4 - low_s * low_s * stiffness_1_s2_) / (2 * low_s);
}

double CriticalStep::step_s(double stiffness_growth, double viscous_growth) const {
  if (stiffness_1_s2_ == 0) return std::numeric_limits<double>::infinity();
  return limit_s(stiffness_1_s2_ * stiffness_growth, damping_1_s_ * viscous_growth);
}

}  // namespace fissure
