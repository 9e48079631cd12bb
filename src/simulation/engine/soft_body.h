#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <memory>
#include <span>

#include "base/scene.h"
#include "scenario/bodies.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Bullet's soft body over the surface `rest`, as btSoftBodyHelpers::CreateFromTriMesh,
/// generateBendingConstraints, setTotalMass and setPose would make it, link for link and in their order,
/// without their n x n tables (engine/METHOD.md 3). All of `settings` is applied, and from `pipeline` the
/// kind of contact with rigid shapes and its hardness (kKHR). The vertices `fixed_vertices` have inverse mass
/// 0, and dominate the pose to which the body is matched.
std::unique_ptr<btSoftBody> makeSoftBody(btSoftBodyWorldInfo& world_info, const TriangleMesh& rest,
                                         const BodySettings& settings, const PipelineSettings& pipeline,
                                         std::span<const int> fixed_vertices = {});

}  // namespace fissure
