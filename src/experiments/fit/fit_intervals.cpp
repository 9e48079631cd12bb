#include "fit/fit_intervals.h"

#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace fissure {

namespace {

/// The inverse of onScale.
double offScale(FitParameter parameter, double at) {
  return parameter == FitParameter::elastic ? std::exp(at) : at;
}

}  // namespace

double studentT(double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975);
}

double fisherTail(double value, double numerator_freedom, double denominator_freedom) {
  const boost::math::fisher_f distribution(numerator_freedom, denominator_freedom);
  return boost::math::cdf(boost::math::complement(distribution, value));
}

FitIntervals::FitIntervals(const FitProblem& problem, const LeastSquares& best)
    : problem_(problem), best_(best) {
  const auto freedom = static_cast<double>(problem.points()) - static_cast<double>(problem.free().size());
  variance_N2_ = best.sum_of_squares / freedom;
  t_ = studentT(freedom);
  const Eigen::Index count = best.place.size();
  if (count == 0) return;
  const Eigen::MatrixXd jacobian = problem.jacobian(best.place);
  const Eigen::VectorXd lengths = jacobian.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  const Eigen::MatrixXd scaled = jacobian * lengths.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& singular = svd.singularValues();
  singular_value_ratio_ = singular[0] > 0 ? singular[count - 1] / singular[0] : 0;
  if (!(singular_value_ratio_ > least_ratio)) return;
  const Eigen::MatrixXd root =
      lengths.cwiseInverse().asDiagonal() * svd.matrixV() * singular.cwiseInverse().asDiagonal();
  inverse_ = root * root.transpose();
  covariance_ = variance_N2_ * inverse_;
}

double FitIntervals::onScale(FitParameter parameter, const FitValues& values) const {
  return parameter == FitParameter::elastic ? std::log(values.coefficients.k)
                                            : problem_.valueOf(values, parameter);
}

Eigen::VectorXd FitIntervals::gradientOf(const Quantity& quantity) const {
  Eigen::VectorXd gradient(best_.place.size()), beside = best_.place;
  for (Eigen::Index i = 0; i < gradient.size(); ++i) {
    const double step = 6e-6 * std::max(1.0, std::abs(best_.place[i]));
    beside[i] = best_.place[i] + step;
    const double above = quantity(problem_.valuesAt(beside));
    beside[i] = best_.place[i] - step;
    gradient[i] = (above - quantity(problem_.valuesAt(beside))) / (2 * step);
    beside[i] = best_.place[i];
  }
  return gradient;
}

double FitIntervals::halfWidthOfViscousShare_s_m() const {
  const Eigen::VectorXd gradient =
      gradientOf([this](const FitValues& values) { return problem_.viscousShare_s_m(values); });
  return t_ * std::sqrt(gradient.dot(covariance_ * gradient));
}

double FitIntervals::rateReliability() const {
  const Eigen::VectorXd gradient =
      gradientOf([this](const FitValues& values) { return problem_.viscousShare_s_m(values); });
  const double all = 1 / gradient.dot(inverse_ * gradient);
  return std::clamp(1 - problem_.noiseOfViscousShare_N2(problem_.valuesAt(best_.place)) / all, 0.0, 1.0);
}

double FitIntervals::correlation(FitParameter a, FitParameter b) const {
  const Eigen::VectorXd of_a = gradientOf([this, a](const FitValues& values) { return onScale(a, values); });
  const Eigen::VectorXd of_b = gradientOf([this, b](const FitValues& values) { return onScale(b, values); });
  return of_a.dot(covariance_ * of_b) /
         std::sqrt(of_a.dot(covariance_ * of_a) * of_b.dot(covariance_ * of_b));
}

FittedValue FitIntervals::of(FitParameter parameter) const {
  const FitValues values = problem_.valuesAt(best_.place);
  const double center = onScale(parameter, values);
  const Eigen::VectorXd gradient =
      gradientOf([this, parameter](const FitValues& at) { return onScale(parameter, at); });
  const double error = std::sqrt(gradient.dot(covariance_ * gradient));
  FittedValue fitted{.value = problem_.valueOf(values, parameter), .free = true};
  fitted.standard_error = parameter == FitParameter::elastic ? error * values.coefficients.k : error;
  double down = -t_ * error, up = t_ * error;
  const auto agrees = [&](double step) { return std::abs(growth(parameter, step) / t_ - 1) <= 0.1; };
  if (variance_N2_ > 0 && !(agrees(down) && agrees(up))) {
    down = profileStep(parameter, down);
    up = profileStep(parameter, up);
    fitted.profiled = true;
  }
  fitted.low = std::min(fitted.value, offScale(parameter, center + down));
  fitted.high = std::max(fitted.value, offScale(parameter, center + up));
  if (parameter == FitParameter::shape) {
    fitted.low = std::max(fitted.low, problem_.leastShape());
    fitted.high = std::min(fitted.high, problem_.largestShape());
  }
  return fitted;
}

// sqrt((S(value) - S) / s^2): what t is where the problem is linear.
double FitIntervals::growth(FitParameter parameter, double step) const {
  const FitValues values = problem_.valuesAt(best_.place);
  const double value = offScale(parameter, onScale(parameter, values) + step);
  const bool is_shape = parameter == FitParameter::shape;
  if (is_shape && (value <= problem_.leastShape() || value >= problem_.largestShape()))
    return std::numeric_limits<double>::infinity();
  if (!std::isfinite(value) || (parameter == FitParameter::elastic && value <= 0)) return 0;
  const Eigen::VectorXd gradient =
      gradientOf([this, parameter](const FitValues& at) { return onScale(parameter, at); });
  const Eigen::VectorXd along = covariance_ * gradient;
  FitValues start = problem_.valuesAt(best_.place + along * (step / gradient.dot(along)));
  problem_.valueOf(start, parameter) = value;
  if (!(start.coefficients.k > 0)) start.coefficients.k = values.coefficients.k;
  const double sum = problem_.with(parameter, value).solveFrom(start).sum_of_squares;
  return std::sqrt(std::max(0.0, sum - best_.sum_of_squares) / variance_N2_);
}

// Where growth() is t: first outwards or inwards by halves, then by the rule of false position (Illinois).
double FitIntervals::profileStep(FitParameter parameter, double linear_step) const {
  double inner = 0, inner_t = -t_, outer = linear_step;
  double outer_t = growth(parameter, outer) - t_;
  for (int i = 0; outer_t < 0; ++i) {
    if (i == 16) return linear_step * std::numeric_limits<double>::infinity();
    inner = outer;
    inner_t = outer_t;
    outer *= 1.6;
    outer_t = growth(parameter, outer) - t_;
  }
  for (int i = 0; i < 40 && std::abs(outer - inner) > 2e-4 * std::abs(outer); ++i) {
    const bool finite = std::isfinite(outer_t);
    const double at = finite ? inner + (outer - inner) * inner_t / (inner_t - outer_t) : (inner + outer) / 2;
    const double at_t = growth(parameter, at) - t_;
    if (at_t < 0) {
      inner = at;
      inner_t = at_t;
      if (finite) outer_t /= 2;
    } else {
      outer = at;
      outer_t = at_t;
      inner_t /= 2;
    }
    if (std::abs(at_t) < 1e-3 * t_) return at;
  }
  return outer;
}

}  // namespace fissure
