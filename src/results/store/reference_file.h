#pragma once

#include <cstddef>
#include <filesystem>

#include "store/run_reader.h"

namespace fissure {

/// How many rows a reference keeps of each series.
struct ReferenceSize {
  std::size_t steps = 25;
  std::size_t snapshots = 3;
};

/// Whether a reference keeps a quantity: all but pictures, volumes and the inputs of force laws.
bool inReference(const StoredQuantity& quantity);

/// Makes a small copy of a result that later results are compared with: a result file with the attribute
/// `reference` = 1, summaries and provenance as they are, no timing/, no volumes/ and no pictures, and of
/// each series at most `size` rows, evenly spread, the first and the last among them. Under `target` stands
/// either the whole file or what stood there before. Throws InputError about `result`, RunError about
/// `target`.
void writeReference(const std::filesystem::path& target, const std::filesystem::path& result,
                    const ReferenceSize& size = {});

}  // namespace fissure
