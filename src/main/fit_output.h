#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fit/law_fit.h"

namespace fissure {

/// A measured curve and what came of it: a fit, or the reason why there is none.
struct CurveFit {
  MeasuredCurve curve;
  LawFit fit;
  std::string problem;  ///< one line; empty: fitted
};

/// For people: one fit as a block, several as a table with a row a curve.
std::string fitText(ForceModel law, const std::vector<CurveFit>& fits);

/// Its path as it was given; null: several.
nlohmann::ordered_json fileJson(const MeasuredCurve& curve);

/// What was left out of a curve, and its warnings.
std::vector<std::string> curveNotes(const MeasuredCurve& curve);

/// For machines.
nlohmann::ordered_json fitJson(ForceModel law, const std::vector<CurveFit>& fits);

}  // namespace fissure
