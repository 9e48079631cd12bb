#include "fit/fit_problem.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"

namespace fissure {

namespace {

/// Beyond e^60 of the force scale nothing is searched: exp() stays a number.
constexpr double kLargestLogarithm = 60;

bool isFree(const FitSettings& settings, FitParameter parameter) {
  return settings.free[static_cast<std::size_t>(parameter)];
}

}  // namespace

FitData::FitData(const LawModel& fitted, std::span<const double> measured_force_N,
                 std::span<const double> weights)
    : model(fitted),
      force_N(Eigen::Map<const Eigen::VectorXd>(measured_force_N.data(),
                                                static_cast<Eigen::Index>(measured_force_N.size()))),
      root_weights(
          Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()))) {
  if (force_N.size() == 0) throw InputError("no points, expected some to fit");
  if (!force_N.allFinite()) throw InputError("a force is no number, expected numbers");
  if (!root_weights.allFinite() || !(root_weights.minCoeff() > 0))
    throw InputError("a weight is no number above 0, expected one");
  force_scale_N = force_N.maxCoeff() - force_N.minCoeff();
  if (!(force_scale_N > 0)) throw InputError("the force is the same everywhere, expected one that changes");
  root_weights = (root_weights / root_weights.mean()).cwiseSqrt();
  const Eigen::ArrayXd shares = root_weights.array().square() / root_weights.squaredNorm();
  const double mean_N = (shares * force_N.array()).sum();
  squares_around_mean_N2 = (root_weights.array() * (force_N.array() - mean_N)).matrix().squaredNorm();
}

FitProblem::FitProblem(const FitData& data, const FitSettings& settings) : data_(data), settings_(settings) {
  for (const FitParameter parameter :
       {FitParameter::k, FitParameter::lambda, FitParameter::n, FitParameter::F0})
    if (isFree(settings, parameter)) free_.push_back(parameter);
}

FitProblem FitProblem::with(FitParameter fixed, double value) const {
  FitSettings settings = settings_;
  settings.free[static_cast<std::size_t>(fixed)] = false;
  valueOf(settings.fixed, fixed) = value;
  return {data_, settings};
}

double FitProblem::forceOfUnitK(double n) const {
  const double d = data_.model.deformationScale_m();
  return data_.model.law() == FitLaw::hunt_crossley ? std::pow(d, n) : d;
}

double FitProblem::viscousShare_s_m(const LawValues& values) const {
  const double share = values.lambda / values.k;
  return data_.model.law() == FitLaw::kelvin_voigt ? share / data_.model.deformationScale_m() : share;
}

double FitProblem::noiseOfViscousShare_N2(const LawValues& values) const {
  LawValues one = values;
  one.lambda = values.k;
  if (data_.model.law() == FitLaw::kelvin_voigt) one.lambda *= data_.model.deformationScale_m();
  Eigen::VectorXd noise_N(points());
  data_.model.evaluateNoise(one, {noise_N.data(), static_cast<std::size_t>(noise_N.size())});
  return (data_.root_weights.array() * noise_N.array()).matrix().squaredNorm();
}

double FitProblem::lambdaScale() const {
  const double per_share = data_.model.law() == FitLaw::kelvin_voigt ? data_.model.deformationScale_m() : 1.0;
  return per_share / data_.model.rateScale_m_s();
}

LawValues FitProblem::valuesAt(const Eigen::VectorXd& place) const {
  LawValues values = settings_.fixed;
  double log_k = 0, lambda_share = 0;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double at = place[static_cast<Eigen::Index>(i)];
    switch (free_[i]) {
      case FitParameter::k:
        log_k = std::clamp(at, -kLargestLogarithm, kLargestLogarithm);
        break;
      case FitParameter::lambda:
        lambda_share = at;
        break;
      case FitParameter::n:
        values.n = least_exponent + (largest_exponent - least_exponent) / (1 + std::exp(-at));
        break;
      case FitParameter::F0:
        values.F0_N = at * data_.force_scale_N;
        break;
    }
  }
  if (isFree(settings_, FitParameter::k))
    values.k = std::exp(log_k) * data_.force_scale_N / forceOfUnitK(values.n);
  if (isFree(settings_, FitParameter::lambda)) values.lambda = lambda_share * lambdaScale() * values.k;
  return values;
}

