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
/// without their n x n tables (METHOD: facts about Bullet). Every setting of `settings` is applied,
/// and of `pipeline` how the body meets rigid shapes and with what hardness (kKHR). The vertices
/// `fixed_vertices` have no inverse mass, and the pose that the body is matched to is theirs.
std::unique_ptr<btSoftBody> makeSoftBody(btSoftBodyWorldInfo& world_info, const TriangleMesh& rest,
                                         const BodySettings& settings, const PipelineSettings& pipeline,
                                         std::span<const int> fixed_vertices = {});

}  // namespace fissure
