#pragma once

#include <memory>

#include "base/image.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// A software renderer on OSMesa, which is loaded (dlopen) here and not before. `first` frames the default camera when
/// `settings` names none. Throws RunError when OSMesa is not installed or refuses the size.
std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const FrameSettings& settings,
                                                   const State& first);

}  // namespace fissure
