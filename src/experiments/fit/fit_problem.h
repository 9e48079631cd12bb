#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "fit/law_fit.h"
#include "fit/least_squares.h"

namespace fissure {

/// The measured side of a fit. Throws InputError where it holds nothing to fit.
struct FitData {
  FitData(const LawModel& fitted, std::span<const double> measured_force_N, std::span<const double> weights);

  const LawModel& model;
  Eigen::VectorXd force_N;
  Eigen::VectorXd root_weights;  ///< their mean square is 1
  double force_scale_N = 0;      ///< the largest difference of forces
  double squares_around_mean_N2 = 0;
};

/// A fit as residuals over coordinates of size one. d, the deformation scale, is the typical deformation
/// (LawModel::deformationScale_m), the force scale the largest difference of the measured forces. The
/// coordinates are the logarithm of the elastic force at d over the force scale (Hunt-Crossley: k d^n), the
/// damping coefficient over k times the rate scale, the shape's place between its limits (logistic), F0 over
/// the force scale. Taking the force at d takes most of the correlation between k and the shape away. Those
/// of what is free, in that order.
class FitProblem {
 public:
  /// `data` must outlive it.
  FitProblem(const FitData& data, const FitSettings& settings);

  const ForceLawEntry& law() const { return law_; }
  const std::vector<FitParameter>& free() const { return free_; }
  Eigen::Index points() const { return data_.force_N.size(); }
  FitValues valuesAt(const Eigen::VectorXd& place) const;
  Eigen::VectorXd placeOf(const FitValues& values) const;

  /// The best of the searches from several shapes.
  LeastSquares solve() const;
  LeastSquares solveFrom(const FitValues& start) const;

  /// The weighted residuals (newtons, one per point) and their derivatives by the coordinates.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& place) const;
  Eigen::VectorXd residuals(const Eigen::VectorXd& place) const;

  /// Damping force at 1 m/s over the elastic force, both at the deformation scale, s/m: lambda/k of
  /// Hunt-Crossley.
  double viscousShare_s_m(const FitValues& values) const;

  /// Sum of squares that noise of the rates makes of (weighted) residuals where that share is 1 s/m.
  double noiseOfViscousShare_N2(const FitValues& values) const;

  /// The elastic force at the deformation scale where k is 1, newtons.
  double forceOfUnitK(const FitValues& values) const;

  /// The elastic force at the deformation scale over the force scale.
  double elasticShare(const FitValues& values) const;

  /// What the law's shape is searched between, in its own unit.
  double leastShape() const { return search_.least / shape_scale_; }
  double largestShape() const { return search_.largest / shape_scale_; }
  /// The end of that range at which a shape lies, if it does.
  std::optional<double> limitOfShape(const FitValues& values) const;

  /// By the law's own member for it.
  double valueOf(const FitValues& values, FitParameter parameter) const;
  double& valueOf(FitValues& values, FitParameter parameter) const;

  /// The same with one coefficient fixed.
  FitProblem with(FitParameter fixed, double value) const;

 private:
  void writeResiduals(const Eigen::VectorXd& place, Eigen::VectorXd& residuals) const;
  FitValues startAt(double shape) const;
  /// The damping coefficient over k where the viscous share is 1 s/m.
  double dampingOfUnitShare(const FitValues& values) const;

  const FitData& data_;
  const ForceLawEntry& law_;
  const ShapeSearch& search_;
  double shape_scale_ = 1;  ///< makes the shape a number without a unit: d, or 1
  FitSettings settings_;
  std::vector<FitParameter> free_;
};

}  // namespace fissure
