#include "compare/expectations.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string expectedText(const Expectation& expected) {
  std::string text;
  if (expected.value) text = formatReal(*expected.value) + " within " + formatReal(*expected.tolerance);
  if (expected.min && expected.max)
    return text + (text.empty() ? "" : " and ") + formatReal(*expected.min) + " to " +
           formatReal(*expected.max);
  if (expected.min)
    text += (text.empty() ? "" : " and ") + std::string("at least ") + formatReal(*expected.min);
  if (expected.max)
    text += (text.empty() ? "" : " and ") + std::string("at most ") + formatReal(*expected.max);
  return text;
}

// So written that NaN holds nowhere.
bool holds(const Expectation& expected, double found) {
  if (std::isnan(found)) return false;
  if (expected.value && !(std::abs(found - *expected.value) <= *expected.tolerance)) return false;
  if (expected.min && !(found >= *expected.min)) return false;
  return !expected.max || found <= *expected.max;
}

/// Whether the quantity says nothing about a run in which a tool never touched tissue.
bool needsContact(const Expectation& expected) {
  if (expected.contact || !(expected.max || expected.value)) return false;
  static const std::array<const char*, 6> quantities = {
      "max_penetration_depth_m", "final_penetration_depth_m", "max_inversion_aware_depth_m",
      "passed_through_samples",  "max_inverted_triangles",    "uncertified_steps"};
  return std::find(quantities.begin(), quantities.end(), expected.quantity) != quantities.end();
}

/// The tools that never touched tissue, or "".
std::string untouchedTools(const Summary& summary) {
  for (const SummaryValue& value : summary)
    if (value.name == "untouched_tools") return std::get<std::string>(value.value);
  return "";
}

CheckedExpectation check(const Expectation& expected, const PipelineResult& run) {
  CheckedExpectation checked{run.name, expected.quantity, "", expectedText(expected), false};
  if (run.status.end != RunEnd::ok) {
    checked.found = "unknown, the run is " + nameOf(run.status.end);
    return checked;
  }
  std::vector<std::string> names;
  for (const SummaryValue& value : run.summary) {
    if (value.name.rfind("timing/", 0) != 0) names.push_back(value.name);
    if (value.name != expected.quantity) continue;
    if (const auto* text = std::get_if<std::string>(&value.value)) {
      checked.found = "the text " + *text;
      return checked;
    }
    const auto* count = std::get_if<long long>(&value.value);
    const double found = count ? static_cast<double>(*count) : std::get<double>(value.value);
    checked.found = formatReal(found);
    checked.holds = holds(expected, found);
    const std::string untouched = needsContact(expected) ? untouchedTools(run.summary) : "";
    if (checked.holds && !untouched.empty()) {
      checked.holds = false;
      checked.found += fmt::format(", but {} never touched tissue (contact: any lets that pass)", untouched);
    }
    return checked;
  }
  checked.found = "not in the summary" + didYouMean(expected.quantity, names);
  return checked;
}

}  // namespace

std::vector<CheckedExpectation> checkExpectations(const std::vector<Expectation>& expectations,
                                                  const std::vector<PipelineResult>& runs) {
  std::vector<CheckedExpectation> all;
  for (const Expectation& expected : expectations) {
    const std::size_t before = all.size();
    for (const PipelineResult& run : runs)
      if (!expected.pipeline || *expected.pipeline == run.name) all.push_back(check(expected, run));
    if (all.size() == before)
      all.push_back({expected.pipeline.value_or("no run"), expected.quantity, "unknown, there is no such run",
                     expectedText(expected), false});
  }
  return all;
}

std::string expectationText(const CheckedExpectation& checked) {
  return fmt::format("{}: {} is {}, expected {}", checked.run, checked.quantity, checked.found,
                     checked.expected);
}

}  // namespace fissure