Eigen::VectorXd FitProblem::placeOf(const LawValues& values) const {
  Eigen::VectorXd place(static_cast<Eigen::Index>(free_.size()));
  for (std::size_t i = 0; i < free_.size(); ++i) {
    double& at = place[static_cast<Eigen::Index>(i)];
    const double n = std::clamp(values.n, least_exponent + 1e-6, largest_exponent - 1e-6);
    switch (free_[i]) {
      case FitParameter::k:
        at = std::log(values.k * forceOfUnitK(values.n) / data_.force_scale_N);
        break;
      case FitParameter::lambda:
        at = values.lambda / values.k / lambdaScale();
        break;
      case FitParameter::n:
        at = std::log((n - least_exponent) / (largest_exponent - n));
        break;
      case FitParameter::F0:
        at = values.F0_N / data_.force_scale_N;
        break;
    }
  }
  return place;
}

void FitProblem::writeResiduals(const Eigen::VectorXd& place, Eigen::VectorXd& residuals) const {
  const LawValues values = valuesAt(place);
  residuals.resize(points());
  data_.model.evaluate(values, {residuals.data(), static_cast<std::size_t>(residuals.size())});
  const double most = 1e9 * data_.force_scale_N;  // an overflow is far away, but a number
  for (double& force : residuals) force = std::isfinite(force) ? std::clamp(force, -most, most) : most;
  residuals = (data_.root_weights.array() * (residuals.array() + values.F0_N - data_.force_N.array()));
}

Eigen::VectorXd FitProblem::residuals(const Eigen::VectorXd& place) const {
  Eigen::VectorXd values(points());
  writeResiduals(place, values);
  return values;
}

Eigen::MatrixXd FitProblem::jacobian(const Eigen::VectorXd& place) const {
  return jacobianOf([this](const auto& at, auto& values) { writeResiduals(at, values); }, points(), place);
}

LeastSquares FitProblem::solveFrom(const LawValues& start) const {
  return leastSquares([this](const auto& at, auto& values) { writeResiduals(at, values); }, points(),
                      placeOf(start));
}

// At a given exponent and without viscosity the law is linear in k and F0.
LawValues FitProblem::startAt(double n) const {
  LawValues start = settings_.fixed;
  if (isFree(settings_, FitParameter::n)) start.n = n;
  LawValues unit = start;
  unit.k = 1;
  if (isFree(settings_, FitParameter::lambda)) unit.lambda = start.lambda = 0;
  Eigen::VectorXd law_N(points());
  data_.model.evaluate(unit, {law_N.data(), static_cast<std::size_t>(law_N.size())});
  const Eigen::ArrayXd weights = data_.root_weights.array().square() / data_.root_weights.squaredNorm();
  const double offset_N =
      isFree(settings_, FitParameter::F0) ? (weights * data_.force_N.array()).sum() : start.F0_N;
  const double mean_law = isFree(settings_, FitParameter::F0) ? (weights * law_N.array()).sum() : 0;
  const Eigen::ArrayXd law = law_N.array() - mean_law, force_N = data_.force_N.array() - offset_N;
  const double squares = (weights * law.square()).sum();
  const double least = 1e-3 * data_.force_scale_N / forceOfUnitK(start.n);
  if (isFree(settings_, FitParameter::k)) {
    start.k = squares > 0 ? (weights * law * force_N).sum() / squares : least;
    start.k = std::isfinite(start.k) ? std::max(start.k, least) : least;
  }
  if (isFree(settings_, FitParameter::F0)) start.F0_N = offset_N - start.k * mean_law;
  return start;
}

LeastSquares FitProblem::solve() const {
  LeastSquares best;
  bool first = true;
  for (const double n : {1.0, 1.5, 2.2, 3.2}) {
    const LeastSquares found = solveFrom(startAt(n));
    if (first || found.sum_of_squares < best.sum_of_squares) best = found;
    first = false;
    if (!isFree(settings_, FitParameter::n)) break;  // the others would start at the same place
  }
  return best;
}

}  // namespace fissure
