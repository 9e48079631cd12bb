#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sample_run.h"
#include "store/read_series.h"
#include "store/result_file.h"
#include "store/salvage.h"

namespace fissure::part_test {

inline RunStatus statusOf(const std::filesystem::path& path) {
  return readResultInfo(path).pipelines.at(0).status;
}

inline std::string stringOf(const ChildResult& child) {
  return std::to_string(child.code) + ": " + child.errors;
}

/// Assembles a result from one part alone and returns the number of rows that made it, each with its right
/// values.
inline std::size_t salvagedRows(const ScratchFolder& folder, const SampleRun& run,
                                const std::filesystem::path& part) {
  const auto path = folder / "salvaged.h5";
  assembleResult(path, loadedSample(run), {},
                 {{run.scenario.pipelines.at(1), part, {RunEnd::crashed, "killed"}}});
  const SeriesData time = readSeries(path, "/pipelines/default/time");
  const SeriesData counts = readSeries(path, "/pipelines/default/contact_count");
  const SeriesData force = readSeries(path, "/pipelines/default/force");
  const SeriesData timing = readSeries(path, "/pipelines/default/timing/time");
  const std::size_t rows = time.values.size();
  EXPECT_EQ(counts.values.size(), rows);
  EXPECT_EQ(force.shape, (std::vector<std::size_t>{2, rows, 3}));
  EXPECT_EQ(timing.values, time.values);
  for (std::size_t row = 0; row < rows; ++row) {
    const double r = static_cast<double>(row);
    if (time.values[row] != r / 2 || counts.values[row] != 3 * r ||
        force.values[(rows + row) * 3] != 100 + r) {
      ADD_FAILURE() << "row " << row << " is damaged";
      break;
    }
  }
  return rows;
}

}  // namespace fissure::part_test
