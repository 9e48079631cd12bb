#pragma once

#include "base/scene.h"
#include "elastic/elastic_tissue.h"
#include "scenario/bodies.h"

namespace fissure {

/// The tissue of an elastic body whose scene has its volume.
ElasticTissue makeTissue(const BodySettings& settings, const SceneBody& body, const Vec3& gravity_m_s2);

}  // namespace fissure
