#pragma once

#include <Eigen/Core>
#include <functional>

namespace fissure {

/// Writes the residuals at a place; their number never changes. All finite.
using Residuals = std::function<void(const Eigen::VectorXd& place, Eigen::VectorXd& residuals)>;

struct LeastSquares {
  Eigen::VectorXd place;
  double sum_of_squares = 0;
  bool converged = false;
};

/// The place near `start` with the least sum of squares, by Levenberg and Marquardt's method (MINPACK's, in
/// Eigen). Coordinates are to be of size one or so. No more of them than residuals.
LeastSquares leastSquares(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& start);

/// Derivatives of the residuals, a column a coordinate, by central differences.
Eigen::MatrixXd jacobianOf(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& place);

}  // namespace fissure
