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

void applyPreset(ElasticSettings& elastic) {
  if (!elastic.preset) return;
  const auto found =
      std::find_if(elasticPresets().begin(), elasticPresets().end(),
                   [&](const ElasticPreset& preset) { return preset.name == *elastic.preset; });
  if (found == elasticPresets().end()) return;
  elastic.youngs_modulus_Pa = found->youngs_modulus_Pa;
  elastic.poissons_ratio = found->poissons_ratio;
  elastic.density_kg_m3 = found->density_kg_m3;
}

}  // namespace fissure
