#include "fit/modulus_fit.h"

#include <fmt/core.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/error.h"
#include "base/reproducible.h"
#include "fit/fit_intervals.h"
#include "fit/least_squares.h"
#include "text/units.h"

namespace fissure {

namespace {

using Values = std::array<double, 3>;  ///< E in Pa, F0 in N, d0 in m

constexpr double kWideFactor = 2;            ///< of the ends of E's interval
constexpr double kStrongCorrelation = 0.95;  ///< of E and an offset

/// The points to be fitted, and what is searched: log(E/E0) and the offsets over a typical force and depth.
class ModulusProblem {
 public:
  ModulusProblem(const PressCurve& press, const MeasuredCurve& points, const ModulusSettings& settings)
      : press_(press), points_(points), values_(settings.fixed) {
    for (const ModulusParameter parameter : kModulusParameters)
      if (settings.free[index(parameter)]) free_.push_back(index(parameter));
    double weights = 0, squares_N2 = 0;
    for (std::size_t i = 0; i < points.force_N.size(); ++i) {
      weights += points.weights[i];
      squares_N2 += points.weights[i] * points.force_N[i] * points.force_N[i];
    }
    mean_weight_ = weights / static_cast<double>(points.force_N.size());
    if (!(squares_N2 > 0)) throw InputError("every force is 0, expected forces of a press");
    scales_ = {1, std::sqrt(squares_N2 / weights), largestDepth_m()};
  }

  const std::vector<std::size_t>& free() const { return free_; }
  std::size_t size() const { return points_.force_N.size(); }
  double largestDepth_m() const { return *std::max_element(points_.depth_m.begin(), points_.depth_m.end()); }

  /// The coordinate of a value, and back.
  double onScale(std::size_t parameter, double value) const {
    return parameter == 0 ? reproducible::log(value / press_.youngs_modulus_Pa) : value / scales_[parameter];
  }
  double offScale(std::size_t parameter, double at) const {
    return parameter == 0 ? press_.youngs_modulus_Pa * reproducible::exp(at) : at * scales_[parameter];
  }

  double force_N(const Values& values, double depth_m) const {
    return values[0] / press_.youngs_modulus_Pa * press_.force(depth_m + values[2]) + values[1];
  }

  Values valuesAt(const Eigen::VectorXd& place) const {
    Values values = values_;
    for (std::size_t i = 0; i < free_.size(); ++i)
      values[free_[i]] = offScale(free_[i], place[static_cast<Eigen::Index>(i)]);
    return values;
  }

  void residuals(const Eigen::VectorXd& place, Eigen::VectorXd& found) const {
    const Values values = valuesAt(place);
    for (std::size_t i = 0; i < size(); ++i)
      found[static_cast<Eigen::Index>(i)] = std::sqrt(points_.weights[i] / mean_weight_) *
                                            (force_N(values, points_.depth_m[i]) - points_.force_N[i]);
  }
  Residuals function() const {
    return [this](const Eigen::VectorXd& place, Eigen::VectorXd& found) { residuals(place, found); };
  }
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& place) const {
    return jacobianOf(function(), static_cast<Eigen::Index>(size()), place);
  }

  /// The best of the searches from some offsets of the depth.
  LeastSquares solve() const {
    const bool depths = std::find(free_.begin(), free_.end(), std::size_t{2}) != free_.end();
    LeastSquares best;
    for (const double share : {0.0, 0.1, 0.4}) {
      if (!depths && share > 0) break;
      const LeastSquares found = solveFrom(startAt(share * largestDepth_m()));
      if (share == 0 || found.sum_of_squares < best.sum_of_squares) best = found;
    }
    return best;
  }
  LeastSquares solveFrom(const Values& start) const {
    Eigen::VectorXd place(static_cast<Eigen::Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i)
      place[static_cast<Eigen::Index>(i)] = onScale(free_[i], start[free_[i]]);
    return leastSquares(function(), static_cast<Eigen::Index>(size()), place);
  }

