#include "batch/build_info.h"

#include "fissure_commit.h"

namespace fissure {

const BuildInfo& buildInfo() {
  static const BuildInfo info{FISSURE_VERSION, FISSURE_COMMIT,     FISSURE_DIRTY != 0,      FISSURE_COMPILER,
                              FISSURE_FLAGS,   FISSURE_BUILD_TYPE, FISSURE_YAML_CPP_VERSION};
  return info;
}

}  // namespace fissure
