#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <memory>

#include "base/scene.h"
#include "scenario/bodies.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Bullet's soft body over the surface `rest`, as btSoftBodyHelpers::CreateFromTriMesh,
/// generateBendingConstraints, setTotalMass and setPose would make it, link for link and in their order,
/// without their n x n tables (METHOD: facts about Bullet). Every setting of `settings` is applied,
/// and of `pipeline` how the body meets rigid shapes and with what hardness (kKHR).
std::unique_ptr<btSoftBody> makeSoftBody(btSoftBodyWorldInfo& world_info, const TriangleMesh& rest,
                                         const BodySettings& settings, const PipelineSettings& pipeline);

}  // namespace fissure
