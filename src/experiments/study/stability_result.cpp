#include "study/stability_result.h"

#include <cmath>

#include "store/result_file.h"
#include "store/run_reader.h"

namespace fissure {

namespace {

/// The magnitudes of the vectors of a quantity over time: a curve for each index of its other axis, or one.
void addVectors(const RunReader& reader, const char* quantity, const std::string& name, CellRun& run) {
  const StoredQuantity* found = reader.find(quantity);
  if (!found) return;
  const std::size_t columns = found->columns(), vectors = columns / 3;
  const std::vector<double> values = reader.all(*found);
  for (std::size_t v = 0; v < vectors; ++v) {
    const bool labelled = found->axes.size() > 1 && !found->axes[0].labels.empty();
    CellCurve curve{labelled ? name + found->axes[0].labels[v] : name, true, {}};
    for (std::size_t row = 0; row < found->rows; ++row) {
      const double* at = &values[row * columns + 3 * v];
      curve.values.push_back(std::hypot(at[0], at[1], at[2]));
    }
    run.curves.push_back(std::move(curve));
  }
}

}  // namespace

CellRun readCellRun(const std::filesystem::path& file, const std::string& pipeline) {
  CellRun run;
  const ResultInfo info = readResultInfo(file);
  for (const PipelineResult& result : info.pipelines)
    if (result.name == pipeline) run.summary = result.summary;
  const RunReader reader(file, pipeline);
  for (const char* name :
       {"penetration_depth", "kinetic_energy", "stored_energy", "contact_count", "capped_count"})
    if (const StoredQuantity* found = reader.find(name))
      run.curves.push_back({name, false, reader.all(*found)});
  addVectors(reader, "tool_position", "position of ", run);
  for (CellCurve& curve : run.curves) curve.is_force = false;
  addVectors(reader, "reaction_force", "reaction", run);
  addVectors(reader, "force", "", run);
  addVectors(reader, "coupling_force", "coupling of ", run);
  return run;
}

}  // namespace fissure
