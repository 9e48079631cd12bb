#pragma once

#include <Eigen/Core>
#include <functional>

#include "fit/fit_problem.h"

namespace fissure {

/// Standard errors, intervals and correlations of the coefficients at an optimum (see fitLaw).
class FitIntervals {
 public:
  /// `best`: the result of problem.solve(). Both must outlive this object. There must be more points than
  /// free coefficients.
  FitIntervals(const FitProblem& problem, const LeastSquares& best);

  /// The smallest over the largest singular value of the Jacobian with columns scaled to length one; 1 where
  /// nothing is free. Below least_ratio all other results have no meaning.
  double singularValueRatio() const { return singular_value_ratio_; }
  static constexpr double least_ratio = 1e-7;

  /// Value, standard error and 95 % interval of a free coefficient.
  FittedValue of(FitParameter parameter) const;
  /// Half the width of the 95 % interval of the viscous share (FitProblem), s/m, from its standard error.
  double halfWidthOfViscousShare_s_m() const;
  /// Reliability of a free damping coefficient, 0 to 1, with respect to noise of the rates. It is computed
  /// from the squared change of the residuals with the damping coefficient, as far as other free coefficients
  /// cannot produce it: its part that is no noise over the whole. The noise draws the coefficient towards 0
  /// by this factor (Fuller 1987, Measurement error models, section 1.1).
  double rateReliability() const;
  double correlation(FitParameter a, FitParameter b) const;

 private:
  /// A function of the values that is as linear as possible in the coordinates.
  using Quantity = std::function<double(const FitValues&)>;
  /// A coefficient on the scale on which its interval is symmetric: the logarithm of k, others themselves.
  double onScale(FitParameter parameter, const FitValues& values) const;
  Eigen::VectorXd gradientOf(const Quantity& quantity) const;
  double growth(FitParameter parameter, double step) const;
  double profileStep(FitParameter parameter, double linear_step) const;

  const FitProblem& problem_;
  const LeastSquares& best_;
  double variance_N2_ = 0;  ///< variance of a residual of weight 1
  double t_ = 0;            ///< quantile 97.5 % of Student's t
  double singular_value_ratio_ = 1;
  Eigen::MatrixXd inverse_;     ///< inverse of J'J
  Eigen::MatrixXd covariance_;  ///< covariance of the coordinates
};

/// The quantile 97.5 % of Student's t distribution.
double studentT(double degrees_of_freedom);
/// The probability that Fisher's F with these degrees of freedom exceeds a value.
double fisherTail(double value, double numerator_freedom, double denominator_freedom);

}  // namespace fissure
