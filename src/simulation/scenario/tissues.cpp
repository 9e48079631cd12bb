#include "scenario/tissues.h"

#include <algorithm>

namespace fissure {

const std::vector<Tissue>& tissues() {
  static const std::vector<Tissue> all = {{"pig_liver_1", 6.08e5, 2.40},     {"pig_liver_2", 1.90e7, 2.95},
                                          {"pig_liver_3", 1.33e7, 2.80},     {"meat_1", 1.13e5, 2.15},
                                          {"meat_4", 7.38e3, 1.70},          {"phantom_balls", 2.54e3, 1.45},
                                          {"phantom_silicone", 2.88e3, 1.30}};
  return all;
}

void applyTissue(ForceSettings& law) {
  if (!law.tissue) return;
  const auto found = std::find_if(tissues().begin(), tissues().end(),
                                  [&](const Tissue& tissue) { return tissue.name == *law.tissue; });
  if (found == tissues().end()) return;
  law.coefficients.k = found->k;
  law.coefficients.n = found->n;
  law.coefficients.lambda = assumed_lambda_over_k_s_m * found->k;
}

}  // namespace fissure
