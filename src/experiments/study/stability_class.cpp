#include "study/stability_class.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/stability_signal.h"

namespace fissure {

namespace {

constexpr std::size_t fewest_rows_at_rest = 24;

std::optional<double> numberIn(const Summary& summary, const std::string& name) {
  for (const SummaryValue& value : summary) {
    if (value.name != name) continue;
    if (const auto* real = std::get_if<double>(&value.value)) return *real;
    if (const auto* count = std::get_if<long long>(&value.value)) return static_cast<double>(*count);
  }
  return std::nullopt;
}

std::string textIn(const Summary& summary, const std::string& name) {
  for (const SummaryValue& value : summary)
    if (const auto* text = std::get_if<std::string>(&value.value); text && value.name == name) return *text;
  return {};
}

const CellCurve* find(const CellRun& run, const std::string& name) {
  for (const CellCurve& curve : run.curves)
    if (curve.name == name) return &curve;
  return nullptr;
}

/// A series that the pipeline does not know, but for the initial state, in which a force is known to be 0.
bool isUnknown(const CellCurve& curve) {
  return std::all_of(curve.values.begin() + !curve.values.empty(), curve.values.end(),
                     [](double value) { return std::isnan(value); });
}

/// The rows in which the tool is at rest, the second half of the run where these are few.
std::span<const double> atRest(const CellRun& run, const CellCurve& curve) {
  const std::span<const double> all(curve.values);
  const bool enough = run.rest_from + fewest_rows_at_rest <= all.size();
  return all.subspan(enough ? run.rest_from : all.size() / 2);
}

double peakOf(std::span<const double> values) {
  double most = 0;
  for (const double value : values)
    if (!std::isnan(value)) most = std::max(most, std::abs(value));
  return most;
}

std::string detailOf(const RunStatus& status) {
  return nameOf(status.end) + (status.detail.empty() ? "" : ": " + status.detail);
}

using Found = std::optional<CellClass>;

Found crashed(const CellRun& run) {
  switch (run.status.end) {
    case RunEnd::ok:
    case RunEnd::non_finite:
    case RunEnd::timeout:
      return std::nullopt;
    default:
      return CellClass{StabilityClass::crashed, detailOf(run.status)};
  }
}

Found tooSlow(const CellRun& run) {
  if (run.status.end != RunEnd::timeout) return std::nullopt;
  return CellClass{StabilityClass::too_slow, detailOf(run.status)};
}

/// The first value that is no number where there should be one; a series without any is one that the pipeline
/// does not know.
Found nonFiniteValue(const CellRun& run) {
  std::optional<std::size_t> first;
  std::string name;
  for (const CellCurve& curve : run.curves) {
    if (isUnknown(curve)) continue;
    const auto bad = std::find_if(curve.values.begin(), curve.values.end(),
                                  [](double value) { return !std::isfinite(value); });
    const auto row = static_cast<std::size_t>(bad - curve.values.begin());
    if (bad == curve.values.end() || (first && *first <= row)) continue;
    first = row;
    name = curve.name;
  }
  if (!first) return std::nullopt;
  return CellClass{StabilityClass::non_finite, fmt::format("{} at step {}", name, *first)};
}

Found nonFinite(const CellRun& run, bool with_tool) {
  if (run.status.end == RunEnd::non_finite) {
    const std::string detail = run.status.detail.empty() ? "the state" : run.status.detail;
    return CellClass{StabilityClass::non_finite, detail};
  }
  for (const char* needed : {"kinetic_energy", "penetration_depth"}) {
    if (!with_tool && needed == std::string("penetration_depth")) continue;
    const CellCurve* curve = find(run, needed);
    if (!curve || isUnknown(*curve))
      return CellClass{StabilityClass::non_finite, fmt::format("{} has no value in any step", needed)};
  }
  if (Found found = nonFiniteValue(run)) return found;
  for (const SummaryValue& value : run.summary)
    if (value.name.starts_with("force_non_finite_at_step"))
      return CellClass{StabilityClass::non_finite,
                       fmt::format("{} {:g}", value.name, numberIn(run.summary, value.name).value_or(-1))};
  return std::nullopt;
}

/// -1 where no tool has met tissue.
long long firstContact(const CellRun& run) {
  const CellCurve* contacts = find(run, "contact_count");
  if (!contacts) return -1;
  const auto met =
      std::find_if(contacts->values.begin(), contacts->values.end(), [](double n) { return n > 0; });
  return met == contacts->values.end() ? -1 : met - contacts->values.begin();
}

Found unsoundAlone(const CellRun& run) {
  if (!run.alone.empty()) return CellClass{StabilityClass::unsound_alone, "without the tool: " + run.alone};
  const std::optional<double> step = numberIn(run.summary, "first_unsound_step");
  const long long contact = firstContact(run);
  if (!step || (contact >= 0 && *step >= static_cast<double>(contact))) return std::nullopt;
  return CellClass{StabilityClass::unsound_alone, fmt::format("before the first contact, at step {:g}: {}",
                                                              *step, textIn(run.summary, "unsound_tissue"))};
}

Found passedThrough(const CellRun& run) {
  const double samples = numberIn(run.summary, "passed_through_samples").value_or(0);
  if (!(samples > 0)) return std::nullopt;
  return CellClass{StabilityClass::passed_through, fmt::format("{:g} samples of the tool", samples)};
}

Found penetrating(const CellRun& run, const StabilityCriteria& criteria) {
  const auto found = [](const std::string& reason) { return CellClass{StabilityClass::penetrating, reason}; };
  const double depth_m = std::max(peakOf(find(run, "penetration_depth")->values),
                                  numberIn(run.summary, "max_inversion_aware_depth_m").value_or(0));
  // A thickness that is no number lets no depth pass.
  const double most_m = std::min(criteria.depth_of_thickness * run.thickness_m, criteria.depth_m);
  if (!(depth_m <= most_m))
    return found(fmt::format("{:.3g} mm deep, expected at most {:.3g} mm", 1000 * depth_m, 1000 * most_m));
  if (numberIn(run.summary, "unsound_steps").value_or(0) > 0)
    return found("tissue after the first contact: " + textIn(run.summary, "unsound_tissue"));
  const double unproved = numberIn(run.summary, "uncertified_steps").value_or(0);
  if (!criteria.proved || !(unproved > 0)) return std::nullopt;
  return found(fmt::format("{:g} steps not proved: {}", unproved, textIn(run.summary, "first_uncertified")));
}

Found energyGrowing(const CellRun& run, const StabilityCriteria& criteria) {
  const CellCurve& energy = *find(run, "kinetic_energy");
  const std::span<const double> rest = atRest(run, energy);
  const double peak_J = peakOf(std::span(energy.values).first(energy.values.size() - rest.size()));
  const std::optional<double> growth = growthOf(rest, peak_J);
  if (!growth || !(*growth >= criteria.energy_growth)) return std::nullopt;
  return CellClass{StabilityClass::energy_growing,
                   fmt::format("kinetic energy grows {:.3g} times while the tool rests, to {:.3g} J", *growth,
                               rest.back())};
}

std::vector<const CellCurve*> judgedForces(const CellRun& run, const StabilityCriteria& criteria) {
  const auto isNamed = [&](const std::string& name) {
    return std::find(criteria.forces.begin(), criteria.forces.end(), name) != criteria.forces.end();
  };
  bool has_law = false;
  for (const CellCurve& curve : run.curves)
    has_law |= curve.is_force && curve.name != "reaction" && !curve.name.starts_with("coupling");
  std::vector<const CellCurve*> judged;
  for (const CellCurve& curve : run.curves) {
    if (!curve.is_force || isUnknown(curve)) continue;
    const bool by_default = curve.name != "reaction" || !has_law;
    if (criteria.forces.empty() ? by_default : isNamed(curve.name)) judged.push_back(&curve);
  }
  return judged;
}

Found chattering(const CellRun& run, const StabilityCriteria& criteria) {
  for (const CellCurve* force : judgedForces(run, criteria)) {
    const std::optional<Chatter> chatter = chatterOf(atRest(run, *force), run.step_s, peakOf(force->values),
                                                     criteria.chatter_share, criteria.chatter_crossings);
    if (chatter)
      return CellClass{StabilityClass::chattering,
                       fmt::format("{} by {:.3g} of its mean at {:.4g} Hz", force->name, chatter->share,
                                   chatter->frequency_Hz),
                       chatter->frequency_Hz};
  }
  return std::nullopt;
}

/// A tool that is thrown off and comes back strikes too seldom to cross a mean often.
Found bouncing(const CellRun& run, const StabilityCriteria& criteria) {
  for (const CellCurve* force : judgedForces(run, criteria)) {
    if (force->name.starts_with("coupling")) continue;
    const std::optional<double> rate_Hz = bounceRate_Hz(
        atRest(run, *force), run.step_s, peakOf(force->values), (criteria.chatter_crossings + 1) / 2);
    if (rate_Hz)
      return CellClass{StabilityClass::chattering,
                       fmt::format("{} is lost and comes back at {:.4g} Hz", force->name, *rate_Hz),
                       *rate_Hz};
  }
  return std::nullopt;
}

Found forceOutOfRange(const CellRun& run, const StabilityCriteria& criteria) {
  const auto found = [](const std::string& reason) {
    return CellClass{StabilityClass::force_out_of_range, reason};
  };
  for (const CellCurve* force : judgedForces(run, criteria))
    if (const double most_N = peakOf(force->values); most_N > criteria.force_N)
      return found(
          fmt::format("{} up to {:.3g} N, expected at most {:.3g} N", force->name, most_N, criteria.force_N));
  if (const double steps = numberIn(run.summary, "saturated_steps").value_or(0); steps > 0)
    return found(fmt::format("{:g} steps beyond the device's limit", steps));
  const CellCurve* capped = find(run, "capped_count");
  if (!capped || peakOf(capped->values) == 0) return std::nullopt;
  return found(fmt::format("up to {:g} contacts clamped at the largest displacement of a step",
                           peakOf(capped->values)));
}

Found untouched(const CellRun& run) {
  const std::optional<double> steps = numberIn(run.summary, "contact_steps");
  if (steps && *steps > 0) return std::nullopt;
  return CellClass{StabilityClass::untouched, "no tool met tissue, which proves nothing"};
}

CellClass stable(const CellRun& run) {
  return {StabilityClass::stable,
          fmt::format("{:.3g} mm deep at most", 1000 * peakOf(find(run, "penetration_depth")->values))};
}

}  // namespace

const std::vector<CatalogEntry>& stabilityClasses() {
  static const std::vector<CatalogEntry> table = {
      {"refused", "it is refused before it runs, in one line"},
      {"crashed", "its worker ended by a signal or an error"},
      {"too_slow", "it was stopped at its time limit"},
      {"non_finite", "a quantity is no finite number, or one that must be there is missing"},
      {"unsound_alone", "its tissue is unsound before the first contact, or without the tool"},
      {"passed_through", "samples of the tool went right through a body"},
      {"penetrating",
       "the tool is too deep, tissue is unsound after the first contact, or steps are not proved"},
      {"energy_growing", "kinetic energy grows while the tool rests"},
      {"chattering", "a force oscillates, and does not die away, while the tool rests"},
      {"force_out_of_range", "a force is too large, or was clamped"},
      {"untouched", "no tool met tissue"},
      {"stable", "none of these"},
  };
  return table;
}

CellClass classify(const CellRun& run, const StabilityCriteria& criteria) {
  if (!run.refused.empty()) return {StabilityClass::refused, run.refused};
  Found found = crashed(run);
  if (!found) found = tooSlow(run);
  if (!found) {
    found = nonFinite(run, true);
    if (found && !run.alone.empty()) found->reason += "; without the tool: " + run.alone;
  }
  if (!found) found = unsoundAlone(run);
  if (!found) found = passedThrough(run);
  if (!found) found = penetrating(run, criteria);
  if (!found) found = energyGrowing(run, criteria);
  if (!found) found = chattering(run, criteria);
  if (!found) found = bouncing(run, criteria);
  if (!found) found = forceOutOfRange(run, criteria);
  if (!found) found = untouched(run);
  return found ? *found : stable(run);
}

std::string problemAlone(const CellRun& run, const StabilityCriteria& criteria) {
  Found found = crashed(run);
  if (!found) found = tooSlow(run);
  if (!found) found = nonFinite(run, false);
  if (found) return found->reason;
  if (numberIn(run.summary, "unsound_steps").value_or(0) > 0) return textIn(run.summary, "unsound_tissue");
  found = energyGrowing(run, criteria);
  return found ? found->reason : std::string();
}

}  // namespace fissure