  /// The same with one parameter fixed.
  ModulusProblem with(std::size_t parameter, double value) const {
    ModulusProblem fixed = *this;
    fixed.values_[parameter] = value;
    std::erase(fixed.free_, parameter);
    return fixed;
  }

 private:
  /// E by least squares of the force without its offset.
  Values startAt(double d0_m) const {
    Values values = values_;
    if (std::find(free_.begin(), free_.end(), std::size_t{2}) != free_.end()) values[2] = d0_m;
    if (free_.empty() || free_.front() != 0) return values;
    double both_N2 = 0, simulated_N2 = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double force_N = press_.force(points_.depth_m[i] + values[2]);
      both_N2 += points_.weights[i] * force_N * points_.force_N[i];
      simulated_N2 += points_.weights[i] * force_N * force_N;
    }
    if (!(simulated_N2 > 0)) throw InputError("the simulated force is 0 at its points, expected a press");
    values[0] = press_.youngs_modulus_Pa * std::max(1e-6, both_N2 / simulated_N2);
    return values;
  }

  const PressCurve& press_;
  const MeasuredCurve& points_;
  Values values_;
  Values scales_{};
  double mean_weight_ = 1;
  std::vector<std::size_t> free_;
};

/// Errors, intervals and correlations around an optimum.
class ModulusIntervals {
 public:
  ModulusIntervals(const ModulusProblem& problem, const LeastSquares& best) : problem_(problem), best_(best) {
    const auto freedom = static_cast<double>(problem.size() - problem.free().size());
    variance_N2_ = best.sum_of_squares / freedom;
    t_ = studentT(freedom);
    if (problem.free().empty()) return;
    const Eigen::MatrixXd jacobian = problem.jacobian(best.place);
    const Eigen::VectorXd lengths = jacobian.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian * lengths.cwiseInverse().asDiagonal(),
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& singular = svd.singularValues();
    if (!(singular[singular.size() - 1] > FitIntervals::least_ratio * singular[0]))
      throw InputError("what is free does the same at its points, expected fewer in --free, or more depths");
    const Eigen::MatrixXd root =
        lengths.cwiseInverse().asDiagonal() * svd.matrixV() * singular.cwiseInverse().asDiagonal();
    inverse_ = root * root.transpose();
  }

  double error(std::size_t i) const { return std::sqrt(variance_N2_ * inverse_(at(i), at(i))); }
  double correlation(std::size_t i, std::size_t j) const {
    return inverse_(at(i), at(j)) / std::sqrt(inverse_(at(i), at(i)) * inverse_(at(j), at(j)));
  }

  /// Half the 95 % interval of the fitted curve at a depth.
  double halfWidth_N(double depth_m) const {
    const Residuals force = [&](const Eigen::VectorXd& place, Eigen::VectorXd& found) {
      found[0] = problem_.force_N(problem_.valuesAt(place), depth_m);
    };
    if (problem_.free().empty()) return 0;
    const Eigen::RowVectorXd gradient = jacobianOf(force, 1, best_.place).row(0);
    return t_ * std::sqrt(std::max(0.0, variance_N2_ * gradient.dot(gradient * inverse_)));
  }

  /// How far the interval of a coordinate reaches: to the side of `sign`, always above 0.
  double reach(std::size_t i, double sign) const {
    double inner = 0, outer = t_ * error(i);
    if (!(outer > 0)) return 0;
    for (int doubled = 0; growth(i, sign * outer) < t_; ++doubled) {
      if (doubled == 12) return std::numeric_limits<double>::infinity();
      inner = outer;
      outer *= 2;
    }
    for (int halved = 0; halved < 40; ++halved) {
      const double middle = (inner + outer) / 2;
      (growth(i, sign * middle) < t_ ? inner : outer) = middle;
    }
    return outer;
  }

