#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "fit/law_fit.h"
#include "fit/least_squares.h"

namespace fissure {

/// The measured data of a fit. The constructor throws InputError where there is nothing to fit.
struct FitData {
  FitData(const LawModel& fitted, std::span<const double> measured_force_N, std::span<const double> weights);

  const LawModel& model;
  Eigen::VectorXd force_N;
  Eigen::VectorXd root_weights;  ///< square roots of the weights, scaled to a mean square of 1
  double force_scale_N = 0;      ///< largest difference of two measured forces
  double squares_around_mean_N2 = 0;
};

/// A fit as residuals over coordinates of size one. d is the typical deformation
/// (LawModel::deformationScale_m), the force scale the largest difference of measured forces. The coordinates
/// are, for those parameters that are free and in this order: the logarithm of the elastic force at d over
/// the force scale (Hunt-Crossley: k d^n); the damping coefficient over k, times the rate scale; the position
/// of the shape between its limits (logistic); and F0 over the force scale. Using the force at d removes most
/// of the correlation between k and the shape.
class FitProblem {
 public:
  /// `data` must outlive this object.
  FitProblem(const FitData& data, const FitSettings& settings);

  const ForceLawEntry& law() const { return law_; }
  const std::vector<FitParameter>& free() const { return free_; }
  Eigen::Index points() const { return data_.force_N.size(); }
  FitValues valuesAt(const Eigen::VectorXd& place) const;
  Eigen::VectorXd placeOf(const FitValues& values) const;

  /// The best of several searches that start from different shapes.
  LeastSquares solve() const;
  LeastSquares solveFrom(const FitValues& start) const;

  /// The derivatives of the weighted residuals by the coordinates, and these residuals (newtons, one per
  /// point).
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& place) const;
  Eigen::VectorXd residuals(const Eigen::VectorXd& place) const;

  /// Damping force at 1 m/s over the elastic force, both at the deformation scale, s/m: lambda/k of
  /// Hunt-Crossley.
  double viscousShare_s_m(const FitValues& values) const;

  /// Sum of squares of the (weighted) residuals that noise of the rates causes where the viscous share is 1
  /// s/m.
  double noiseOfViscousShare_N2(const FitValues& values) const;

  /// The elastic force at the deformation scale where k is 1, newtons.
  double forceOfUnitK(const FitValues& values) const;

  /// The elastic force at the deformation scale over the force scale.
  double elasticShare(const FitValues& values) const;

  /// The limits between which the law's shape is searched, in its own unit.
  double leastShape() const { return search_.least / shape_scale_; }
  double largestShape() const { return search_.largest / shape_scale_; }
  /// The limit at which the shape lies; no value where it lies at none.
  std::optional<double> limitOfShape(const FitValues& values) const;

  /// The value of a parameter in `values`.
  double valueOf(const FitValues& values, FitParameter parameter) const;
  double& valueOf(FitValues& values, FitParameter parameter) const;

  /// The same problem with one parameter fixed.
  FitProblem with(FitParameter fixed, double value) const;

 private:
  void writeResiduals(const Eigen::VectorXd& place, Eigen::VectorXd& residuals) const;
  FitValues startAt(double shape) const;
  /// The damping coefficient over k where the viscous share is 1 s/m.
  double dampingOfUnitShare(const FitValues& values) const;

  const FitData& data_;
  const ForceLawEntry& law_;
  const ShapeSearch& search_;
  double shape_scale_ = 1;  ///< scale that makes the shape dimensionless: d, or 1
  FitSettings settings_;
  std::vector<FitParameter> free_;
};

}  // namespace fissure
