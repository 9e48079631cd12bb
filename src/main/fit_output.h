#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/law_fit.h"

namespace fissure {

/// A measured curve and what came of it: a fit, or the reason why there is none.
struct CurveFit {
  MeasuredCurve curve;
  LawFit fit;
  std::string problem;  ///< one line; empty: fitted
};

/// For people: one fit as a block, several as a table with a row a curve.
std::string fitText(FitLaw law, const std::vector<CurveFit>& fits);

/// For machines.
nlohmann::ordered_json fitJson(FitLaw law, const std::vector<CurveFit>& fits);

}  // namespace fissure
