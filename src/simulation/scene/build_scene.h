#pragma once

#include "base/scene.h"
#include "scenario/scenario.h"
#include "volume/mesh_files.h"

namespace fissure {

/// Builds the geometry of a scenario, with the tools of rigidTools(). Tools get nodes only if `with_nodes`,
/// clamps get handles only if the scenario asks for frames or snapshots. Throws InputError for a mesh file
/// that cannot be read (loadSurface, readTetrahedra), for a surface that cannot be filled
/// (fillWithTetrahedra), for invalid regions of an elastic body (volumeRegions), and for nodes on more than
/// 131,072 triangles.
Scene buildScene(const Scenario& scenario, bool with_nodes, const MeshFiles& files);

/// The same with a cache of its own for the scenario's files.
Scene buildScene(const Scenario& scenario, bool with_nodes);

/// Turns a scene that was built with nodes into that of one pipeline: nodes are removed unless the pipeline
/// uses them.
void adaptTo(const PipelineSettings& pipeline, Scene& scene);

}  // namespace fissure