 private:
  static Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

  /// sqrt((S - least S) / s^2) with a coordinate moved and the others fitted anew.
  double growth(std::size_t i, double step) const {
    const std::size_t parameter = problem_.free()[i];
    const double value = problem_.offScale(parameter, best_.place[at(i)] + step);
    if (!std::isfinite(value) || (parameter == 0 && !(value > 0))) return 0;  // an open end
    Values start = problem_.valuesAt(best_.place + inverse_.col(at(i)) * (step / inverse_(at(i), at(i))));
    start[parameter] = value;
    start[0] = std::max(start[0], std::numeric_limits<double>::min());
    const double sum_N2 = problem_.with(parameter, value).solveFrom(start).sum_of_squares;
    return std::sqrt(std::max(0.0, sum_N2 - best_.sum_of_squares) / variance_N2_);
  }

  const ModulusProblem& problem_;
  const LeastSquares& best_;
  double variance_N2_ = 0;   ///< of a residual of mean weight
  double t_ = 0;             ///< Student's, of 97.5 %
  Eigen::MatrixXd inverse_;  ///< of J'J
};

std::string howWellKnown(const ModulusValue& modulus) {
  if (!(modulus.low > 1e-3 * modulus.value) || !(modulus.high < 1e3 * modulus.value))
    return "E has an interval with an open end";
  return "E is known no better than within a factor of " + fourDigits(modulus.high / modulus.low);
}

void noteWhatIsNotTold(const std::vector<std::size_t>& free, ModulusFit& fit) {
  const ModulusValue& modulus = fit.of(ModulusParameter::modulus);
  if (modulus.free && !(modulus.high <= kWideFactor * modulus.low))
    fit.notes.push_back(howWellKnown(modulus) + ": these points do not tell more");
  for (const std::size_t a : free)
    for (const std::size_t b : free) {
      if (a >= b || std::abs(fit.correlation[a][b]) < kStrongCorrelation) continue;
      fit.notes.push_back(fmt::format(
          "{} and {} do nearly the same here (correlation {}): each is only as good as what is said of the "
          "other",
          nameOf(kModulusParameters[a]), nameOf(kModulusParameters[b]), fourDigits(fit.correlation[a][b])));
    }
}

void takeMisfit(const MeasuredCurve& points, double sum_of_squares, ModulusFit& fit) {
  double weights = 0, mean_N = 0, squares_N2 = 0;
  for (std::size_t i = 0; i < points.force_N.size(); ++i) {
    weights += points.weights[i];
    mean_N += points.weights[i] * points.force_N[i];
  }
  mean_N /= weights;
  const double count = static_cast<double>(points.force_N.size());
  for (std::size_t i = 0; i < points.force_N.size(); ++i)
    squares_N2 += points.weights[i] * count / weights * std::pow(points.force_N[i] - mean_N, 2);
  fit.rms_N = std::sqrt(sum_of_squares / count);
  fit.r_squared = 1 - sum_of_squares / squares_N2;
}

void predict(const ModulusProblem& problem, const ModulusIntervals& intervals, const LeastSquares& best,
             const PressCurve& press, const MeasuredCurve& beyond, ModulusFit& fit) {
  const Values values = problem.valuesAt(best.place);
  std::size_t missed = 0;
  for (std::size_t i = 0; i < beyond.force_N.size(); ++i) {
    const double depth_m = beyond.depth_m[i];
    if (depth_m + values[2] > press.deepest_m()) {
      ++missed;
      continue;
    }
    const double force_N = problem.force_N(values, depth_m), half_N = intervals.halfWidth_N(depth_m);
    const bool quartiles = !beyond.lower_quartile_N.empty();
    fit.predictions.push_back({depth_m, beyond.force_N[i], force_N, force_N - half_N, force_N + half_N,
                               quartiles ? beyond.lower_quartile_N[i] : std::nan(""),
                               quartiles ? beyond.upper_quartile_N[i] : std::nan("")});
  }
  if (missed > 0)
    fit.notes.push_back(fmt::format("{} not predicted, deeper than the simulation, which ends at {}",
                                    counted(missed, "point"), withUnit(press.deepest_m() - values[2], "m")));
}

