#pragma once

#include "base/scene.h"
#include "elastic/elastic_tissue.h"
#include "scenario/bodies.h"

namespace fissure {

/// Makes the finite elements of an elastic body; `body` must have its volume. Throws as the constructor of
/// ElasticTissue.
ElasticTissue makeTissue(const BodySettings& settings, const SceneBody& body, const Vec3& gravity_m_s2);

}  // namespace fissure
