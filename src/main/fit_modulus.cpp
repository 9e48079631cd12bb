#include "main/fit_modulus.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "base/error.h"
#include "fit/modulus_fit.h"
#include "main/comparison.h"
#include "main/exit_codes.h"
#include "main/fit_output.h"
#include "main/result_json.h"
#include "main/text_table.h"
#include "process/apart.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/units.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

/// One result's modulus in a curve, or the reason why there is none.
struct PressFit {
  const PressCurve* press = nullptr;
  ModulusFit fit;
  std::string problem;  ///< one line; empty: fitted
};

std::size_t parameterOf(const std::string& option, const std::string& name) {
  std::vector<std::string> known;
  for (const ModulusParameter parameter : kModulusParameters) {
    if (name == nameOf(parameter)) return index(parameter);
    known.push_back(nameOf(parameter));
  }
  throw InputError(fmt::format("{}: nothing named \"{}\" in E/E0 f(d + d0) + F0{}", option, name,
                               didYouMean(name, known)));
}

/// E and F0 are free but what is fixed; with --free only those named are. Offsets are 0 else.
ModulusSettings settingsOf(const ModulusRequest& request) {
  ModulusSettings settings;
  settings.most_depth_m = request.most_depth_m.value_or(settings.most_depth_m);
  if (!request.free.empty()) settings.free.fill(false);
  for (std::size_t start = 0; !request.free.empty() && start <= request.free.size();) {
    const std::size_t end = std::min(request.free.find(',', start), request.free.size());
    settings.free[parameterOf("--free " + request.free, request.free.substr(start, end - start))] = true;
    start = end + 1;
  }
  std::array<bool, 3> fixed{};
  for (const std::string& text : request.fixed) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<double> value = equals < text.size() ? toReal(text.substr(equals + 1)) : std::nullopt;
    if (!value || !std::isfinite(*value))
      throw InputError("--fix " + text + ": expected E, F0 or d0=NUMBER, as in F0=0.05");
    const std::size_t parameter = parameterOf("--fix " + text, text.substr(0, equals));
    if (parameter == 0 && *value <= 0) throw InputError("--fix " + text + ": expected a number above 0");
    if (fixed[parameter] || (!request.free.empty() && settings.free[parameter]))
      throw InputError(fmt::format("--fix {}: it is {}, expected one of them", text,
                                   fixed[parameter] ? "fixed already" : "free too"));
    settings.fixed[parameter] = *value;
    settings.free[parameter] = false;
    fixed[parameter] = true;
  }
  if (!settings.free[0] && !fixed[0])
    throw InputError(
        fmt::format("--free {}: E is neither free nor fixed, expected --fix E=NUMBER", request.free));
  return settings;
}

std::string formulaOf(const ModulusFit& fit) {
  const auto has = [&](ModulusParameter p) { return fit.of(p).free || fit.of(p).value != 0; };
  return std::string("F = E/E0 f(d") + (has(ModulusParameter::depth_offset) ? " + d0)" : ")") +
         (has(ModulusParameter::force_offset) ? " + F0" : "");
}

std::string intervalText(const ModulusValue& value) {
  return value.free ? fourDigits(value.low) + " to " + fourDigits(value.high) : "fixed";
}

std::string verdictOf(const ModulusPrediction& point) {
  if (std::isnan(point.lower_quartile_N) || std::isnan(point.upper_quartile_N)) return "-";
  if (point.predicted_N < point.lower_quartile_N) return "below the quartiles";
  return point.predicted_N > point.upper_quartile_N ? "above the quartiles" : "within the quartiles";
}

std::string predictionText(const std::vector<ModulusPrediction>& predictions) {
  if (predictions.empty()) return "";
  std::vector<TextRow> rows = {{"  not fitted, predicted: depth m", "predicted N", "95 % of the curve",
                                "measured N", "quartiles", ""}};
  for (const ModulusPrediction& point : predictions) {
    const bool quartiles = !std::isnan(point.lower_quartile_N) && !std::isnan(point.upper_quartile_N);
    rows.push_back(
        {"  " + fourDigits(point.depth_m), fourDigits(point.predicted_N),
         fourDigits(point.low_N) + " to " + fourDigits(point.high_N), fourDigits(point.measured_N),
         quartiles ? fourDigits(point.lower_quartile_N) + " to " + fourDigits(point.upper_quartile_N) : "-",
         verdictOf(point)});
  }
  return alignedText(rows, 1, true);
}

