#pragma once

#include <Eigen/Core>
#include <functional>

#include "fit/fit_problem.h"

namespace fissure {

/// What the residuals around an optimum say about each coefficient. See fitLaw().
class FitIntervals {
 public:
  /// `best`: of problem.solve(). Both must outlive it. More points than free coefficients.
  FitIntervals(const FitProblem& problem, const LeastSquares& best);

  /// Least over largest, of the Jacobian with columns of length one; 1 where nothing is free. Below
  /// least_ratio nothing else here means anything.
  double singularValueRatio() const { return singular_value_ratio_; }
  static constexpr double least_ratio = 1e-7;

  /// Value, standard error and 95 % interval of a free coefficient.
  FittedValue of(FitParameter parameter) const;
  /// Half the width of the viscous share's 95 % interval (FitProblem), s/m, by the standard error.
  double halfWidthOfViscousShare_s_m() const;
  /// How much of what a free damping is told by is no noise of the rates: 0 to 1. The square of how it
  /// changes the residuals beyond what the other free ones may, without the noise's share in that, over the
  /// same with it. The noise draws it towards 0 by that factor (Fuller 1987, Measurement error models,
  /// section 1.1).
  double rateReliability() const;
  double correlation(FitParameter a, FitParameter b) const;

 private:
  /// Something that is computed from the values, as linear as possible in the coordinates.
  using Quantity = std::function<double(const FitValues&)>;
  /// A coefficient on the scale on which its interval is symmetric: k by its logarithm, others as they are.
  double onScale(FitParameter parameter, const FitValues& values) const;
  Eigen::VectorXd gradientOf(const Quantity& quantity) const;
  double growth(FitParameter parameter, double step) const;
  double profileStep(FitParameter parameter, double linear_step) const;

  const FitProblem& problem_;
  const LeastSquares& best_;
  double variance_N2_ = 0;  ///< of a residual of weight 1
  double t_ = 0;            ///< Student's, of 97.5 %
  double singular_value_ratio_ = 1;
  Eigen::MatrixXd inverse_;     ///< of J'J
  Eigen::MatrixXd covariance_;  ///< of the coordinates
};

/// Student's t that a share of 97.5 % stays below.
double studentT(double degrees_of_freedom);
/// How likely Fisher's F with these degrees of freedom is to exceed a value.
double fisherTail(double value, double numerator_freedom, double denominator_freedom);

}  // namespace fissure
