#include "scenario/pipelines.h"

namespace fissure {

void PipelineSettings::fillDefaults(ElasticMaterialKind material) {
  if (usesNodes()) {
    vertex_contacts = vertexContacts();
    response = contactResponse();
  }
  if (hasVoxels()) sdf_voxel_m = sdfVoxel_m();
  if (usesSdf()) kinematic_hardness = kinematicHardness();
  if (usesVolume()) deformable = deformableSolver(material);
}

}  // namespace fissure
