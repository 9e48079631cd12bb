#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// What is wrong with a surface that must be closed, consistently oriented and outward; one line a defect with its count,
/// e.g. "3 boundary edges (the surface is open)". Empty: none.
std::vector<std::string> findDefects(const TriangleMesh& mesh);

/// Enclosed volume of a closed, outward surface by the divergence theorem, m^3; negative when inside out.
double signedVolume_m3(const TriangleMesh& mesh);

}  // namespace fissure
