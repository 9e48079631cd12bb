#include "contact/force_law.h"

#include <cmath>
#include <stdexcept>

namespace fissure {

namespace {

LawForce clamped(double elastic_N, double viscous_N) {
  if (elastic_N + viscous_N < 0) return {0, 0, true};
  return {elastic_N, viscous_N, false};
}

class HuntCrossley : public ForceLaw {
 public:
  HuntCrossley(double k, double lambda, double n) : k_(k), lambda_(lambda), n_(n) {}
  LawForce at(double deformation_m, double rate_m_s) const override {
    if (deformation_m <= 0) return {};
    const double power = std::pow(deformation_m, n_);
    return clamped(k_ * power, lambda_ * power * rate_m_s);
  }

 private:
  double k_, lambda_, n_;
};

class KelvinVoigt : public ForceLaw {
 public:
  KelvinVoigt(double k, double c) : k_(k), c_(c) {}
  LawForce at(double deformation_m, double rate_m_s) const override {
    if (deformation_m < 0) return {};
    return clamped(k_ * deformation_m, c_ * rate_m_s);
  }

 private:
  double k_, c_;
};

class LinearElastic : public ForceLaw {
 public:
  explicit LinearElastic(double k) : k_(k) {}
  LawForce at(double deformation_m, double) const override {
    return deformation_m <= 0 ? LawForce{} : LawForce{k_ * deformation_m, 0, false};
  }

 private:
  double k_;
};

}  // namespace

std::unique_ptr<ForceLaw> makeHuntCrossley(double k, double lambda, double n) {
  return std::make_unique<HuntCrossley>(k, lambda, n);
}

std::unique_ptr<ForceLaw> makeKelvinVoigt(double k, double c) {
  return std::make_unique<KelvinVoigt>(k, c);
}

std::unique_ptr<ForceLaw> makeLinearElastic(double k) {
  return std::make_unique<LinearElastic>(k);
}

std::unique_ptr<ForceLaw> makeForceLaw(const std::string& model, const ForceCoefficients& coefficients) {
  const auto& [k, lambda, n, c] = coefficients;
  if (model == "hunt_crossley") return makeHuntCrossley(k, lambda, n);
  if (model == "kelvin_voigt") return makeKelvinVoigt(k, c);
  if (model == "linear_elastic") return makeLinearElastic(k);
  throw std::invalid_argument("no force law '" + model + "' in this engine");
}

}  // namespace fissure
