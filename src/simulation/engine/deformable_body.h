#pragma once

#include <BulletSoftBody/btDeformableLagrangianForce.h>
#include <BulletSoftBody/btSoftBody.h>

#include <memory>
#include <vector>

#include "base/scene.h"
#include "scenario/bodies.h"
#include "scenario/pipelines.h"

namespace fissure {

/// An elastic body as a soft body of Bullet's deformable world (engine/METHOD.md 5). Its nodes are the mesh's
/// vertices with the fixed ones last, because in an implicit step Bullet 3.24 gives the nodes after a fixed
/// one their predecessors' forces.
struct DeformableBody {
  std::unique_ptr<btSoftBody> body;
  std::vector<int> node_of_vertex;  ///< [vertex of the mesh] index of its node
};

/// Makes the soft body with lumped masses, a quarter of each tetrahedron's mass per corner; fixed vertices
/// have inverse mass 0. Its faces are those of the surface, in their order. Its links are the edges of the
/// tetrahedra; they bear no force in this world, but without them Bullet's construction of its tree of nodes
/// never ends.
DeformableBody makeDeformableBody(btSoftBodyWorldInfo& world_info, const SceneBody& scene_body,
                                  const BodySettings& settings, const PipelineSettings& pipeline);

/// Bullet's elastic force for the body's material. The stable neo-Hookean force gets coefficients with which
/// small strains have the modulus and ratio of `settings` (Smith, de Goes and Kim 2018, section 3.4); with
/// the Lame constants themselves it would be a quarter softer in shear. The viscosity is that of shear; with
/// the corotated law Bullet damps changes of volume in the same proportion.
std::unique_ptr<btDeformableLagrangianForce> makeElasticity(const ElasticSettings& settings);

/// Elastic energy of the body, joules, 0 at rest, by the law of makeElasticity(), for the deformations of the
/// last btSoftBody::updateDeformation().
double storedEnergy_J(const btSoftBody& body, const ElasticSettings& settings);

}  // namespace fissure
