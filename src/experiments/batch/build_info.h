#pragma once

#include <string>

namespace fissure {

/// How this program was made.
struct BuildInfo {
  std::string version;
  std::string commit;  ///< "unknown" when it was not built from a checkout
  bool dirty = false;  ///< the checkout had changes
  std::string compiler;
  std::string flags;
  std::string build_type;
  std::string yaml_cpp_version;  ///< the library has no call that says it at run time
};

const BuildInfo& buildInfo();

}  // namespace fissure
