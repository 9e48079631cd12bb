#pragma once

#include <string>
#include <vector>

#include "paraview/moving_mesh.h"

namespace fissure {

/// An XDMF 2 document that shows the meshes of a run, a block each, at all its times. `files`: of each mesh
/// the file by writeVtkFile(), relative to the document. Read by ParaView's XDMFReader and Xdmf3ReaderT.
std::string xdmfText(const MovingMeshes& run, const std::vector<std::string>& files);

}  // namespace fissure
