#pragma once

#include <optional>

#include "base/scene.h"
#include "surface/surface_tree.h"

namespace fissure {

/// A tool as a solid with a signed distance. A tool with an open surface has no inside: every point is
/// outside of it.
class ToolShape {
 public:
  explicit ToolShape(const SceneTool& tool);

  /// Signed distance of a point (tool frame) from the tool's surface, metres: negative inside, exact on both
  /// sides. Outside, distances beyond `limit_m` may be returned as infinity.
  double signedDistance_m(const Vec3& in_tool, double limit_m) const;

 private:
  bool closed_;
  std::optional<Vec3> half_size_m_;
  std::optional<SurfaceTree> surface_;
};

}  // namespace fissure
