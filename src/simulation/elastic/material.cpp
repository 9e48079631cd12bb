#include "elastic/material.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace fissure {

namespace {

void require(bool holds, const char* name, double value, const char* range) {
  if (holds) return;
  std::ostringstream line;
  line << "elastic material: " << name << " is " << value << ", expected " << range;
  throw std::invalid_argument(line.str());
}

}  // namespace

LameConstants lameConstants(double youngs_modulus_Pa, double poissons_ratio) {
  return {youngs_modulus_Pa * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus_Pa / (2 * (1 + poissons_ratio))};
}

void checkMaterial(const ElasticMaterial& material) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  const auto notNegative = [](double value) { return std::isfinite(value) && value >= 0; };
  require(positive(material.youngs_modulus_Pa), "youngs_modulus_Pa", material.youngs_modulus_Pa,
          "a number above 0");
  require(material.poissons_ratio >= 0 && material.poissons_ratio < 0.5, "poissons_ratio",
          material.poissons_ratio, "a number from 0 and below 0.5");
  require(positive(material.density_kg_m3), "density_kg_m3", material.density_kg_m3, "a number above 0");
  require(notNegative(material.viscosity_Pa_s), "viscosity_Pa_s", material.viscosity_Pa_s, "a number from 0");
  require(notNegative(material.mass_damping_1_s), "mass_damping_1_s", material.mass_damping_1_s,
          "a number from 0");
}

}  // namespace fissure
