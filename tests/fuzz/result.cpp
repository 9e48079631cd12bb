#include <algorithm>

#include "base/error.h"
#include "store/force_inputs.h"
#include "store/part_reader.h"
#include "store/result_file.h"
#include "store/run_reader.h"
#include "store/salvage.h"
#include "store/snapshot_reader.h"
#include "table/sweep_table.h"
#include "target.h"

namespace fissure::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t some_rows = 3;

void readRun(const fs::path& file, const std::string& name) {
  accepts(file, Refusal::file, [&] {
    const RunReader run(file, name);
    for (const StoredQuantity& quantity : run.quantities()) {
      const std::size_t rows = std::min(quantity.rows, some_rows);
      require(run.rows(quantity, 0, rows).size() == rows * quantity.columns(), "rows have all their values");
    }
    if (const StoredQuantity* frames = run.find("frames"); frames && frames->rows > 0)
      run.picture(*frames, 0);
  });
  accepts(file, Refusal::file, [&] {
    const SnapshotReader snapshots(file, name);
    for (std::size_t i = 0; i < std::min(some_rows, snapshots.times_s().size()); ++i) {
      snapshots.at(i);
      snapshots.depths(i);
    }
  });
  accepts(file, Refusal::file, [&] { readForceInputs(file, name); });
}

void readResult(const fs::path& file) {
  ResultInfo info;
  if (!accepts(file, Refusal::file, [&] { info = readResultInfo(file); })) return;
  for (const PipelineResult& run : info.pipelines) readRun(file, run.name);
}

void readTable(const fs::path& file) {
  accepts(file, Refusal::file, [&] {
    const SweepTable table(file);
    const std::size_t rows = std::min(some_rows, table.runs());
    for (const SweepAxisColumn& axis : table.layout().axes) {
      if (axis.numeric)
        table.numbers(axis.name, 0, rows);
      else
        table.texts(axis.name, 0, rows);
    }
    for (const SweepMetric& metric : table.layout().metrics)
      require(table.numbers(metric.name, 0, rows).size() == rows, "a column has a value per run");
    for (const char* column : {"pipeline", "status", "status_detail", "file"}) table.texts(column, 0, rows);
    for (const CurveQuantity& curve : table.layout().curves) table.curves(curve, 0, rows);
    table.ends();
  });
}

void readPart(const fs::path& file) {
  PartContent content;
  if (!accepts(file, Refusal::file, [&] { content = inspectPart(file); })) return;
  accepts(file, Refusal::file, [&] {
    const LoadedScenario loaded = parseStoredScenario(content.scenario_resolved, file);
    assembleSalvaged(scratch() / "salvaged.h5", loaded, {},
                     {loaded.scenario.pipelines.front(), file, content.status});
  });
}

}  // namespace

/// Any bytes are read as a result, a table of a sweep and a part.
void takeResult(const std::string& bytes) {
  const fs::path file = put("fuzzed.h5", bytes);
  survives("libhdf5", [&] {
    bool is_table = false;
    if (!accepts(file, Refusal::file, [&] { is_table = isSweepTable(file); })) return;
    if (is_table) return readTable(file);
    readResult(file);
    readPart(file);
  });
}

}  // namespace fissure::fuzz