std::string assumedOf(const PressCurve& press) {
  return fmt::format(
      "assumed, not fitted: Poisson's ratio {}, {}, and the simulation's sizes, hold, friction and mesh",
      fourDigits(press.poissons_ratio), press.material);
}

std::vector<std::string> notesOf(const PressFit& fit) {
  std::vector<std::string> notes = fit.fit.notes;
  notes.insert(notes.end(), fit.press->notes.begin(), fit.press->notes.end());
  return notes;
}

std::string blockText(const MeasuredCurve& curve, const PressFit& of) {
  const ModulusFit& fit = of.fit;
  std::string text = fmt::format("{}: {}, f of {} at E0 = {}, {} of {}\n", curve.name, formulaOf(fit),
                                 of.press->label, withUnit(of.press->youngs_modulus_Pa, "Pa"), fit.points,
                                 counted(curve.force_N.size(), "point"));
  std::vector<TextRow> rows = {{"", "value", "", "std error", "95 % interval"}};
  for (const ModulusParameter parameter : kModulusParameters) {
    const ModulusValue& value = fit.of(parameter);
    if (!value.free && value.value == 0) continue;
    rows.push_back({"  " + nameOf(parameter), fourDigits(value.value), unitOf(parameter),
                    value.free ? fourDigits(value.standard_error) : "-", intervalText(value)});
  }
  text += fmt::format("{}  RMS residual {} N, R2 {}{}\n", alignedText(rows, 1), fourDigits(fit.rms_N),
                      fourDigits(fit.r_squared), fit.converged ? "" : ", not converged");
  text += predictionText(fit.predictions);
  for (const std::string& note : notesOf(of)) text += "  " + note + "\n";
  return fmt::format("{}  {}\n  depths count from the step before the first reaction, known to {}\n", text,
                     assumedOf(*of.press), withUnit(of.press->first_step_m, "m"));
}

std::string tableText(const MeasuredCurve& curve, const std::vector<PressFit>& fits) {
  std::vector<TextRow> rows = {
      {"result", "nu", "RMS N", "E Pa", "95 %", "F0 N", "d0 m", "deepest: predicted N", "measured N", ""}};
  std::string notes;
  for (const PressFit& of : fits) {
    if (!of.problem.empty()) {
      notes += fmt::format("{}: not fitted: {}\n", of.press->label, of.problem);
      continue;
    }
    const ModulusValue& modulus = of.fit.of(ModulusParameter::modulus);
    const bool predicts = !of.fit.predictions.empty();
    rows.push_back({of.press->label, fourDigits(of.press->poissons_ratio), fourDigits(of.fit.rms_N),
                    fourDigits(modulus.value), intervalText(modulus),
                    fourDigits(of.fit.of(ModulusParameter::force_offset).value),
                    fourDigits(of.fit.of(ModulusParameter::depth_offset).value),
                    predicts ? fourDigits(of.fit.predictions.back().predicted_N) : "-",
                    predicts ? fourDigits(of.fit.predictions.back().measured_N) : "-",
                    predicts ? verdictOf(of.fit.predictions.back()) : ""});
    for (const std::string& note : notesOf(of)) notes += of.press->label + ": " + note + "\n";
  }
  return fmt::format("{}: {}, the least misfit first\n{}{}", curve.name, counted(fits.size(), "simulation"),
                     alignedText(rows, 1, true), notes);
}

Json valueJson(ModulusParameter parameter, const ModulusValue& value) {
  Json json = {{"value", value.value}, {"unit", unitOf(parameter)}, {"free", value.free}};
  if (value.free)
    json.update({{"standard_error", value.standard_error}, {"low", value.low}, {"high", value.high}});
  return json;
}

