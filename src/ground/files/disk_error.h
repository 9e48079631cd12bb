#pragma once

#include "base/error.h"

namespace fissure {

/// A file could not be written: the disk is to blame, not what was to be written.
class DiskError : public RunError {
 public:
  using RunError::RunError;
};

}  // namespace fissure
