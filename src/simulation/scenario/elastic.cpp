#include "scenario/elastic.h"

#include <algorithm>

namespace fissure {

const std::vector<ElasticPreset>& elasticPresets() {
  static const std::vector<ElasticPreset> all = {
      {"liver", 5.4e3, 0.49, 1060, "E 5.4 kPa (G 1.8 kPa), nu 0.49, 1060 kg/m3: PMC6925591, table 1"},
      {"brain", 2.0e3, 0.49, 1040, "E 2.0 kPa (mu 670 Pa), nu 0.49: PMC9748497; 1040 kg/m3"},
      {"vessel_wall", 626e3, 0.49, 1050,
       "E 626 kPa (G 210 kPa), nu 0.49, 1050 kg/m3: hepatic artery, PMC6925591, table 1"},
      {"ecoflex_00_10", 54.21e3, 0.49, 1040,
       "E 54.2 kPa, silicone: github.com/abubakardawood/phantom-material-database (CC BY 4.0); nu assumed"},
      {"ecoflex_00_30", 97.26e3, 0.49, 1070, "E 97.3 kPa, silicone: the same database; nu assumed"},
      {"ecoflex_00_50", 152.7e3, 0.49, 1070, "E 153 kPa, silicone: the same database; nu assumed"},
      {"ecoflex_00_10_thinned", 5.42e3, 0.49, 1000,
       "E 5.4 kPa, 00-10 with as much thinner as either part, soft as liver: the same database; nu, density "
       "assumed"}};
  return all;
}

namespace {

template <class Material>
void applyTo(Material& material) {
  if (!material.preset) return;
  const auto found =
      std::find_if(elasticPresets().begin(), elasticPresets().end(),
                   [&](const ElasticPreset& preset) { return preset.name == *material.preset; });
  if (found == elasticPresets().end()) return;
  material.youngs_modulus_Pa = found->youngs_modulus_Pa;
  material.poissons_ratio = found->poissons_ratio;
  material.density_kg_m3 = found->density_kg_m3;
}

}  // namespace

void applyPreset(ElasticSettings& elastic) {
  applyTo(elastic);
}

void applyPreset(ElasticRegion& region) {
  applyTo(region);
}

ElasticSettings ElasticSettings::materialOf(const ElasticRegion& region) const {
  ElasticSettings own = *this;
  own.preset.reset();
  own.regions.clear();
  own.youngs_modulus_Pa = region.youngs_modulus_Pa.value_or(youngs_modulus_Pa);
  own.poissons_ratio = region.poissons_ratio.value_or(poissons_ratio);
  own.density_kg_m3 = region.density_kg_m3.value_or(density_kg_m3);
  own.viscosity_Pa_s = region.viscosity_Pa_s.value_or(viscosity_Pa_s);
  return own;
}

}  // namespace fissure
