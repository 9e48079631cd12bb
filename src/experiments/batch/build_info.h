#pragma once

#include <string>

namespace fissure {

/// The build of this program, for provenance.
struct BuildInfo {
  std::string version;
  /// "unknown" when it was not built from a checkout.
  std::string commit;
  bool dirty = false;  ///< the checkout had uncommitted changes
  std::string compiler;
  std::string flags;
  std::string build_type;
  std::string yaml_cpp_version;  ///< at build time: the library has no function for it
};

const BuildInfo& buildInfo();

}  // namespace fissure
