#include "compare/compare_runs.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "base/steps.h"
#include "store/reference_file.h"
#include "store/run_reader.h"
#include "text/scalars.h"
#include "text/summary_unit.h"
#include "text/units.h"

namespace fissure {

namespace {

constexpr std::size_t kBlockValues = std::size_t{1} << 22;  // 32 MiB a side
constexpr std::size_t kShiftValues = std::size_t{1} << 24;  // larger series are not looked through for shifts

std::string names(const StoredAxis& axis) {
  std::string text;
  for (const std::string& label : axis.labels) text += (text.empty() ? "" : " ") + label;
  return axis.labels.empty() ? std::to_string(axis.length) + " long" : text;
}

/// What keeps values of two quantities from being compared one by one; empty: nothing.
std::string axesProblem(const StoredQuantity& a, const StoredQuantity& b) {
  if (a.row_axis != b.row_axis || a.axes.size() != b.axes.size()) return "other axes";
  for (std::size_t i = 0; i < a.axes.size(); ++i) {
    if (a.axes[i].name != b.axes[i].name)
      return fmt::format("axis {} against {}", a.axes[i].name, b.axes[i].name);
    if (a.axes[i] != b.axes[i])
      return fmt::format("axis {}: {} against {}", a.axes[i].name, names(a.axes[i]), names(b.axes[i]));
  }
  return "";
}

/// "hc, y" for a place in a row.
std::string columnName(const StoredQuantity& quantity, std::size_t column) {
  std::string text;
  for (auto axis = quantity.axes.rbegin(); axis != quantity.axes.rend(); ++axis) {
    const std::size_t at = column % axis->length;
    column /= axis->length;
    if (axis->length == 1 && axis->labels.empty()) continue;
    std::string name = axis->labels.empty() ? axis->name + " " + std::to_string(at) : axis->labels[at];
    if (!text.empty()) name.append(", ").append(text);
    text = std::move(name);
  }
  return text;
}

double allowedDifference(const QuantityComparison& made) {
  return made.tolerance.absolute + made.tolerance.relative * made.difference.largest_b;
}

/// Compares the series of two runs.
class SeriesComparer {
 public:
  SeriesComparer(const RunOfFile& a, const RunOfFile& b, const CompareSettings& settings)
      : settings_(settings),
        pipeline_(b.run->name),
        b_is_reference_(b.info->reference),
        a_(a.file, a.run->name),
        b_(b.file, b.run->name) {}

  void compareAll(std::vector<QuantityComparison>& found) {
    for (const StoredQuantity& quantity : a_.quantities()) {
      if (b_is_reference_ && !inReference(quantity)) continue;
      found.push_back(compare(quantity, b_.find(quantity.name)));
    }
    for (const StoredQuantity& quantity : b_.quantities())
      if (!a_.find(quantity.name)) found.push_back(missing(quantity, "missing in A"));
  }

 private:
  QuantityComparison begin(const StoredQuantity& quantity) const {
    QuantityComparison made;
    made.quantity = quantity.name;
    made.units = quantity.units;
    made.tolerance = settings_.tolerances.of(quantity.name, pipeline_);
    return made;
  }
  QuantityComparison missing(const StoredQuantity& quantity, const std::string& problem) const {
    QuantityComparison made = begin(quantity);
    made.problem = problem;
    return made;
  }
  QuantityComparison compare(const StoredQuantity& a, const StoredQuantity* b);
  void compareValues(const StoredQuantity& a, const StoredQuantity& b, QuantityComparison& made);
  void lookForShift(const StoredQuantity& a, const StoredQuantity& b, QuantityComparison& made);
  const std::vector<std::size_t>& partners(const std::string& row_axis, std::string& problem);
  const std::vector<double>& times_s(const RunReader& reader, const std::string& row_axis);
  std::vector<double> rowsOfA(const StoredQuantity& a, std::span<const std::size_t> partners) const;
  std::string placeName(const StoredQuantity& b, const ValueIndex& place);
  std::string rowName(const StoredQuantity& b, std::size_t row);

