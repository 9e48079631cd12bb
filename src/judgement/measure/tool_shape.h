#pragma once

#include <optional>

#include "base/scene.h"
#include "surface/surface_tree.h"

namespace fissure {

/// A tool as a solid: how deep inside it, or how far outside, a point is. A tool whose surface is open has no
/// inside: every point is outside of it.
class ToolShape {
 public:
  explicit ToolShape(const SceneTool& tool);

  /// Distance to the tool's surface, metres, for a point in the tool's frame: negative inside, exact on both
  /// sides. Outside, distances beyond `limit_m` may be given as infinity.
  double signedDistance_m(const Vec3& in_tool, double limit_m) const;

 private:
  bool closed_;
  std::optional<Vec3> half_size_m_;
  std::optional<SurfaceTree> surface_;
};

}  // namespace fissure
