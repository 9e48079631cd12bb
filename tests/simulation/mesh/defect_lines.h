#pragma once

#include <string>
#include <vector>

#include "mesh/check.h"

namespace fissure {

/// The lines of what a soft body of this surface cannot be simulated with.
inline std::vector<std::string> findDefects(const TriangleMesh& mesh) {
  std::vector<std::string> lines;
  for (const Defect& defect : inspectSurface(mesh))
    if (spoilsBody(defect.kind)) lines.push_back(defect.text);
  return lines;
}

}  // namespace fissure
