#pragma once

#include <cstddef>
#include <filesystem>

#include "store/run_reader.h"

namespace fissure {

/// Numbers of rows that a reference keeps of each series.
struct ReferenceSize {
  std::size_t steps = 25;
  std::size_t snapshots = 3;
};

/// Whether a reference keeps a quantity: true for all but pictures, volumes and arguments of force laws.
bool inReference(const StoredQuantity& quantity);

/// Writes a small copy of a result, with which later results are compared: a result file with the attribute
/// `reference` = 1, unchanged summaries and provenance, without timing/, volumes/ and pictures, and with at
/// most `size` rows of each series, evenly spread and including the first and the last. `target` is replaced
/// by the complete file or not at all. Throws InputError about `result`, RunError about `target`.
void writeReference(const std::filesystem::path& target, const std::filesystem::path& result,
                    const ReferenceSize& size = {});

}  // namespace fissure
