#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "calibrate/press_runs.h"
#include "fit/simulated_model.h"
#include "main/comparison.h"
#include "main/exit_codes.h"
#include "main/fit_modulus.h"
#include "main/fit_output.h"
#include "main/fit_ranking.h"
#include "main/result_json.h"
#include "main/verbs.h"
#include "process/apart.h"
#include "sweep/sweep_file.h"
#include "text/did_you_mean.h"
#include "text/lists.h"
#include "text/scalars.h"

namespace fissure {

namespace {

struct FitOptions {
  std::vector<std::string> files;
  std::string columns;
  std::string law = "hunt_crossley";
  std::string free;
  std::vector<std::string> fixed;
  std::string result, sweep, match;
  PressOutput output;
  std::vector<std::string> modulus;
  std::optional<double> most_depth_m;
  std::size_t best = 20;
  bool together = false, json = false;
};

std::vector<std::string> lawNames() {
  std::vector<std::string> names;
  for (const ForceLawEntry& law : forceLaws()) names.emplace_back(law.name);
  return names;
}

std::string lawChoices() {
  std::vector<std::string_view> names;
  for (const ForceLawEntry& law : forceLaws()) names.push_back(law.name);
  return inWords(names, "or");
}

ForceModel lawOf(const std::string& name) {
  const std::optional<ForceModel> law = modelNamed(name);
  if (!law) throw InputError("--law " + name + ": no such force law" + didYouMean(name, lawNames()));
  return *law;
}

FitParameter parameterOf(const std::string& option, const std::string& name, ForceModel law) {
  std::vector<std::string> known;
  for (const FitParameter parameter : kFitParameters) {
    if (!hasParameter(law, parameter)) continue;
    if (name == nameOf(law, parameter)) return parameter;
    known.push_back(nameOf(law, parameter));
  }
  throw InputError(fmt::format("{}: {} has no coefficient \"{}\"{}", option, entryOf(law).name, name,
                               didYouMean(name, known)));
}

std::pair<FitParameter, double> parseFixed(const std::string& text, ForceModel law) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::optional<double> value = equals < text.size() ? toReal(text.substr(equals + 1)) : std::nullopt;
  if (!value || !std::isfinite(*value))
    throw InputError("--fix " + text + ": expected COEFFICIENT=NUMBER, as in lambda=0");
  const FitParameter parameter = parameterOf("--fix " + text, text.substr(0, equals), law);
  if ((parameter == FitParameter::elastic || parameter == FitParameter::shape) && *value <= 0)
    throw InputError("--fix " + text + ": expected a number above 0");
  return {parameter, *value};
}

/// Returns the F0 that the options fix. A ranking of laws can fix nothing else.
std::optional<double> fixedOffset_N(const FitOptions& options) {
  std::optional<double> offset_N;
  for (const std::string& text : options.fixed) {
    const auto [parameter, value] = parseFixed(text, ForceModel::hunt_crossley);
    if (parameter != FitParameter::offset || offset_N)
      throw InputError("--fix " + text + ": nothing is fitted with --sweep, expected F0 alone, and once");
    offset_N = value;
  }
  return offset_N;
}

/// All are free but what is fixed; with --free only those named are, and F0 and the damping are 0 unless
/// fixed.
FitSettings settingsOf(const FitOptions& options, ForceModel law) {
  FitSettings settings;
  for (const FitParameter parameter : kFitParameters)
    settings.free[index(parameter)] = options.free.empty() && hasParameter(law, parameter);
  for (std::size_t start = 0; !options.free.empty() && start <= options.free.size();) {
    const std::size_t end = std::min(options.free.find(',', start), options.free.size());
    const std::string name = options.free.substr(start, end - start);
    settings.free[index(parameterOf("--free " + options.free, name, law))] = true;
    start = end + 1;
  }
  std::array<bool, kFitParameters.size()> fixed{};
  for (const std::string& text : options.fixed) {
    const auto [parameter, value] = parseFixed(text, law);
    const std::string name = nameOf(law, parameter);
    if (!options.free.empty() && settings.free[index(parameter)])
      throw InputError(std::string("--fix ").append(text).append(": ").append(name).append(
          " is free too, expected one of them"));
    if (fixed[index(parameter)])
      throw InputError(std::string("--fix ").append(text).append(": ").append(name).append(
          " is fixed already, expected one value"));
    valueOf(law, settings.fixed, parameter) = value;
    settings.free[index(parameter)] = false;
    fixed[index(parameter)] = true;
  }
  for (const FitParameter parameter : {FitParameter::elastic, FitParameter::shape}) {
    if (!hasParameter(law, parameter) || settings.free[index(parameter)] || fixed[index(parameter)]) continue;
    const std::string name = nameOf(law, parameter);
    throw InputError(std::string("--free ")
                         .append(options.free)
                         .append(": ")
                         .append(name)
                         .append(" is neither free nor fixed, expected --fix ")
                         .append(name)
                         .append("=NUMBER"));
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

MatchBy matchBy(const FitOptions& options, const MeasuredCurve& curve) {
  if (options.match == "time") return MatchBy::time;
  if (options.match == "depth") return MatchBy::depth;
  return curve.depth_m.empty() ? MatchBy::time : MatchBy::depth;
}

/// `simulation`: the law is that of its triangles; null: of a whole probe.
CurveFit fitCurve(MeasuredCurve curve, ForceModel law, const FitSettings& settings,
                  const SimulatedRun* simulation, const FitOptions& options) {
  CurveFit made{std::move(curve), {}, {}};
  try {
    SimulatedFit simulated;
    if (simulation != nullptr) {
      simulated = makeSimulatedFit(law, *simulation, made.curve, matchBy(options, made.curve));
      made.curve = simulated.curve;
      const bool viscous = hasParameter(law, FitParameter::damping) &&
                           (settings.free[index(FitParameter::damping)] ||
                            valueOf(law, settings.fixed, FitParameter::damping) != 0);
      if (viscous && !simulated.rate_note.empty()) made.curve.warnings.push_back(simulated.rate_note);
    } else {
      simulated.model = makeProbeModel(law, made.curve);
    }
    made.fit = fitLaw(*simulated.model, made.curve.force_N, made.curve.weights, settings);
  } catch (const InputError& error) {
    made.problem = error.what();
  }
  return made;
}

void print(int code, const nlohmann::ordered_json& values) {
  nlohmann::ordered_json json = {{"exit_code", code}};
  json.update(values);
  std::cout << jsonText(json);
}

int fitCurves(const FitOptions& options, const std::vector<MeasuredCurve>& curves) {
  const ForceModel law = lawOf(options.law);
  const FitSettings settings = settingsOf(options, law);
  std::optional<SimulatedRun> simulation;
  if (!options.result.empty()) {
    const ResultChoice choice = parseChoice(options.result);
    tryReading(choice.file, [&] { readSimulatedRun(choice.file, choice.run); });
    simulation = readSimulatedRun(choice.file, choice.run);
  }
  std::vector<CurveFit> fits;
  for (const MeasuredCurve& curve : curves)
    fits.push_back(fitCurve(curve, law, settings, simulation ? &*simulation : nullptr, options));
  if (fits.size() == 1 && !fits.front().problem.empty())
    throw InputError(labelOf(fits.front().curve) + ": " + fits.front().problem);
  const bool good = std::all_of(fits.begin(), fits.end(),
                                [](const CurveFit& fit) { return fit.problem.empty() && fit.fit.converged; });
  const int code = good ? exit_good : exit_run_failed;
  if (options.json)
    print(code, fitJson(law, fits));
  else
    std::cout << fitText(law, fits);
  return code;
}

int rankRuns(const FitOptions& options, const std::vector<MeasuredCurve>& curves) {
  const std::optional<double> fixed_offset_N = fixedOffset_N(options);
  std::filesystem::path file = options.sweep;
  if (std::filesystem::is_directory(file)) file /= "sweep.h5";
  tryReading(file, [&] { readRanked(SweepTable(file)); });
  const SweepTable table(file);
  nlohmann::ordered_json rankings = nlohmann::ordered_json::array();
  int code = exit_good;
  for (const MeasuredCurve& curve : curves) {
    try {
      const SweepRanking ranking = rankSweep(table, curve, matchBy(options, curve), fixed_offset_N);
      if (options.json)
        rankings.push_back(rankingJson(table, ranking));
      else
        std::cout << rankingText(table, ranking, options.best);
    } catch (const InputError& error) {
      if (curves.size() == 1) throw InputError(labelOf(curve) + ": " + error.what());
      code = exit_run_failed;
      if (options.json)
        rankings.push_back({{"curve", curve.name}, {"file", fileJson(curve)}, {"problem", error.what()}});
      else
        std::cout << labelOf(curve) << ": not ranked: " << error.what() << "\n";
    }
  }
  if (options.json) print(code, {{"sweep", file.string()}, {"curves", rankings}});
  return code;
}

/// Scenarios and sweeps can be named beside --modulus alone. `expected`: "a result"; `type`: what makes one.
void refuseYaml(const std::string& option, const std::string& file, const std::string& expected) {
  if (!isToSimulate(file)) return;
  const std::string what = isSweepFile(file) ? "sweep" : "scenario";
  throw InputError(fmt::format("{0}{1}: a {2}, expected {3}; type: fissure {4} {1}", option, file, what,
                               expected, what == "sweep" ? "sweep" : "run"));
}

int fit(const FitOptions& options) {
  for (const std::string& file : options.files) refuseYaml("", file, "a table of measured points");
  refuseYaml("--result ", options.result, "the result of one");
  refuseYaml("--sweep ", options.sweep, "the folder of a sweep that has run");
  if (!options.match.empty() && options.result.empty() && options.sweep.empty())
    throw InputError("--match " + options.match + ": nothing is simulated, expected --result or --sweep too");
  const std::vector<MeasuredCurve> curves = readAll(options);
  if (!options.modulus.empty())
    return fitModuli(
        {options.modulus, options.output, options.free, options.fixed, options.most_depth_m, options.json},
        curves);
  return options.sweep.empty() ? fitCurves(options, curves) : rankRuns(options, curves);
}

}  // namespace

Verb addFit(Command app, const std::string& command_line) {
  const auto options = std::make_shared<FitOptions>();
  options->output.command_line = command_line;
  Command command = app.command("fit", "force laws fitted to measured curves, and sweeps ranked by them");
  command.example("fissure fit measured.csv --law hunt_crossley --fix lambda=0");
  command.option("CURVE", options->files, "tables (CSV, TSV) of measured points, one line a point")
      .required()
      .notEmpty();
  command.option(
      "--columns", options->columns,
      "what the columns are: "
      "depth=d:mm,force=3:N,time=t_ms,sigma=s_N,weight=w,curve=probe,lower_quartile=q1, "
      "upper_quartile=q3; by name or "
      "number, units m, mm, N, mN, s, ms or a factor (default: by their names, as depth_mm, force_N, "
      "time_s)");
  const Option law = command.option("--law", options->law, lawChoices()).showDefault();
  const Option free = command.option(
      "--free", options->free,
      "what is fitted, as k,n,F0 (default: all of the law's coefficients and F0 that are not fixed); F0 "
      "and the damping are 0 else; with --modulus of E, F0 and d0 (default: E,F0)");
  command.option("--fix", options->fixed, "COEFFICIENT=NUMBER: not fitted; may be repeated").repeated();
  const Option result = command.option(
      "--result", options->result,
      "RESULT[:RUN]: the law summed over the triangles of this simulation (record: {force_inputs: true})");
  const Option sweep = command
                           .option("--sweep", options->sweep,
                                   "DIR: fit nothing, rank its runs by their misfit; F0 is free unless fixed")
                           .without(result)
                           .without(law)
                           .without(free);
  const Option modulus =
      command
          .option(
              "--modulus", options->modulus,
              "RESULT[:RUN]: Young's modulus E of an elastic body, whose force f(d) this slow press "
              "simulated at E0, as F = E/E0 f(d + d0) + F0; repeated, results are ranked by their misfit; "
              "scenarios and sweeps (.yaml) are simulated first, unless --out has them finished")
          .repeated()
          .without(law)
          .without(result)
          .without(sweep);
  command
      .option("--most-depth", options->most_depth_m,
              "with --modulus: deeper points (m) are not fitted but predicted, beside what was measured")
      .between(1e-6, 10.0)
      .needs(modulus);
  command.option("--out", options->output.folder, "with --modulus: folder for what is simulated for it")
      .notEmpty()
      .showDefault()
      .needs(modulus);
  command
      .option("--match", options->match,
              "what a curve and a simulation have in common: depth (way of the tool since first "
              "contact, until it is "
              "deepest) or time (default: depth, where the curve has depths)")
      .oneOf({"depth", "time"})
      .without(modulus);
  command.option("--best", options->best, "how many runs of a sweep are shown").showDefault().needs(sweep);
  command.flag("--together", options->together, "one law for the points of all curves");
  command.flag("--json", options->json, "the fits for machines");
  return {command, [options] { return fit(*options); }};
}

}  // namespace fissure
