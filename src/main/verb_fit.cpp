#include <algorithm>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "main/exit_codes.h"
#include "main/fit_output.h"
#include "main/result_json.h"
#include "main/verbs.h"
#include "scenario/did_you_mean.h"
#include "scenario/scalars.h"

namespace fissure {

namespace {

struct FitOptions {
  std::vector<std::string> files;
  std::string columns;
  std::string law = "hunt_crossley";
  std::string free;
  std::vector<std::string> fixed;
  bool together = false, json = false;
};

FitLaw lawOf(const std::string& name) {
  std::vector<std::string> known;
  for (const FitLaw law : {FitLaw::hunt_crossley, FitLaw::kelvin_voigt, FitLaw::linear_elastic}) {
    if (name == nameOf(law)) return law;
    known.push_back(nameOf(law));
  }
  throw InputError("--law " + name + ": no such force law" + didYouMean(name, known));
}

FitParameter parameterOf(const std::string& option, const std::string& name, FitLaw law) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < kFitParameters; ++i) {
    const auto parameter = static_cast<FitParameter>(i);
    if (!hasParameter(law, parameter)) continue;
    if (name == nameOf(parameter)) return parameter;
    known.push_back(nameOf(parameter));
  }
  throw InputError(option + ": " + nameOf(law) + " has no coefficient \"" + name + "\"" +
                   didYouMean(name, known));
}

/// All are free but what is fixed; with --free only those named are, and F0 and lambda are 0 unless fixed.
FitSettings settingsOf(const FitOptions& options, FitLaw law) {
  FitSettings settings;
  for (std::size_t i = 0; i < kFitParameters; ++i)
    settings.free[i] = options.free.empty() && hasParameter(law, static_cast<FitParameter>(i));
  for (std::size_t start = 0; !options.free.empty() && start <= options.free.size();) {
    const std::size_t end = std::min(options.free.find(',', start), options.free.size());
    const std::string name = options.free.substr(start, end - start);
    settings.free[static_cast<std::size_t>(parameterOf("--free " + options.free, name, law))] = true;
    start = end + 1;
  }
  std::array<bool, kFitParameters> fixed{};
  for (const std::string& text : options.fixed) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<double> value = equals < text.size() ? toReal(text.substr(equals + 1)) : std::nullopt;
    if (!value) throw InputError("--fix " + text + ": expected COEFFICIENT=NUMBER, as in lambda=0");
    const FitParameter parameter = parameterOf("--fix " + text, text.substr(0, equals), law);
    const auto index = static_cast<std::size_t>(parameter);
    if (!options.free.empty() && settings.free[index])
      throw InputError("--fix " + text + ": " + nameOf(parameter) + " is free too, expected one of them");
    if ((parameter == FitParameter::k || parameter == FitParameter::n) && *value <= 0)
      throw InputError("--fix " + text + ": expected a number above 0");
    valueOf(settings.fixed, parameter) = *value;
    settings.free[index] = false;
    fixed[index] = true;
  }
  for (const FitParameter parameter : {FitParameter::k, FitParameter::n}) {
    const auto index = static_cast<std::size_t>(parameter);
    if (hasParameter(law, parameter) && !settings.free[index] && !fixed[index])
      throw InputError("--free " + options.free + ": " + nameOf(parameter) +
                       " is neither free nor fixed, expected --fix " + nameOf(parameter) + "=NUMBER");
  }
  return settings;
}

std::vector<MeasuredCurve> readAll(const FitOptions& options) {
  const std::vector<CurveColumn> columns =
      options.columns.empty() ? std::vector<CurveColumn>() : parseCurveColumns(options.columns);
  std::vector<MeasuredCurve> curves;
  for (const std::string& file : options.files)
    for (MeasuredCurve& curve : readCurves(file, columns)) curves.push_back(std::move(curve));
  return options.together ? std::vector<MeasuredCurve>{joined(curves)} : curves;
}

CurveFit fitCurve(MeasuredCurve curve, FitLaw law, const FitSettings& settings) {
  CurveFit made{std::move(curve), {}, {}};
  try {
    made.fit = fitLaw(*makeProbeModel(law, made.curve), made.curve.force_N, made.curve.weights, settings);
  } catch (const InputError& error) {
    made.problem = error.what();
  }
  return made;
}

int fitCurves(const FitOptions& options) {
  const FitLaw law = lawOf(options.law);
  const FitSettings settings = settingsOf(options, law);
  std::vector<CurveFit> fits;
  for (MeasuredCurve& curve : readAll(options)) fits.push_back(fitCurve(std::move(curve), law, settings));
  if (fits.size() == 1 && !fits.front().problem.empty())
    throw InputError(fits.front().curve.name + ": " + fits.front().problem);
  const bool good = std::all_of(fits.begin(), fits.end(),
                                [](const CurveFit& fit) { return fit.problem.empty() && fit.fit.converged; });
  const int code = good ? exit_good : exit_run_failed;
  if (options.json) {
    nlohmann::ordered_json json = {{"exit_code", code}};
    json.update(fitJson(law, fits));
    std::cout << jsonText(json);
  } else {
    std::cout << fitText(law, fits);
  }
  return code;
}

}  // namespace

Verb addFit(CLI::App& app) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "force laws fitted to measured curves of force over depth");
  command->add_option("CURVE", options->files, "tables (CSV, TSV) of measured points, one line a point")
      ->required()
      ->check(notEmpty);
  command->add_option(
      "--columns", options->columns,
      "what the columns are: depth=d:mm,force=3:N,time=t_ms,sigma=s_N,weight=w,curve=probe; by name or "
      "number, units m, mm, N, mN, s, ms or a factor (default: by their names, as depth_mm, force_N, "
      "time_s)");
  command->add_option("--law", options->law, "hunt_crossley, kelvin_voigt or linear_elastic")
      ->capture_default_str();
  command->add_option(
      "--free", options->free,
      "what is fitted, as k,n,F0 (default: all of k, lambda, n, F0 that is not fixed); F0 and "
      "lambda are 0 else");
  command->add_option("--fix", options->fixed, "COEFFICIENT=NUMBER: not fitted; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--together", options->together, "one law for the points of all curves");
  command->add_flag("--json", options->json, "the fits for machines");
  return {command, [options] { return fitCurves(*options); }};
}

}  // namespace fissure
