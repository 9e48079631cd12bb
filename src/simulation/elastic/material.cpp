#include "elastic/material.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

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

ElementMaterials distinctMaterials(const ElementMaterials& given, std::size_t elements) {
  const std::vector<ElasticMaterial>& materials = given.materials;
  const auto fail = [](const std::string& why) { throw std::invalid_argument("elastic material: " + why); };
  if (materials.empty()) fail("there is none");
  for (const ElasticMaterial& material : materials) {
    checkMaterial(material);
    if (material.model != materials[0].model || material.mass_damping_1_s != materials[0].mass_damping_1_s)
      fail("model and mass_damping_1_s differ between regions, expected the same in all");
  }
  if (given.of_elements.empty()) return {{materials[0]}, {}};
  if (given.of_elements.size() != elements)
    fail(fmt::format("{} elements have one, of {}", given.of_elements.size(), elements));

  std::vector<bool> used(materials.size());
  for (const int material : given.of_elements) {
    if (material < 0 || material >= static_cast<int>(materials.size()))
      fail(fmt::format("{} is none of {}", material, materials.size()));
    used[static_cast<std::size_t>(material)] = true;
  }
  ElementMaterials distinct;
  std::vector<int> number(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!used[m]) continue;
    const auto same = std::find(distinct.materials.begin(), distinct.materials.end(), materials[m]);
    number[m] = static_cast<int>(same - distinct.materials.begin());
    if (same == distinct.materials.end()) distinct.materials.push_back(materials[m]);
  }
  for (const int material : given.of_elements)
    distinct.of_elements.push_back(number[static_cast<std::size_t>(material)]);
  return distinct;
}

}  // namespace fissure