/// The points up to the limit, and the others.
std::pair<MeasuredCurve, MeasuredCurve> parted(const MeasuredCurve& curve, double most_depth_m) {
  std::vector<std::size_t> fitted, beyond;
  for (std::size_t i = 0; i < curve.depth_m.size(); ++i)
    (curve.depth_m[i] <= most_depth_m ? fitted : beyond).push_back(i);
  return {pointsOf(curve, fitted), pointsOf(curve, beyond)};
}

InputError tooDeep(double depth_m, const PressCurve& press, double d0_m) {
  const std::string moved = d0_m == 0 ? "" : fmt::format(", moved by d0 = {},", withUnit(d0_m, "m"));
  return InputError(
      fmt::format("a point {} deep{} is deeper than the simulation, which ends at {}, expected a deeper "
                  "press, or --most-depth",
                  withUnit(depth_m, "m"), moved, withUnit(press.deepest_m(), "m")));
}

}  // namespace

std::string nameOf(ModulusParameter parameter) {
  return std::array{"E", "F0", "d0"}[index(parameter)];
}

std::string unitOf(ModulusParameter parameter) {
  return std::array{"Pa", "N", "m"}[index(parameter)];
}

ModulusFit fitModulus(const PressCurve& press, const MeasuredCurve& curve, const ModulusSettings& settings) {
  if (curve.depth_m.empty()) throw InputError("the curve has no depths, expected a column of them");
  const auto [points, beyond] = parted(curve, settings.most_depth_m);
  const auto free = static_cast<std::size_t>(std::count(settings.free.begin(), settings.free.end(), true));
  if (points.force_N.size() <= free)
    throw InputError(fmt::format("{} for {}, expected more points than these",
                                 counted(points.force_N.size(), "point"), counted(free, "free parameter")));
  const ModulusProblem problem(press, points, settings);
  if (problem.largestDepth_m() > press.deepest_m()) throw tooDeep(problem.largestDepth_m(), press, 0);
  if (!(problem.largestDepth_m() > 0)) throw InputError("no depth above 0, expected points of a press");
  const LeastSquares best = problem.solve();
  const Values values = problem.valuesAt(best.place);
  if (problem.largestDepth_m() + values[2] > press.deepest_m())
    throw tooDeep(problem.largestDepth_m(), press, values[2]);
  const ModulusIntervals intervals(problem, best);
  ModulusFit fit{.points = points.force_N.size(), .converged = best.converged};
  for (std::size_t p = 0; p < values.size(); ++p) fit.values[p].value = values[p];
  for (std::size_t i = 0; i < problem.free().size(); ++i) {
    const std::size_t p = problem.free()[i];
    ModulusValue& value = fit.values[p];
    const double place = best.place[static_cast<Eigen::Index>(i)];
    value.free = true;
    value.standard_error = intervals.error(i) * (p == 0 ? value.value : problem.offScale(p, 1));
    value.low = problem.offScale(p, place - intervals.reach(i, -1));
    value.high = problem.offScale(p, place + intervals.reach(i, 1));
    for (std::size_t j = 0; j < problem.free().size(); ++j)
      fit.correlation[p][problem.free()[j]] = intervals.correlation(i, j);
  }
  ModulusValue& depth = fit.values[index(ModulusParameter::depth_offset)];
  if (depth.free) depth.high = std::min(depth.high, press.deepest_m() - problem.largestDepth_m());
  takeMisfit(points, best.sum_of_squares, fit);
  noteWhatIsNotTold(problem.free(), fit);
  predict(problem, intervals, best, press, beyond, fit);
  return fit;
}

}  // namespace fissure
