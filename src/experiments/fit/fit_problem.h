#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fit/law_fit.h"
#include "fit/least_squares.h"

namespace fissure {

inline constexpr double least_exponent = 0.2;
inline constexpr double largest_exponent = 8;

/// The measured side of a fit. Throws InputError where it holds nothing to fit.
struct FitData {
  FitData(const LawModel& fitted, std::span<const double> measured_force_N, std::span<const double> weights);

  const LawModel& model;
  Eigen::VectorXd force_N;
  Eigen::VectorXd root_weights;  ///< their mean square is 1
  double force_scale_N = 0;      ///< the largest difference of forces
  double squares_around_mean_N2 = 0;
};

/// A fit as residuals over coordinates of size one: log(k d^n / force scale), lambda/k times the rate scale,
/// the exponent's place between its limits (logistic), F0 over the force scale; d: the deformation scale,
/// which takes most of the correlation between k and n away. Those of what is free, in that order.
class FitProblem {
 public:
  /// `data` must outlive it.
  FitProblem(const FitData& data, const FitSettings& settings);

  const std::vector<FitParameter>& free() const { return free_; }
  Eigen::Index points() const { return data_.force_N.size(); }
  LawValues valuesAt(const Eigen::VectorXd& place) const;
  Eigen::VectorXd placeOf(const LawValues& values) const;

  /// The best of the searches from several exponents.
  LeastSquares solve() const;
  LeastSquares solveFrom(const LawValues& start) const;

  /// Of the weighted residuals.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& place) const;
  Eigen::VectorXd residuals(const Eigen::VectorXd& place) const;

  /// lambda/k in s/m; for kelvin_voigt over the deformation scale.
  double viscousShare_s_m(const LawValues& values) const;

  /// Sum of squares that noise of the rates makes of (weighted) residuals where that share is 1 s/m.
  double noiseOfViscousShare_N2(const LawValues& values) const;

  /// k d^n over the force scale.
  double elasticShare(const LawValues& values) const {
    return values.k * forceOfUnitK(values.n) / data_.force_scale_N;
  }

  /// The same with one coefficient fixed.
  FitProblem with(FitParameter fixed, double value) const;

 private:
  void writeResiduals(const Eigen::VectorXd& place, Eigen::VectorXd& residuals) const;
  LawValues startAt(double n) const;
  double forceOfUnitK(double n) const;
  double lambdaScale() const;

  const FitData& data_;
  FitSettings settings_;
  std::vector<FitParameter> free_;
};

}  // namespace fissure
