#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// What is wrong with a surface that must be closed, consistently oriented and outward; one line a defect
/// with its count, e.g. "3 boundary edges (the surface is open)". Empty: none. Any mesh may be given, also
/// one with indices out of range or without triangles. Faces that name a vertex twice, or one that does not
/// exist, are reported and then left out of the edge checks; the sense (outward or inside out) is judged only
/// where the surface is closed and consistent. Several closed shells are no defect.
std::vector<std::string> findDefects(const TriangleMesh& mesh);

/// Enclosed volume of a closed, outward surface by the divergence theorem, m^3; negative when inside out.
double signedVolume_m3(const TriangleMesh& mesh);

}  // namespace fissure
