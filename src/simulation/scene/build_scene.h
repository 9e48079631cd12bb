#pragma once

#include "base/scene.h"
#include "scenario/scenario.h"
#include "volume/mesh_files.h"

namespace fissure {

/// The geometry that a scenario describes, its tools those of rigidTools(). Tools get their nodes only when
/// `with_nodes`, clamps their handles only when the scenario asks for frames or snapshots.
/// Throws InputError for a mesh file that cannot be read (loadSurface, readTetrahedra), for a surface that
/// cannot be filled (fillWithTetrahedra), for regions of an elastic body that are none (volumeRegions), and
/// for nodes in more than 131,072 triangles.
Scene buildScene(const Scenario& scenario, bool with_nodes, const MeshFiles& files);

/// The same for a scenario none of whose files has been read yet.
Scene buildScene(const Scenario& scenario, bool with_nodes);

/// Makes of a scene built with nodes that of one pipeline: nodes stay where it uses them.
void adaptTo(const PipelineSettings& pipeline, Scene& scene);

}  // namespace fissure
