#pragma once

#include <string_view>

namespace fissure {

/// What a shape is called and how `list` describes it, one line each.
struct ShapeText {
  std::string_view name;  ///< `type` in files
  std::string_view as_body;
  std::string_view as_tool;
};

/// What a motion is called and how people read of it.
struct MotionText {
  std::string_view name;  ///< `type` in files
  std::string_view description;
  std::string_view in_plan;  ///< "scripted motion"
};

}  // namespace fissure
