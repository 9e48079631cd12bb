#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// A dataset's numbers in row-major order; missing values are NaN.
struct SeriesData {
  std::vector<double> values;
  std::vector<std::size_t> shape;  ///< lengths of the axes; their product is the number of values
};

/// Reads one numeric dataset of a result or part file as doubles (int64 beyond 2^53 are rounded). `dataset`
/// is a path as in "/pipelines/fukuhara/time". Throws InputError when the file or the dataset is missing,
/// damaged or text.
SeriesData readSeries(const std::filesystem::path& file, const std::string& dataset);

}  // namespace fissure
