#include "sweep/sweep_merge.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <unordered_map>

#include "base/error.h"
#include "files/write_file.h"
#include "measure/statistics.h"
#include "sweep/sweep_misfit.h"
#include "table/sweep_csv.h"
#include "table/sweep_names.h"
#include "table/sweep_table_writer.h"
#include "task/run_recorder.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// What the table needs to write the rows of one task. The numbers themselves are read when a row is written,
/// as a task with many laws has many.
struct TaskRows {
  SweepState::Head head;
  std::vector<std::size_t> columns;  ///< of the table's metrics, in the task's names; their number: has none
};

class RowReader {
 public:
  RowReader(const SweepState& state, std::vector<SweepMetric> metrics)
      : state_(state), metrics_(std::move(metrics)) {}

  void fill(std::size_t task, std::size_t row, SweepRun& run) {
    const TaskRows& rows = at(task);
    const NumbersHead& numbers = rows.head.numbers;
    const std::size_t names = numbers.names.size();
    const std::vector<double> values =
        state_.numbers(task, rows.head, numbers.values_at + row * names * sizeof(double), names);
    for (std::size_t m = 0; m < metrics_.size(); ++m) {
      if (rows.columns[m] < names) {
        run.metrics[m] = values[rows.columns[m]];
        continue;
      }
      const auto timing = rows.head.record.timing.find(metrics_[m].name);
      if (timing != rows.head.record.timing.end()) run.metrics[m] = timing->second;
    }
    const std::size_t width = numbers.curve_values;
    if (width > 0)
      run.curves = state_.numbers(task, rows.head, numbers.curves_at + row * width * sizeof(double), width);
  }

 private:
  const TaskRows& at(std::size_t task) {
    constexpr std::size_t most = 4096;
    const auto found = known_.find(task);
    if (found != known_.end()) return found->second;
    if (known_.size() >= most) known_.clear();
    TaskRows rows{state_.head(task), {}};
    std::unordered_map<std::string, std::size_t> places;
    const std::vector<std::string>& names = rows.head.numbers.names;
    for (std::size_t i = 0; i < names.size(); ++i) places[names[i]] = i;
    for (const SweepMetric& metric : metrics_) {
      const auto place = places.find(metric.name);
      rows.columns.push_back(place == places.end() ? names.size() : place->second);
    }
    return known_.emplace(task, std::move(rows)).first->second;
  }

  const SweepState& state_;
  std::vector<SweepMetric> metrics_;
  std::unordered_map<std::size_t, TaskRows> known_;
};

/// All numbers that any record has, in the order in which the plan's tasks bring them, then the timings.
std::vector<SweepMetric> metricsOf(const SweepPlan& plan, const SweepState& state) {
  std::vector<SweepMetric> metrics;
  std::set<std::string> seen, timings;
  for (std::size_t task = 0; task < plan.tasks().size(); ++task) {
    if (!state.task(task).place) continue;
    const SweepState::Head head = state.head(task);
    for (const auto& [name, value] : head.record.timing) timings.insert(name);
    for (const std::string& name : head.numbers.names)
      if (seen.insert(name).second) metrics.push_back({name});
  }
  for (const std::string& name : timings) metrics.push_back({name});
  return metrics;
}

SweepTableLayout layoutOf(const SweepPlan& plan, std::vector<SweepMetric> metrics,
                          const Provenance& provenance) {
  const SweepManifest& manifest = plan.manifest();
  SweepTableLayout layout;
  layout.title = manifest.settings.name;
  layout.description = manifest.settings.description;
  layout.design = designName(manifest.settings.design);
  std::set<std::string> taken;
  for (const SweepMetric& metric : metrics) taken.insert(metric.name);
  for (const CurveQuantity& curve : manifest.curves) taken.insert(curve.name);
  const std::vector<std::string>& paths = manifest.points.paths();
  const std::vector<std::string> names = sweepAxisNames(paths, taken);
  for (std::size_t a = 0; a < paths.size(); ++a) {
    bool numeric = true;
    for (std::size_t point = 0; point < manifest.points.size() && numeric; ++point)
      numeric = toReal(manifest.points.value(point, a)).has_value();
    layout.axes.push_back({names[a], paths[a], numeric});
  }
  for (const ForceSettings& law : plan.base().scenario.force) layout.laws.push_back(law.name);
  layout.metrics = std::move(metrics);
  for (const CurveQuantity& curve : manifest.curves)
    layout.curves.push_back({curve.name, curve.units, curve.long_name, curve.per_law});
  if (manifest.settings.curves) layout.curve_time_s = curveTimes_s(*manifest.settings.curves);
  layout.runs = plan.runs();
  layout.sweep_source = manifest.settings.source;
  layout.provenance = provenance;
  return layout;
}

