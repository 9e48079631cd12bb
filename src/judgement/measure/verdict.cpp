#include "measure/verdict.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "measure/node_spacing.h"

namespace fissure {

namespace {

std::optional<double> numberIn(const Summary& summary, const char* name) {
  for (const SummaryValue& value : summary) {
    if (value.name != name) continue;
    if (const double* real = std::get_if<double>(&value.value)) return *real;
    if (const long long* count = std::get_if<long long>(&value.value)) return static_cast<double>(*count);
  }
  return std::nullopt;
}

std::string textIn(const Summary& summary, const char* name) {
  for (const SummaryValue& value : summary)
    if (value.name == name && std::holds_alternative<std::string>(value.value))
      return std::get<std::string>(value.value);
  return "";
}

/// The depth with inverted tissue, where the result has it: an older one has the plain depth alone.
std::optional<double> worstDepth_m(const Summary& summary) {
  const auto aware_m = numberIn(summary, "max_inversion_aware_depth_m");
  return aware_m ? aware_m : numberIn(summary, "max_penetration_depth_m");
}

void add(VerdictGrade grade, const std::string& text, Verdict& verdict) {
  verdict.grade = std::max(verdict.grade, grade);
  verdict.text.append(verdict.text.empty() ? "" : ", ").append(text);
}

}  // namespace

Verdict verdictOf(const Summary& summary) {
  const auto depth_m = worstDepth_m(summary);
  const auto above = [&](const char* name, double limit) {
    return numberIn(summary, name).value_or(0) > limit;
  };
  const bool passed = above("passed_through_samples", 0), inverted = above("max_inverted_triangles", 0),
             unsound = above("unsound_steps", 0);
  Verdict verdict;
  if (!depth_m)
    add(VerdictGrade::held, "-", verdict);
  else if (std::isnan(*depth_m))
    add(VerdictGrade::failed, "depth unknown", verdict);
  else if (*depth_m > kHeldDepth_m)
    add(VerdictGrade::failed, fmt::format("{:.2f} mm inside", 1e3 * *depth_m), verdict);
  else if (numberIn(summary, "contact_steps").value_or(1) == 0)
    add(VerdictGrade::doubtful, "never touched tissue", verdict);
  else if (numberIn(summary, "contacts_total").value_or(1) == 0)
    add(VerdictGrade::doubtful, "beside tissue, no contact", verdict);
  else if (!passed && !inverted && !unsound)
    add(VerdictGrade::held, *depth_m > 0 ? fmt::format("held to {:.2f} mm", 1e3 * *depth_m) : "held",
        verdict);
  if (passed) add(VerdictGrade::failed, "passed through", verdict);
  if (inverted) add(VerdictGrade::failed, "inverted", verdict);
  if (unsound) add(VerdictGrade::failed, "unsound tissue", verdict);
  if (const std::string tools = textIn(summary, "untouched_tools");
      !tools.empty() && numberIn(summary, "contact_steps").value_or(0) > 0)
    add(VerdictGrade::doubtful, tools + " never touched tissue", verdict);
  const auto steps = numberIn(summary, "uncertified_steps");
  if (steps.value_or(0) > 0 && verdict.grade != VerdictGrade::failed)
    add(VerdictGrade::doubtful, fmt::format("{:.0f} steps not proved", *steps), verdict);
  const bool in_each_step = numberIn(summary, "steps_per_measurement").value_or(1) == 1;
  if (steps && *steps == 0 && in_each_step && depth_m && verdict.grade == VerdictGrade::held)
    add(VerdictGrade::held, "proved", verdict);
  if (const double ground_m = numberIn(summary, "max_ground_depth_m").value_or(0); ground_m > kHeldDepth_m)
    add(VerdictGrade::doubtful, fmt::format("{:.2f} mm below ground", 1e3 * ground_m), verdict);
  return verdict;
}

std::vector<Remark> remarksOf(const Summary& summary) {
  std::vector<Remark> remarks;
  if (const std::string problem = textIn(summary, "unsound_tissue"); !problem.empty())
    remarks.push_back({true, fmt::format("unsound tissue, first in step {:.0f}: {}",
                                         numberIn(summary, "first_unsound_step").value_or(0), problem)});
  if (const std::string what = textIn(summary, "first_uncertified"); !what.empty())
    remarks.push_back({false, fmt::format("overlap is not excluded, first in step {:.0f}: {}",
                                          numberIn(summary, "first_uncertified_step").value_or(0), what)});
  if (const std::string what = textIn(summary, "not_measured"); !what.empty())
    remarks.push_back({false, "not measured: " + what});
  if (const double every = numberIn(summary, "steps_per_measurement").value_or(1); every > 1)
    remarks.push_back({true, fmt::format("depth and proof of one step in {:.0f} only "
                                         "(measure.every): what came in between was not seen",
                                         every)});
  if (const std::string tools = textIn(summary, "untouched_tools"); !tools.empty())
    remarks.push_back({true, "never touched tissue: " + tools});
  const double coverage_m = numberIn(summary, "sample_coverage_m").value_or(0);
  const bool proved =
      numberIn(summary, "uncertified_steps").value_or(1) == 0;  // nothing hides between samples
  if (const auto depth_m = worstDepth_m(summary); !proved && depth_m && coverage_m > *depth_m)
    remarks.push_back(
        {coverage_m > 2 * kHeldDepth_m,
         fmt::format("samples see depths to within {:.2f} mm: that much more may hide between them "
                     "(measure.sample_spacing_m)",
                     1e3 * coverage_m)});
  if (const double ratio = numberIn(summary, "node_spacing_over_edge").value_or(0); ratio > kWideNodes)
    remarks.push_back({true, wideNodesText(numberIn(summary, "node_spacing_m").value_or(0), ratio)});
  if (const double steps = numberIn(summary, "oblique_steps").value_or(0); steps > 0)
    remarks.push_back(
        {true, fmt::format("narrow_rows: in {:.0f} steps a blade moves obliquely to its faces, where "
                           "nodes on narrow ones tear tissue (compare with narrow_rows: 0)",
                           steps)});
  if (const double steps = numberIn(summary, "truncated_steps").value_or(0); steps > 0)
    remarks.push_back({false, fmt::format("in {:.0f} steps tissue that contacts did not hold was "
                                          "stopped on its way ({:.0f} vertices)",
                                          steps, numberIn(summary, "truncated_vertices").value_or(0))});
  if (const double steps = numberIn(summary, "no_room_steps").value_or(0); steps > 0)
    remarks.push_back(
        {true,
         fmt::format("after {:.0f} steps there was no room for tissue, which may overlap a tool", steps)});
  if (const double steps = numberIn(summary, "freeing_steps").value_or(0); steps > 0)
    remarks.push_back(
        {true, fmt::format("in {:.0f} steps a tool that stood in tissue was on its way out", steps)});
  if (const std::string laws = textIn(summary, "laws_of_whole_probes"); !laws.empty())
    remarks.push_back(
        {true, fmt::format("force of {}: fitted to a whole probe, here summed over triangles; its exponent "
                           "is the tissue's, its newtons are not",
                           laws)});
  return remarks;
}

std::string reactionNote(const Summary& summary) {
  if (!(numberIn(summary, "max_reaction_N").value_or(0) > 0)) return "";
  if (numberIn(summary, "max_substeps")) return "";  // of an elastic body: newtons
  return "reaction: of a shell of springs, which stiffens as 1/dt^2 (one press: 30 N at 2 ms, 7500 N at "
         "0.125 ms): "
         "no force to feel, compare it at one step and mesh";
}

std::string endText(RunEnd end) {
  return end == RunEnd::ok ? "finished" : nameOf(end);
}

}  // namespace fissure
