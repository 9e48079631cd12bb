#include "fit/least_squares.h"

#include <cmath>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace fissure {

namespace {

struct Functor : Eigen::DenseFunctor<double> {
  Functor(const Residuals& of, int coordinates, int count)
      : Eigen::DenseFunctor<double>(coordinates, count), residuals(of) {}
  int operator()(const Eigen::VectorXd& place, Eigen::VectorXd& values) const {
    residuals(place, values);
    return 0;
  }
  int df(const Eigen::VectorXd& place, Eigen::MatrixXd& jacobian) const {
    jacobian = jacobianOf(residuals, values(), place);
    return 0;
  }
  const Residuals& residuals;
};

bool isConverged(Eigen::LevenbergMarquardtSpace::Status status) {
  using namespace Eigen::LevenbergMarquardtSpace;
  switch (status) {
    case RelativeReductionTooSmall:
    case RelativeErrorTooSmall:
    case RelativeErrorAndReductionTooSmall:
    case CosinusTooSmall:
    case FtolTooSmall:
    case XtolTooSmall:
    case GtolTooSmall:
      return true;
    default:
      return false;
  }
}

}  // namespace

LeastSquares leastSquares(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& start) {
  LeastSquares found;
  found.place = start;
  Eigen::VectorXd values(count);
  if (start.size() == 0) {
    found.converged = true;
  } else {
    Functor functor(residuals, static_cast<int>(start.size()), static_cast<int>(count));
    Eigen::LevenbergMarquardt<Functor> search(functor);
    search.setFtol(1e-13);
    search.setXtol(1e-11);
    search.setMaxfev(400);
    found.converged = isConverged(search.minimize(found.place));
  }
  residuals(found.place, values);
  found.sum_of_squares = values.squaredNorm();
  return found;
}

Eigen::MatrixXd jacobianOf(const Residuals& residuals, Eigen::Index count, const Eigen::VectorXd& place) {
  Eigen::MatrixXd jacobian(count, place.size());
  Eigen::VectorXd beside = place, above(count), below(count);
  for (Eigen::Index i = 0; i < place.size(); ++i) {
    const double step = 6e-6 * std::max(1.0, std::abs(place[i]));  // cube root of the rounding
    beside[i] = place[i] + step;
    residuals(beside, above);
    beside[i] = place[i] - step;
    residuals(beside, below);
    beside[i] = place[i];
    jacobian.col(i) = (above - below) / (2 * step);
  }
  return jacobian;
}

}  // namespace fissure