constexpr const char* misfit_metric = "misfit_N";
constexpr const char* offset_metric = "misfit_F0_N";

/// How far runs are from the sweep's measured curve, which is read from a copy in `work`; no value without a
/// fit.
std::optional<SweepMisfit> misfitOf(const SweepPlan& plan, const std::filesystem::path& work) {
  const SweepManifest& manifest = plan.manifest();
  if (!manifest.settings.fit) return std::nullopt;
  const std::filesystem::path copy = work / std::filesystem::path(manifest.settings.fit->curve).filename();
  writeFile(copy, manifest.measured);
  std::vector<std::string> laws;
  for (const ForceSettings& law : plan.base().scenario.force) laws.push_back(law.name);
  return SweepMisfit(*manifest.settings.fit, laws, copy);
}

void fillMisfit(const SweepMisfit& misfit, const SweepTableLayout& layout, SweepRun& run) {
  std::span<const double> force_N, way_m;
  std::size_t at = 0;
  for (const CurveQuantity& curve : layout.curves) {
    const std::span<const double> values(run.curves.data() + at, layout.width(curve));
    if (curve.name == "force") force_N = values;
    if (curve.name == "indentation") way_m = values;
    at += values.size();
  }
  const Misfit found = misfit.of(layout.curve_time_s, force_N, way_m);
  for (std::size_t m = 0; m < layout.metrics.size(); ++m) {
    if (layout.metrics[m].name == misfit_metric) run.metrics[m] = found.rms_N;
    if (layout.metrics[m].name == offset_metric) run.metrics[m] = found.F0_N;
  }
}

}  // namespace

std::filesystem::path tableFile(const std::filesystem::path& folder) {
  return folder / "sweep.h5";
}

std::filesystem::path csvFile(const std::filesystem::path& folder) {
  return folder / "sweep.csv";
}

std::map<RunEnd, std::size_t> countRuns(const SweepPlan& plan, const SweepState& state) {
  std::map<RunEnd, std::size_t> counts;
  for (std::size_t i = 0; i < plan.runs(); ++i) ++counts[state.task(plan.run(i).task).status.end];
  return counts;
}

void writeSweepTables(const SweepPlan& plan, const SweepState& state, const std::filesystem::path& folder,
                      const Provenance& provenance) {
  const SweepManifest& manifest = plan.manifest();
  const JournalWriter place(journalFolder(folder));  // for its folder alone
  std::vector<SweepMetric> metrics = metricsOf(plan, state);
  const std::optional<SweepMisfit> misfit = misfitOf(plan, place.work());
  if (misfit) metrics.insert(metrics.end(), {{misfit_metric}, {offset_metric}});
  SweepTableLayout layout = layoutOf(plan, std::move(metrics), provenance);
  if (misfit) layout.measured_N = misfit->at(layout.curve_time_s);
  std::size_t width = 0;
  for (const CurveQuantity& curve : layout.curves) width += layout.width(curve);
  RowReader reader(state, layout.metrics);
  bool complete = true;
  SweepTableWriter writer(tableFile(place.work()), layout);
  for (std::size_t i = 0; i < plan.runs(); ++i) {
    const PlannedRun planned = plan.run(i);
    const SweepState::Task& task = state.task(planned.task);
    SweepRun run{static_cast<long long>(planned.point),
                 planned.repeat,
                 manifest.pipelines[planned.entry],
                 task.status.end,
                 task.status.detail,
                 task.file,
                 {},
                 {},
                 {}};
    for (std::size_t a = 0; a < layout.axes.size(); ++a)
      run.values.push_back(manifest.points.value(planned.point, a));
    run.metrics.assign(layout.metrics.size(), kMissing);
    run.curves.assign(width, kMissing);
    if (task.finished) reader.fill(planned.task, planned.law, run);
    if (task.finished && misfit) fillMisfit(*misfit, layout, run);
    complete &= task.place.has_value();
    writer.append(run);
  }
  writer.finish(complete);
  writeSweepCsv(csvFile(place.work()), SweepTable(tableFile(place.work())));
  for (const auto& file : {tableFile, csvFile}) {
    std::error_code error;
    std::filesystem::rename(file(place.work()), file(folder), error);
    if (error) throw RunError(file(folder).string() + ": cannot be written: " + error.message());
  }
}

bool comparesNothing(const SweepPlan& plan, const std::filesystem::path& folder) {
  if (!plan.manifest().settings.fit) return false;
  const std::vector<double> misfits = SweepTable(tableFile(folder)).numbers(misfit_metric);
  return std::all_of(misfits.begin(), misfits.end(), [](double misfit) { return std::isnan(misfit); });
}

}  // namespace fissure
