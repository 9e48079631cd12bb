// What `compare` prints.
#include <fmt/core.h>

#include <cmath>

#include "base/counted.h"
#include "main/comparison.h"
#include "main/text_table.h"
#include "text/units.h"

namespace fissure {

namespace {

std::string verdict(const QuantityComparison& made) {
  if (made.equal()) return "equal";
  if (made.tolerance.ignore && made.agrees) return "ignored";
  return made.agrees ? "within" : "DIFFERS";
}

std::string relative(const Difference& difference) {
  const double ratio = difference.largest / difference.largest_b;
  if (!std::isfinite(ratio) || !difference.worst) return "-";
  return ratio < 10 ? fmt::format("{:.3g} %", 100 * ratio) : fmt::format("{:.0f} x", ratio);
}

std::string shiftText(const QuantityComparison& made) {
  if (!made.shift || made.shift->rows == 0 || !(made.shift->remaining < 0.5 * made.difference.largest))
    return "-";
  const char* const when = made.shift->rows > 0 ? " late: " : " early: ";
  return withUnit(std::abs(made.shift_s), "s") + when + withUnit(made.shift->remaining, made.units);
}

/// Since when the runs differ, by more than they may.
std::string firstAt(const QuantityComparison& made) {
  const bool tolerated = made.tolerance.absolute > 0 || made.tolerance.relative > 0;
  const std::string& at = tolerated ? made.beyond_at : made.first_at;
  return at.empty() ? "-" : at;
}

TextRow numbersRow(const QuantityComparison& made) {
  const Difference& difference = made.difference;
  return {made.quantity,
          verdict(made),
          withUnit(made.scalar_a.value_or(difference.largest_a), made.units),
          withUnit(made.scalar_b.value_or(difference.largest_b), made.units),
          made.equal() || difference.worst ? withUnit(difference.largest, made.units) : "-",
          relative(difference),
          made.worst_at.empty() ? "-" : made.worst_at,
          firstAt(made),
          shiftText(made)};
}

std::string title(const char* side, const RunOfFile& run) {
  const PipelineResult& result = *run.run;
  return fmt::format("{}  {}:{}  {}, {}, {}{}\n", side, run.file.string(), result.name, result.precision,
                     nameOf(result.status.end), result.description,
                     run.info->reference ? " (a reference)" : "");
}

/// One line for all quantities that only one side has.
std::string onlyIn(const RunComparison& run, const char* side, const std::string& problem) {
  std::string names;
  for (const QuantityComparison& made : run.quantities)
    if (made.problem == problem && !made.agrees) names += (names.empty() ? " " : ", ") + made.quantity;
  return names.empty() ? "" : fmt::format("only in {}:{}\n", side, names);
}

bool isOneSided(const QuantityComparison& made) {
  return made.problem == "missing in A" || made.problem == "missing in B";
}

std::string problemLines(const RunComparison& run) {
  std::string text;
  for (const std::string& problem : run.problems) text += "DIFFERS: " + problem + "\n";
  for (const QuantityComparison& made : run.quantities) {
    if (made.agrees || isOneSided(made)) continue;
    if (!made.problem.empty()) text += fmt::format("{} DIFFERS: {}\n", made.quantity, made.problem);
    if (made.text_a != made.text_b)
      text += fmt::format("{} DIFFERS: {} against {}\n", made.quantity, made.text_a, made.text_b);
  }
  return text + onlyIn(run, "A", "missing in B") + onlyIn(run, "B", "missing in A");
}

std::string countLine(const RunComparison& run) {
  std::size_t differing = 0, within = 0, equal = 0;
  for (const QuantityComparison& made : run.quantities)
    ++(!made.agrees ? differing : made.equal() ? equal : within);
  std::string text = counted(differing, "quantity differs, ", "quantities differ, ");
  if (within > 0) text += fmt::format("{} are within their tolerance, ", within);
  const RunEnd end = run.a.run->status.end;
  return fmt::format("{}{} are equal{}\n", text, equal, end == RunEnd::ok ? "" : " (" + nameOf(end) + ")");
}

std::string runText(const RunComparison& run, bool all) {
  if (run.agrees() && !all) return run.a.run->name + ": " + countLine(run);
  std::vector<TextRow> rows = {{"quantity", "", "largest", "largest", "largest", "of B",
                                "largest difference at", "first difference at", "A in time"},
                               {"", "", "in A", "in B", "difference", "", "", "", ""}};
  for (const QuantityComparison& made : run.quantities) {
    const bool numbers = made.scalar_a || made.difference.rows > 0;
    if (numbers && (all || !made.agrees)) rows.push_back(numbersRow(made));
  }
  return title("A", run.a) + title("B", run.b) + (rows.size() > 2 ? alignedText(rows, 2) : "") +
         problemLines(run) + countLine(run) + "\n";
}

constexpr const char* legend =
    "largest: of absolute values over all steps and components; of B: the difference over the largest in B; "
    "A in time: the "
    "shift of A\nthat fits B best, where it takes away more than half of the difference, and what is left "
    "then. Timing "
    "and provenance are left out.\n";

}  // namespace

std::string comparisonText(const ResultComparison& comparison, bool all) {
  std::string text;
  for (const RunComparison& run : comparison.runs) text += runText(run, all);
  for (const std::string& problem : comparison.problems) text += "DIFFERS: " + problem + "\n";
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  if (!comparison.agrees() || all) text += legend;
  return text + (comparison.agrees() ? "A agrees with B\n" : "A differs from B\n");
}

}  // namespace fissure
