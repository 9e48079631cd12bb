#pragma once

#include <BulletSoftBody/btDeformableLagrangianForce.h>
#include <BulletSoftBody/btSoftBody.h>

#include <memory>
#include <vector>

#include "base/scene.h"
#include "scenario/bodies.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Tetrahedra as a soft body of Bullet's deformable world. Its nodes are the mesh's vertices with the fixed
/// ones last: in an implicit step Bullet 3.24 gives the nodes after a fixed one their predecessors' forces.
struct DeformableBody {
  std::unique_ptr<btSoftBody> body;
  std::vector<int> node_of_vertex;  ///< one a vertex of the mesh
};

/// Lumped masses, a quarter of each tetrahedron's for each corner; fixed vertices have no inverse mass. The
/// surface's faces are the body's faces, in their order, and the tetrahedra's edges its links, without which
/// Bullet's tree of nodes never ends; links bear no force in this world.
DeformableBody makeDeformableBody(btSoftBodyWorldInfo& world_info, const SceneBody& scene_body,
                                  const BodySettings& settings, const PipelineSettings& pipeline);

/// Bullet's elasticity of the body's material. Its stable neo-Hookean force gets the coefficients for which
/// small strains have the modulus and ratio of `settings` (Smith, de Goes and Kim 2018, section 3.4): with
/// Lame's own it would be a quarter softer in shear. Viscosity is that of shear; of the corotated law Bullet
/// damps volume in the same proportion.
std::unique_ptr<btDeformableLagrangianForce> makeElasticity(const ElasticSettings& settings);

/// Elastic energy of the body as its deformations stand (btSoftBody::updateDeformation), by the law that
/// makeElasticity() chooses, 0 at rest, joules.
double storedEnergy_J(const btSoftBody& body, const ElasticSettings& settings);

}  // namespace fissure
