#include "fit/law_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "contact/force_law.h"

namespace fissure {

namespace {

class ProbeModel : public LawModel {
 public:
  ProbeModel(FitLaw law, const MeasuredCurve& curve)
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
  FitLaw law() const override { return law_; }
  std::size_t size() const override { return depth_m_.size(); }
  void evaluate(const LawValues& values, std::span<double> force_N) const override {
    const std::unique_ptr<ForceLaw> law = forceLaw(values);
    for (std::size_t i = 0; i < depth_m_.size(); ++i) {
      const LawForce force = law->at(depth_m_[i], rate_m_s_[i]);
      force_N[i] = force.elastic_N + force.viscous_N;
    }
  }
  void evaluateNoise(const LawValues& values, std::span<double> noise_N) const override {
    const std::unique_ptr<ForceLaw> law = forceLaw(values);
    for (std::size_t i = 0; i < depth_m_.size(); ++i)
      noise_N[i] = std::abs(law->at(depth_m_[i], rate_noise_m_s_[i]).viscous_N);
  }
  double deformationScale_m() const override { return depth_scale_m_; }
  double rateScale_m_s() const override { return rate_scale_m_s_; }

 private:
  std::unique_ptr<ForceLaw> forceLaw(const LawValues& values) const {
    return makeForceLaw(nameOf(law_),
                        {.k = values.k, .lambda = values.lambda, .n = values.n, .c = values.lambda});
  }

  FitLaw law_;
  std::vector<double> depth_m_, rate_m_s_, rate_noise_m_s_;
  double depth_scale_m_ = 0, rate_scale_m_s_ = 0;
};

}  // namespace

void LawModel::evaluateNoise(const LawValues& /*values*/, std::span<double> noise_N) const {
  std::fill(noise_N.begin(), noise_N.end(), 0.0);
}

std::string nameOf(FitLaw law) {
  constexpr std::array names = {"hunt_crossley", "kelvin_voigt", "linear_elastic"};
  return names[static_cast<std::size_t>(law)];
}

std::string nameOf(FitParameter parameter) {
  constexpr std::array names = {"k", "lambda", "n", "F0"};
  return names[static_cast<std::size_t>(parameter)];
}

std::string unitOf(FitLaw law, FitParameter parameter) {
  const bool hunt_crossley = law == FitLaw::hunt_crossley;
  switch (parameter) {
    case FitParameter::k:
      return hunt_crossley ? "N/m^n" : "N/m";
    case FitParameter::lambda:
      return hunt_crossley ? "N s/m^(n+1)" : "N s/m";
    case FitParameter::n:
      return "1";
    case FitParameter::F0:
      break;
  }
  return "N";
}

bool hasParameter(FitLaw law, FitParameter parameter) {
  if (parameter == FitParameter::n) return law == FitLaw::hunt_crossley;
  return parameter != FitParameter::lambda || law != FitLaw::linear_elastic;
}

double& valueOf(LawValues& values, FitParameter parameter) {
  switch (parameter) {
    case FitParameter::k:
      return values.k;
    case FitParameter::lambda:
      return values.lambda;
    case FitParameter::n:
      return values.n;
    case FitParameter::F0:
      break;
  }
  return values.F0_N;
}

double valueOf(const LawValues& values, FitParameter parameter) {
  LawValues copy = values;
  return valueOf(copy, parameter);
}

std::unique_ptr<LawModel> makeProbeModel(FitLaw law, const MeasuredCurve& curve) {
  return std::make_unique<ProbeModel>(law, curve);
}

}  // namespace fissure