  const CompareSettings& settings_;
  std::string pipeline_;
  bool b_is_reference_;
  RunReader a_, b_;
  std::map<std::pair<const RunReader*, std::string>, std::vector<double>> times_s_;
  std::map<std::string, std::vector<std::size_t>> partners_;
};

const std::vector<double>& SeriesComparer::times_s(const RunReader& reader, const std::string& row_axis) {
  const auto [at, fresh] = times_s_.try_emplace({&reader, row_axis});
  if (const StoredQuantity* times = fresh ? reader.find(row_axis) : nullptr) at->second = reader.all(*times);
  return at->second;
}

/// For each row of B the row of A that it is compared with, as far as there is one: the same row, or that of
/// the same time where B is a reference.
const std::vector<std::size_t>& SeriesComparer::partners(const std::string& row_axis, std::string& problem) {
  const std::vector<double>& of_a = times_s(a_, row_axis);
  const std::vector<double>& of_b = times_s(b_, row_axis);
  const auto [at, fresh] = partners_.try_emplace(row_axis);
  std::vector<std::size_t>& rows = at->second;
  if (!b_is_reference_) {
    if (of_a.size() != of_b.size())
      problem = fmt::format("{} rows over {} against {}", of_a.size(), row_axis, of_b.size());
    if (fresh) {
      rows.resize(std::min(of_a.size(), of_b.size()));
      std::iota(rows.begin(), rows.end(), std::size_t{0});
    }
    return rows;
  }
  if (fresh) {
    for (const double time_s : of_b) {
      const auto found = std::lower_bound(of_a.begin(), of_a.end(), time_s);
      if (found == of_a.end() || *found != time_s) break;
      rows.push_back(static_cast<std::size_t>(found - of_a.begin()));
    }
  }
  if (rows.size() < of_b.size())
    problem = fmt::format("no row at {} s, where the reference has one", formatReal(of_b[rows.size()]));
  else if (!of_a.empty() && (of_b.empty() || of_b.back() != of_a.back()))
    problem = fmt::format("goes on to {} s, the reference does not", formatReal(of_a.back()));
  return rows;
}

std::vector<double> SeriesComparer::rowsOfA(const StoredQuantity& a,
                                            std::span<const std::size_t> partners) const {
  const std::size_t columns = a.columns();
  std::vector<double> range = a_.rows(a, partners.front(), partners.back() - partners.front() + 1);
  if (range.size() == partners.size() * columns) return range;
  std::vector<double> picked;
  picked.reserve(partners.size() * columns);
  for (const std::size_t row : partners) {
    const auto from = range.begin() + static_cast<std::ptrdiff_t>((row - partners.front()) * columns);
    picked.insert(picked.end(), from, from + static_cast<std::ptrdiff_t>(columns));
  }
  return picked;
}

std::string SeriesComparer::rowName(const StoredQuantity& b, std::size_t row) {
  if (b.row_axis.empty()) return "";
  const std::vector<double>& times = times_s(b_, b.row_axis);
  const std::size_t of_a = partners_[b.row_axis][row];
  const std::string kind = b.row_axis == "time" ? "step" : b.row_axis.substr(0, b.row_axis.find('_'));
  return row < times.size() ? fmt::format("{} {} ({})", kind, of_a, withUnit(times[row], "s"))
                            : fmt::format("{} {}", kind, of_a);
}

std::string SeriesComparer::placeName(const StoredQuantity& b, const ValueIndex& place) {
  const std::string row = rowName(b, place.row);
  const std::string column = columnName(b, place.column);
  return row + (row.empty() || column.empty() ? "" : ", ") + column;
}

void SeriesComparer::lookForShift(const StoredQuantity& a, const StoredQuantity& b,
                                  QuantityComparison& made) {
  if (a.row_axis.empty() || a.name == a.row_axis || made.difference.worst == std::nullopt) return;
  const std::vector<double>& times = times_s(a_, a.row_axis);
  const std::vector<std::size_t>& rows = partners_[a.row_axis];
  if (rows.size() < 3 || a.rows * a.columns() > kShiftValues) return;
  const double step_s = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  const double most_s = made.tolerance.time_shift_s > 0 ? made.tolerance.time_shift_s : settings_.max_shift_s;
  if (!(step_s > 0)) return;
  const std::vector<double> of_a = a_.all(a);
  const std::vector<double> of_b = b_.rows(b, 0, rows.size());
  made.shift =
      bestShift(of_a, of_b, rows, a.columns(), static_cast<std::size_t>(intervalsIn(most_s, step_s)));
  made.shift_s = static_cast<double>(made.shift->rows) * step_s;
}

void SeriesComparer::compareValues(const StoredQuantity& a, const StoredQuantity& b,
                                   QuantityComparison& made) {
  std::vector<std::size_t> one_row = {0};
  const std::vector<std::size_t>& rows = a.row_axis.empty() ? one_row : partners(a.row_axis, made.problem);
  DifferenceMeter meter(a.columns(), {settings_.exact, mayBeMissing(a.name)});
  const std::size_t block = std::max<std::size_t>(1, kBlockValues / std::max<std::size_t>(1, a.columns()));
  for (std::size_t first = 0; first < rows.size() && a.columns() > 0; first += block) {
    const std::size_t count = std::min(block, rows.size() - first);
    meter.add(rowsOfA(a, std::span(rows).subspan(first, count)), b_.rows(b, first, count));
  }
  made.difference = meter.result();
  if (const auto row = meter.firstRowBeyond(allowedDifference(made))) made.beyond_at = rowName(b, *row);
}

void addProblem(std::string& problems, const std::string& problem) {
  problems += (problems.empty() ? "" : "; ") + problem;
}

QuantityComparison SeriesComparer::compare(const StoredQuantity& a, const StoredQuantity* b) {
  if (!b) return missing(a, "missing in B");
  QuantityComparison made = begin(a);
  made.problem = axesProblem(a, *b);
  if (!made.problem.empty()) return made;
  compareValues(a, *b, made);
  const Difference& difference = made.difference;
  if (a.units != b->units) addProblem(made.problem, fmt::format("unit {} against {}", a.units, b->units));
  if (a.type != b->type) addProblem(made.problem, fmt::format("stored as {} against {}", a.type, b->type));
  if (difference.nan_a) addProblem(made.problem, "NaN in A at " + placeName(*b, *difference.nan_a));
  if (difference.nan_b) addProblem(made.problem, "NaN in B at " + placeName(*b, *difference.nan_b));
  if (difference.worst) made.worst_at = placeName(*b, *difference.worst);
  if (difference.first) made.first_at = placeName(*b, *difference.first);
  if (made.problem.empty()) lookForShift(a, *b, made);
  return made;
}

QuantityComparison compareScalars(const SummaryValue* a, const SummaryValue* b,
                                  const CompareSettings& settings, const std::string& pipeline) {
  QuantityComparison made;
  made.quantity = "summary/" + (a ? a : b)->name;
  made.units = summaryUnit((a ? a : b)->name);
  made.tolerance = settings.tolerances.of(made.quantity, pipeline);
  if (!a || !b) {
    made.problem = a ? "missing in B" : "missing in A";
    return made;
  }
  const auto* text_a = std::get_if<std::string>(&a->value);
  const auto* text_b = std::get_if<std::string>(&b->value);
  if (text_a || text_b) {
    made.text_a = text_a ? *text_a : "a number";
    made.text_b = text_b ? *text_b : "a number";
    return made;
  }
  const auto number = [](const SummaryValue& value) {
    const auto* count = std::get_if<long long>(&value.value);
    return count ? static_cast<double>(*count) : std::get<double>(value.value);
  };
  DifferenceMeter meter(1, {settings.exact, mayBeMissing(made.quantity)});
  made.scalar_a = number(*a);
  made.scalar_b = number(*b);
  meter.add(std::span(&*made.scalar_a, 1), std::span(&*made.scalar_b, 1));
  made.difference = meter.result();
  if (made.difference.nan_b) made.problem = "NaN in B";
  if (made.difference.nan_a) made.problem = "NaN in A";
  return made;
}

void compareSummaries(const RunOfFile& a, const RunOfFile& b, const CompareSettings& settings,
                      std::vector<QuantityComparison>& found) {
  const auto find = [](const Summary& summary, const std::string& name) -> const SummaryValue* {
    const auto at =
        std::find_if(summary.begin(), summary.end(), [&](const auto& v) { return v.name == name; });
    return at == summary.end() ? nullptr : &*at;
  };
  const auto isTiming = [](const SummaryValue& value) { return value.name.rfind("timing/", 0) == 0; };
  for (const SummaryValue& value : a.run->summary)
    if (!isTiming(value))
      found.push_back(compareScalars(&value, find(b.run->summary, value.name), settings, b.run->name));
  for (const SummaryValue& value : b.run->summary)
    if (!isTiming(value) && !find(a.run->summary, value.name))
      found.push_back(compareScalars(nullptr, &value, settings, b.run->name));
}

bool agree(const QuantityComparison& made, bool exact) {
  if (made.equal()) return true;
  if (exact) return false;
  if (made.tolerance.ignore) return true;
  if (!made.problem.empty() || made.text_a != made.text_b) return false;
  const Difference& difference = made.difference;
  const double allowed = allowedDifference(made);
  const auto within = [&](double distance) { return std::isfinite(distance) && distance <= allowed; };
  if (within(difference.largest)) return true;
  return made.tolerance.time_shift_s > 0 && made.shift && within(made.shift->remaining);
}

std::string statusText(const RunStatus& status) {
  return nameOf(status.end) + (status.detail.empty() ? "" : " (" + status.detail + ")");
}

void compareStates(const RunOfFile& a, const RunOfFile& b, std::vector<std::string>& problems) {
  const RunStatus& of_a = a.run->status;
  const RunStatus& of_b = b.run->status;
  if (of_a.end != of_b.end || of_a.detail != of_b.detail)
    problems.push_back(fmt::format("status {} against {}", statusText(of_a), statusText(of_b)));
  if (a.run->name == b.run->name && a.run->pipeline != b.run->pipeline)
    problems.push_back(fmt::format("pipeline {} against {}", a.run->pipeline, b.run->pipeline));
  if (a.run->name == b.run->name && a.run->precision != b.run->precision)
    problems.push_back(fmt::format("precision {} against {}", a.run->precision, b.run->precision));
}

}  // namespace

bool RunComparison::agrees() const {
  return problems.empty() && std::all_of(quantities.begin(), quantities.end(),
                                         [](const QuantityComparison& made) { return made.agrees; });
}

bool mayBeMissing(const std::string& quantity) {
  static const std::array<const char*, 15> patterns = {
      "reaction_force",  // not measured for Bullet's own contact
      "summary/max_reaction_N",
      "summary/reaction_roughness",
      "summary/tool_reaction_roughness",
      "tool_reaction",
      "clamp_reaction",
      "jaw_opening",                   // of hinged jaws, which have
      "jaw_angle",                     // where parallel ones have none
      "stand_off",                     // no contact
      "tools/*/node_thickness",        // no partner
      "summary/first_contact_time_s",  // no contact
      "summary/force_roughness*",      // no force
      "summary/tool_force_roughness*",
      "summary/roughness_same_triangles*",
      "summary/node_switch_rate_hz",  // no time
  };
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const char* pattern) { return fitsPattern(quantity, pattern); });
}

RunComparison compareRuns(const RunOfFile& a, const RunOfFile& b, const CompareSettings& settings) {
  RunComparison comparison{a, b, {}, {}};
  compareStates(a, b, comparison.problems);
  compareSummaries(a, b, settings, comparison.quantities);
  SeriesComparer(a, b, settings).compareAll(comparison.quantities);
  for (QuantityComparison& made : comparison.quantities) made.agrees = agree(made, settings.exact);
  return comparison;
}

}  // namespace fissure
