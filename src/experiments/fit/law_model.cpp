#include "fit/law_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/error.h"

namespace fissure {

namespace {

class ProbeModel : public LawModel {
 public:
  ProbeModel(ForceModel law, const MeasuredCurve& curve)
      : law_(law), depth_m_(curve.depth_m), rate_m_s_(curve.rate_m_s), rate_noise_m_s_(curve.rate_noise_m_s) {
    if (depth_m_.empty()) throw InputError("the curve has no depths, expected a column of them");
    rate_m_s_.resize(depth_m_.size(), 0);
    rate_noise_m_s_.resize(depth_m_.size(), 0);
    double squares_m2 = 0;
    for (std::size_t i = 0; i < depth_m_.size(); ++i) {
      squares_m2 += depth_m_[i] * depth_m_[i] / static_cast<double>(depth_m_.size());
      if (depth_m_[i] > 0) rate_scale_m_s_ = std::max(rate_scale_m_s_, std::abs(rate_m_s_[i]));
    }
    depth_scale_m_ = std::sqrt(squares_m2);
    if (!(depth_scale_m_ > 0)) throw InputError("all depths are 0, expected some above");
  }
  ForceModel law() const override { return law_; }
  std::size_t size() const override { return depth_m_.size(); }
  void evaluate(const FitValues& values, std::span<double> force_N) const override {
    const ForceLaw law(law_, values.coefficients);
    for (std::size_t i = 0; i < depth_m_.size(); ++i) {
      const LawForce force = law.at(depth_m_[i], rate_m_s_[i]);
      force_N[i] = force.elastic_N + force.viscous_N;
    }
  }
  void evaluateNoise(const FitValues& values, std::span<double> noise_N) const override {
    const ForceLaw law(law_, values.coefficients);
    for (std::size_t i = 0; i < depth_m_.size(); ++i)
      noise_N[i] = std::abs(law.at(depth_m_[i], rate_noise_m_s_[i]).viscous_N);
  }
  double deformationScale_m() const override { return depth_scale_m_; }
  double rateScale_m_s() const override { return rate_scale_m_s_; }

 private:
  ForceModel law_;
  std::vector<double> depth_m_, rate_m_s_, rate_noise_m_s_;
  double depth_scale_m_ = 0, rate_scale_m_s_ = 0;
};

}  // namespace

void LawModel::evaluateNoise(const FitValues& /*values*/, std::span<double> noise_N) const {
  std::fill(noise_N.begin(), noise_N.end(), 0.0);
}

namespace {

/// Null for F0.
const LawCoefficient* coefficientOf(ForceModel law, FitParameter parameter) {
  switch (parameter) {
    case FitParameter::elastic:
      return entryOf(law).find(CoefficientRole::elastic);
    case FitParameter::damping:
      return entryOf(law).find(CoefficientRole::damping);
    case FitParameter::shape:
      return entryOf(law).find(CoefficientRole::shape);
    case FitParameter::offset:
      break;
  }
  return nullptr;
}

const LawCoefficient& requiredCoefficient(ForceModel law, FitParameter parameter) {
  const LawCoefficient* coefficient = coefficientOf(law, parameter);
  if (coefficient == nullptr)
    throw std::invalid_argument("the law " + std::string(entryOf(law).name) + " has no such coefficient");
  return *coefficient;
}

}  // namespace

bool hasParameter(ForceModel law, FitParameter parameter) {
  return parameter == FitParameter::offset || coefficientOf(law, parameter) != nullptr;
}

std::string nameOf(ForceModel law, FitParameter parameter) {
  return parameter == FitParameter::offset ? "F0" : std::string(requiredCoefficient(law, parameter).name);
}

std::string unitOf(ForceModel law, FitParameter parameter) {
  return parameter == FitParameter::offset ? "N" : std::string(requiredCoefficient(law, parameter).unit);
}

double& valueOf(ForceModel law, FitValues& values, FitParameter parameter) {
  if (parameter == FitParameter::offset) return values.F0_N;
  return values.coefficients.*requiredCoefficient(law, parameter).member;
}

double valueOf(ForceModel law, const FitValues& values, FitParameter parameter) {
  FitValues copy = values;
  return valueOf(law, copy, parameter);
}

std::unique_ptr<LawModel> makeProbeModel(ForceModel law, const MeasuredCurve& curve) {
  return std::make_unique<ProbeModel>(law, curve);
}

}  // namespace fissure
