#include "main/fit_output.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "main/text_table.h"
#include "text/units.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

std::string formulaOf(ForceModel law) {
  return std::string(entryOf(law).fit_formula);
}

std::vector<FitParameter> parametersOf(ForceModel law) {
  std::vector<FitParameter> parameters;
  for (const FitParameter parameter : kFitParameters)
    if (hasParameter(law, parameter)) parameters.push_back(parameter);
  return parameters;
}

std::string intervalText(const FittedValue& value) {
  return fourDigits(value.low) + " to " + fourDigits(value.high);
}

std::vector<std::string> notesOf(const CurveFit& fit) {
  std::vector<std::string> notes = curveNotes(fit.curve);
  if (fit.problem.empty()) notes.insert(notes.end(), fit.fit.notes.begin(), fit.fit.notes.end());
  return notes;
}

std::string blockText(ForceModel law, const CurveFit& fit) {
  const LawFit& of = fit.fit;
  std::vector<TextRow> rows = {{"", "value", "", "std error", "95 % interval", ""}};
  for (const FitParameter parameter : parametersOf(law)) {
    const FittedValue& value = of.of(parameter);
    rows.push_back({"  " + nameOf(law, parameter), fourDigits(value.value), unitOf(law, parameter),
                    value.free ? fourDigits(value.standard_error) : "-",
                    value.free ? intervalText(value) : "fixed", value.profiled ? "by profile" : ""});
  }
  if (std::isfinite(of.lambda_over_k_s_m))
    rows.push_back({"  lambda/k", fourDigits(of.lambda_over_k_s_m), "s/m", "",
                    fourDigits(of.lambda_over_k_s_m - of.lambda_over_k_half_width_s_m) + " to " +
                        fourDigits(of.lambda_over_k_s_m + of.lambda_over_k_half_width_s_m),
                    ""});
  return fmt::format("{}: {}, {}\n{}  RMS residual {} N, R2 {}{}\n", fit.curve.name, formulaOf(law),
                     counted(of.points, "point"), alignedText(rows, 1), fourDigits(of.rms_N),
                     fourDigits(of.r_squared), of.converged ? "" : ", not converged");
}

std::string tableText(ForceModel law, const std::vector<CurveFit>& fits) {
  std::vector<TextRow> rows(1, {"curve", "points"});
  for (const FitParameter parameter : parametersOf(law)) {
    std::string& head = rows[0].emplace_back(nameOf(law, parameter));
    if (unitOf(law, parameter) != "1") head.append(" ").append(unitOf(law, parameter));
    rows[0].emplace_back("95 %");
  }
  rows[0].insert(rows[0].end(), {"RMS N", "R2"});
  for (const CurveFit& fit : fits) {
    const bool fitted = fit.problem.empty();
    TextRow& row = rows.emplace_back(TextRow{fit.curve.name, std::to_string(fit.curve.force_N.size())});
    for (const FitParameter parameter : parametersOf(law)) {
      const FittedValue& value = fit.fit.of(parameter);
      row.push_back(fitted ? fourDigits(value.value) : "-");
      row.push_back(!fitted ? "-" : value.free ? intervalText(value) : "fixed");
    }
    row.push_back(fitted ? fourDigits(fit.fit.rms_N) : "-");
    row.push_back(fitted ? fourDigits(fit.fit.r_squared) : "-");
  }
  return formulaOf(law) + "\n" + alignedText(rows, 1);
}

Json valueJson(ForceModel law, FitParameter parameter, const FittedValue& value) {
  Json json = {{"value", value.value}, {"unit", unitOf(law, parameter)}, {"free", value.free}};
  if (value.free) {
    json["standard_error"] = value.standard_error;
    json["low"] = value.low;
    json["high"] = value.high;
    json["interval"] = value.profiled ? "profile" : "linear";
  }
  if (!value.problem.empty()) json["not_identified"] = value.problem;
  return json;
}

Json fittedJson(ForceModel law, const LawFit& fit) {
  Json parameters = Json::object(), correlation = Json::object();
  for (const FitParameter parameter : parametersOf(law)) {
    parameters[nameOf(law, parameter)] = valueJson(law, parameter, fit.of(parameter));
    for (const FitParameter other : parametersOf(law))
      if (parameter < other && fit.of(parameter).free && fit.of(other).free)
        correlation[nameOf(law, parameter) + "," + nameOf(law, other)] =
            fit.correlation[index(parameter)][index(other)];
  }
  Json json = {{"converged", fit.converged},
               {"rms_N", fit.rms_N},
               {"r_squared", fit.r_squared},
               {"singular_value_ratio", fit.singular_value_ratio},
               {"next_residual_correlation", fit.next_correlation},
               {"parameters", parameters},
               {"correlation", correlation}};
  if (std::isfinite(fit.lambda_over_k_s_m)) {
    json["lambda_over_k_s_m"] = fit.lambda_over_k_s_m;
    json["lambda_over_k_half_width_s_m"] = fit.lambda_over_k_half_width_s_m;
  }
  return json;
}

}  // namespace

std::vector<std::string> curveNotes(const MeasuredCurve& curve) {
  std::vector<std::string> notes;
  if (curve.rows_without_numbers > 0)
    notes.push_back("left out " + counted(curve.rows_without_numbers, "row") + " without numbers");
  if (curve.rows_before_contact > 0)
    notes.push_back("left out " + counted(curve.rows_before_contact, "row") + " before contact (depth < 0)");
  notes.insert(notes.end(), curve.warnings.begin(), curve.warnings.end());
  return notes;
}

Json fileJson(const MeasuredCurve& curve) {
  return curve.file.empty() ? Json() : Json(curve.file);
}

std::string fitText(ForceModel law, const std::vector<CurveFit>& fits) {
  const bool block = fits.size() == 1 && fits.front().problem.empty();
  std::string text = block ? blockText(law, fits.front()) : tableText(law, fits);
  for (const CurveFit& fit : fits) {
    if (!fit.problem.empty()) text += fmt::format("{}: not fitted: {}\n", labelOf(fit.curve), fit.problem);
    for (const std::string& note : notesOf(fit)) text += (block ? "  " : fit.curve.name + ": ") + note + "\n";
  }
  return text;
}

Json fitJson(ForceModel law, const std::vector<CurveFit>& fits) {
  Json curves = Json::array();
  for (const CurveFit& fit : fits) {
    Json json = {{"curve", fit.curve.name},
                 {"file", fileJson(fit.curve)},
                 {"points", fit.curve.force_N.size()},
                 {"rows_without_numbers", fit.curve.rows_without_numbers},
                 {"rows_before_contact", fit.curve.rows_before_contact}};
    if (fit.problem.empty())
      json.update(fittedJson(law, fit.fit));
    else
      json["problem"] = fit.problem;
    json["notes"] = notesOf(fit);
    curves.push_back(json);
  }
  return {{"law", entryOf(law).name}, {"curves", curves}};
}

}  // namespace fissure
