#pragma once

#include <memory>

#include "base/image.h"
#include "base/scene.h"
#include "render/camera.h"
#include "scenario/scenario.h"

namespace fissure {

/// A software renderer on OSMesa, which is loaded (dlopen) here and not before. `first` frames the default
/// camera when `settings` names none, and the ground's visible part. What is drawn: ScenePainter and
/// overlay.h say. Vertices that are not finite are left out with their triangles. Two pictures of one state
/// are the same, byte for byte. Throws RunError when OSMesa is not installed or refuses the size; InputError
/// when the camera looks at itself.
std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const FrameSettings& settings,
                                                   const State& first);
/// The same through a camera of one's own, which has the size of the pictures.
std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const Camera& camera,
                                                   const State& first);

}  // namespace fissure
