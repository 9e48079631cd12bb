#pragma once

#include <memory>

#include "base/image.h"
#include "base/scene.h"
#include "render/camera.h"
#include "scenario/scenario.h"

namespace fissure {

/// Makes a software renderer on OSMesa, which is loaded (dlopen) by this call. The state `first` determines
/// the default camera, where `settings` has none, and the visible part of the ground. ScenePainter and
/// overlay.h describe what is drawn. Triangles with a vertex that is not finite are left out. Two pictures of
/// one state are equal byte for byte. Throws RunError when OSMesa is not installed or refuses the size,
/// InputError when the camera's position and target coincide.
std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const FrameSettings& settings,
                                                   const State& first);
/// The same with a given camera, which also has the size of the pictures.
std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const Camera& camera,
                                                   const State& first);

}  // namespace fissure
