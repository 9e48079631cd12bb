#pragma once

#include <string>
#include <vector>

#include "paraview/moving_mesh.h"

namespace fissure {

/// The text of an XDMF 2 document with the meshes of a run, one block each, at all its times. `files`: for
/// each mesh the file written by writeVtkFile(), relative to the document. ParaView's XDMFReader and
/// Xdmf3ReaderT read it.
std::string xdmfText(const MovingMeshes& run, const std::vector<std::string>& files);

}  // namespace fissure
