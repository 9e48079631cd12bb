#include "target.h"

namespace fissure::fuzz {

/// This stands by itself, so that no other source is compiled anew where the folder has another name.
const std::filesystem::path& house() {
  static const std::filesystem::path folder = FISSURE_SOURCE_DIR;
  return folder;
}

}  // namespace fissure::fuzz
