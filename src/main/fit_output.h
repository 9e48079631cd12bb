#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fit/law_fit.h"

namespace fissure {

/// A measured curve with its fit, or the reason why there is none.
struct CurveFit {
  MeasuredCurve curve;
  LawFit fit;
  std::string problem;  ///< reason why there is no fit, one line; empty: there is one
};

/// Fits as text for people: one fit as a block, several as a table with one row per curve.
std::string fitText(ForceModel law, const std::vector<CurveFit>& fits);

/// The curve's path as it was given; null for a curve joined from several files.
nlohmann::ordered_json fileJson(const MeasuredCurve& curve);

/// Notes about rows that were left out of a curve, and its warnings.
std::vector<std::string> curveNotes(const MeasuredCurve& curve);

/// The fits for programs.
nlohmann::ordered_json fitJson(ForceModel law, const std::vector<CurveFit>& fits);

}  // namespace fissure
