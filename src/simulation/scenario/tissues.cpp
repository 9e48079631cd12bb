#include "scenario/tissues.h"

#include <algorithm>

namespace fissure {

const std::vector<Tissue>& tissues() {
  static const std::vector<Tissue> all = {
      {"pig_liver_1", 6.08e5, 2.40, "k 6.08e5, n 2.40, F0 0.029 N to 2 mm: pig liver, region 1 (221 probes)"},
      {"pig_liver_2", 1.90e7, 2.95,
       "k 1.90e7, n 2.95, F0 0.060 N to 3 mm: second pig liver, region 2 (77 probes)"},
      {"pig_liver_3", 1.33e7, 2.80,
       "k 1.33e7, n 2.80, F0 0.072 N to 3 mm: second pig liver, region 3 (73 probes)"},
      {"meat_1", 1.13e5, 2.15, "k 1.13e5, n 2.15, F0 0.035 N to 3 mm: meat, region 1 (117 probes)"},
      {"meat_4", 7.38e3, 1.70, "k 7.38e3, n 1.70, F0 0.039 N to 3 mm: meat, region 4 (101 probes)"},
      {"phantom_balls", 2.54e3, 1.45,
       "k 2.54e3, n 1.45, F0 0.113 N to 3 mm: phantom with small balls (100 probes)"},
      {"phantom_silicone", 2.88e3, 1.30,
       "k 2.88e3, n 1.30, F0 0.119 N to 3 mm: silicone phantom (728 probes)"}};
  return all;
}

namespace {

/// The tissue that a law names; null without one or with an unknown one.
const Tissue* tissueOf(const ForceSettings& law) {
  const auto found = std::find_if(tissues().begin(), tissues().end(),
                                  [&](const Tissue& tissue) { return tissue.name == law.tissue; });
  return found == tissues().end() ? nullptr : &*found;
}

}  // namespace

void applyTissue(ForceSettings& law) {
  const Tissue* found = tissueOf(law);
  if (!found) return;
  law.coefficients.k = found->k;
  law.coefficients.n = found->n;
  law.coefficients.lambda = assumed_lambda_over_k_s_m * found->k;
}

bool isOfWholeProbe(const ForceSettings& law) {
  const Tissue* found = tissueOf(law);
  return found && law.coefficients.k == found->k;
}

}  // namespace fissure
