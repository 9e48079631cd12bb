#pragma once

#include <filesystem>

#include "files/output_claim.h"

namespace fissure {

/// A reserved result file (OutputClaim) with a hidden folder beside it for the parts of its runs. The folder
/// is removed in the end. A killed program leaves folder and parts, for salvage; the next slot of the same
/// file removes them.
class OutputSlot {
 public:
  /// Reserves `output` and makes the folder. Throws InputError as OutputClaim does.
  OutputSlot(const std::filesystem::path& output, bool replace);
  ~OutputSlot();
  OutputSlot(const OutputSlot&) = delete;
  OutputSlot& operator=(const OutputSlot&) = delete;

  const std::filesystem::path& parts() const { return parts_; }
  /// The file for an interrupted batch when the result already exists: `<output without .h5>.interrupted.h5`.
  std::filesystem::path interruptedOutput() const;

 private:
  void removeLeftovers() const;

  std::filesystem::path output_;
  OutputClaim claim_;
  std::filesystem::path parts_;
};

}  // namespace fissure
