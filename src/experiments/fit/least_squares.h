#pragma once

#include <Eigen/Core>
#include <functional>

namespace fissure {

/// Computes the residuals at a place; their number is constant, and all must be finite.
using Residuals = std::function<void(const Eigen::VectorXd& place, Eigen::VectorXd& residuals)>;

/// The result of a least-squares search.
struct LeastSquares {
  Eigen::VectorXd place;
  double sum_of_squares = 0;
  bool converged = false;
};

/// Minimises the sum of squares from `start` by Levenberg and Marquardt's method (MINPACK's, in Eigen).
/// `count`: number of residuals, at least that of coordinates. Coordinates should be of size one.
LeastSquares leastSquares(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& start);

/// Derivatives of the `count` residuals by central differences, with one column per coordinate.
Eigen::MatrixXd jacobianOf(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& place);

}  // namespace fissure
