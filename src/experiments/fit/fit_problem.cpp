#include "fit/fit_problem.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace fissure {

namespace {

/// Beyond e^60 of the force scale nothing is searched: exp() stays a number.
constexpr double kLargestLogarithm = 60;

bool isFree(const FitSettings& settings, FitParameter parameter) {
  return settings.free[index(parameter)];
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

FitProblem::FitProblem(const FitData& data, const FitSettings& settings)
    : data_(data),
      law_(entryOf(data.model.law())),
      search_(law_.shape_search),
      shape_scale_(search_.times_deformation ? data.model.deformationScale_m() : 1),
      settings_(settings) {
  for (const FitParameter parameter : kFitParameters)
    if (isFree(settings, parameter)) free_.push_back(parameter);
}

FitProblem FitProblem::with(FitParameter fixed, double value) const {
  FitSettings settings = settings_;
  settings.free[index(fixed)] = false;
  valueOf(settings.fixed, fixed) = value;
  return {data_, settings};
}

double& FitProblem::valueOf(FitValues& values, FitParameter parameter) const {
  return fissure::valueOf(data_.model.law(), values, parameter);
}

double FitProblem::valueOf(const FitValues& values, FitParameter parameter) const {
  return fissure::valueOf(data_.model.law(), values, parameter);
}

std::optional<double> FitProblem::limitOfShape(const FitValues& values) const {
  const double shape = valueOf(values, FitParameter::shape) * shape_scale_;
  if (shape < search_.least + 1e-3) return leastShape();
  if (shape > search_.largest - 1e-3) return largestShape();
  return std::nullopt;
}

double FitProblem::forceOfUnitK(const FitValues& values) const {
  return law_.terms(values.coefficients, data_.model.deformationScale_m(), 0).elastic;
}

double FitProblem::elasticShare(const FitValues& values) const {
  return values.coefficients.k * forceOfUnitK(values) / data_.force_scale_N;
}

double FitProblem::dampingOfUnitShare(const FitValues& values) const {
  return law_.damping_grows_with_elastic ? 1.0 : forceOfUnitK(values);
}

double FitProblem::viscousShare_s_m(const FitValues& values) const {
  return valueOf(values, FitParameter::damping) / values.coefficients.k / dampingOfUnitShare(values);
}

double FitProblem::noiseOfViscousShare_N2(const FitValues& values) const {
  FitValues one = values;
  valueOf(one, FitParameter::damping) = values.coefficients.k * dampingOfUnitShare(values);
  Eigen::VectorXd noise_N(points());
  data_.model.evaluateNoise(one, {noise_N.data(), static_cast<std::size_t>(noise_N.size())});
  return (data_.root_weights.array() * noise_N.array()).matrix().squaredNorm();
}

FitValues FitProblem::valuesAt(const Eigen::VectorXd& place) const {
  FitValues values = settings_.fixed;
  double log_k = 0, damping_share = 0;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double at = place[static_cast<Eigen::Index>(i)];
    switch (free_[i]) {
      case FitParameter::elastic:
        log_k = std::clamp(at, -kLargestLogarithm, kLargestLogarithm);
        break;
      case FitParameter::damping:
        damping_share = at;
        break;
      case FitParameter::shape:
        valueOf(values, FitParameter::shape) =
            (search_.least + (search_.largest - search_.least) / (1 + std::exp(-at))) / shape_scale_;
        break;
      case FitParameter::offset:
        values.F0_N = at * data_.force_scale_N;
        break;
    }
  }
  double& k = values.coefficients.k;
  if (isFree(settings_, FitParameter::elastic))
    k = std::exp(log_k) * data_.force_scale_N / forceOfUnitK(values);
  if (isFree(settings_, FitParameter::damping))
    valueOf(values, FitParameter::damping) =
        damping_share * (dampingOfUnitShare(values) / data_.model.rateScale_m_s()) * k;
  return values;
}

Eigen::VectorXd FitProblem::placeOf(const FitValues& values) const {
  Eigen::VectorXd place(static_cast<Eigen::Index>(free_.size()));
  const double k = values.coefficients.k;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    double& at = place[static_cast<Eigen::Index>(i)];
    switch (free_[i]) {
      case FitParameter::elastic:
        at = std::log(k * forceOfUnitK(values) / data_.force_scale_N);
        break;
      case FitParameter::damping:
        at = valueOf(values, FitParameter::damping) / k /
             (dampingOfUnitShare(values) / data_.model.rateScale_m_s());
        break;
      case FitParameter::shape: {
        const double shape = std::clamp(valueOf(values, FitParameter::shape) * shape_scale_,
                                        search_.least + 1e-6, search_.largest - 1e-6);
        at = std::log((shape - search_.least) / (search_.largest - shape));
        break;
      }
      case FitParameter::offset:
        at = values.F0_N / data_.force_scale_N;
        break;
    }
  }
  return place;
}

void FitProblem::writeResiduals(const Eigen::VectorXd& place, Eigen::VectorXd& residuals) const {
  const FitValues values = valuesAt(place);
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

LeastSquares FitProblem::solveFrom(const FitValues& start) const {
  return leastSquares([this](const auto& at, auto& values) { writeResiduals(at, values); }, points(),
                      placeOf(start));
}

// At a given shape and without viscosity the law is linear in k and F0.
FitValues FitProblem::startAt(double shape) const {
  FitValues start = settings_.fixed;
  if (isFree(settings_, FitParameter::shape)) valueOf(start, FitParameter::shape) = shape / shape_scale_;
  if (isFree(settings_, FitParameter::damping)) valueOf(start, FitParameter::damping) = 0;
  FitValues unit = start;
  unit.coefficients.k = 1;
  Eigen::VectorXd law_N(points());
  data_.model.evaluate(unit, {law_N.data(), static_cast<std::size_t>(law_N.size())});
  const Eigen::ArrayXd weights = data_.root_weights.array().square() / data_.root_weights.squaredNorm();
  const bool offset_free = isFree(settings_, FitParameter::offset);
  const double offset_N = offset_free ? (weights * data_.force_N.array()).sum() : start.F0_N;
  const double mean_law = offset_free ? (weights * law_N.array()).sum() : 0;
  const Eigen::ArrayXd law = law_N.array() - mean_law, force_N = data_.force_N.array() - offset_N;
  const double squares = (weights * law.square()).sum();
  const double least = 1e-3 * data_.force_scale_N / forceOfUnitK(start);
  double& k = start.coefficients.k;
  if (isFree(settings_, FitParameter::elastic)) {
    k = squares > 0 ? (weights * law * force_N).sum() / squares : least;
    k = std::isfinite(k) ? std::max(k, least) : least;
  }
  if (offset_free) start.F0_N = offset_N - k * mean_law;
  return start;
}

LeastSquares FitProblem::solve() const {
  LeastSquares best;
  bool first = true;
  for (const double shape : search_.starts) {
    const LeastSquares found = solveFrom(startAt(shape));
    if (first || found.sum_of_squares < best.sum_of_squares) best = found;
    first = false;
    if (!isFree(settings_, FitParameter::shape)) break;  // the others would start at the same place
  }
  return best;
}

}  // namespace fissure
