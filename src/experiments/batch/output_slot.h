#pragma once

#include <filesystem>

#include "files/output_claim.h"

namespace fissure {

/// The place of one result file while its runs are made: claimed, and with a hidden folder beside it for the
/// parts. All but the result is gone afterwards. A front that is killed leaves folder and parts, for salvage;
/// the next slot of the same file removes them.
class OutputSlot {
 public:
  /// Throws InputError as OutputClaim does.
  OutputSlot(const std::filesystem::path& output, bool replace);
  ~OutputSlot();
  OutputSlot(const OutputSlot&) = delete;
  OutputSlot& operator=(const OutputSlot&) = delete;

  const std::filesystem::path& parts() const { return parts_; }
  /// Where an interrupted batch writes when the file already exists: `<output without .h5>.interrupted.h5`.
  std::filesystem::path interruptedOutput() const;

 private:
  void removeLeftovers() const;

  std::filesystem::path output_;
  OutputClaim claim_;
  std::filesystem::path parts_;
};

}  // namespace fissure