Json fitJson(const PressFit& of) {
  const PressCurve& press = *of.press;
  Json json = {{"result", press.label},
               {"youngs_modulus_Pa", press.youngs_modulus_Pa},
               {"poissons_ratio", press.poissons_ratio},
               {"material", press.material},
               {"deepest_m", press.deepest_m()},
               {"depth_zero_known_to_m", press.first_step_m}};
  if (!of.problem.empty()) {
    json["problem"] = of.problem;
    return json;
  }
  Json parameters = Json::object(), correlation = Json::object(), predictions = Json::array();
  for (const ModulusParameter a : kModulusParameters) {
    parameters[nameOf(a)] = valueJson(a, of.fit.of(a));
    for (const ModulusParameter b : kModulusParameters)
      if (a < b && of.fit.of(a).free && of.fit.of(b).free)
        correlation[nameOf(a) + "," + nameOf(b)] = of.fit.correlation[index(a)][index(b)];
  }
  for (const ModulusPrediction& point : of.fit.predictions)
    predictions.push_back({{"depth_m", point.depth_m},
                           {"predicted_N", point.predicted_N},
                           {"low_N", point.low_N},
                           {"high_N", point.high_N},
                           {"measured_N", point.measured_N},
                           {"lower_quartile_N", point.lower_quartile_N},
                           {"upper_quartile_N", point.upper_quartile_N}});
  json.update({{"converged", of.fit.converged},
               {"points", of.fit.points},
               {"rms_N", of.fit.rms_N},
               {"r_squared", of.fit.r_squared},
               {"parameters", parameters},
               {"correlation", correlation},
               {"predictions", predictions},
               {"notes", notesOf(of)}});
  return json;
}

std::vector<PressCurve> readAll(const std::vector<std::string>& results) {
  std::vector<PressCurve> presses;
  for (const std::string& text : results) {
    const ResultChoice choice = parseChoice(text);
    tryReading(choice.file, [&] { readPress(choice.file, choice.run); });
    presses.push_back(readPress(choice.file, choice.run));
  }
  return presses;
}

/// The least misfit first, those without a fit last.
std::vector<PressFit> fitsOf(const std::vector<PressCurve>& presses, const MeasuredCurve& curve,
                             const ModulusSettings& settings) {
  std::vector<PressFit> fits;
  for (const PressCurve& press : presses) {
    PressFit& made = fits.emplace_back(PressFit{&press, {}, {}});
    try {
      made.fit = fitModulus(press, curve, settings);
    } catch (const InputError& error) {
      made.problem = error.what();
    }
  }
  std::stable_sort(fits.begin(), fits.end(), [](const PressFit& a, const PressFit& b) {
    return a.problem.empty() != b.problem.empty() ? a.problem.empty() : a.fit.rms_N < b.fit.rms_N;
  });
  return fits;
}

}  // namespace

int fitModuli(const ModulusRequest& request, const std::vector<MeasuredCurve>& curves) {
  const ModulusSettings settings = settingsOf(request);
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  const PressRuns runs = pressRuns(request.results, request.output, display);
  for (const std::string& failure : runs.failures) std::cerr << failure << "\n";
  if (runs.results.empty()) return exit_run_failed;
  const std::vector<PressCurve> presses = readAll(runs.results);
  int code = runs.failures.empty() ? exit_good : exit_run_failed;
  std::string text;
  Json found = Json::array();
  for (const MeasuredCurve& curve : curves) {
    const std::vector<PressFit> fits = fitsOf(presses, curve, settings);
    if (curves.size() == 1 && !fits.front().problem.empty())
      throw InputError(labelOf(curve) + ": " + fits.front().problem);
    Json of_curve = Json::array();
    for (const PressFit& fit : fits) {
      if (!fit.problem.empty() || !fit.fit.converged) code = exit_run_failed;
      of_curve.push_back(fitJson(fit));
    }
    const bool block = fits.size() == 1 && fits.front().problem.empty();
    text += block ? blockText(curve, fits.front()) : tableText(curve, fits);
    for (const std::string& note : curveNotes(curve))
      text += (block ? "  " : curve.name + ": ") + note + "\n";
    found.push_back({{"curve", curve.name},
                     {"file", fileJson(curve)},
                     {"points", curve.force_N.size()},
                     {"notes", curveNotes(curve)},
                     {"fits", of_curve}});
  }
  std::cout << (request.json ? jsonText(Json{{"exit_code", code}, {"curves", found}}) : text);
  return code;
}

}  // namespace fissure
