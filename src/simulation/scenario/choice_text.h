#pragma once

#include <string_view>

namespace fissure {

/// The name of a shape and its descriptions in `fissure list`, one line each.
struct ShapeText {
  std::string_view name;  ///< its `type` in files
  std::string_view as_body;
  std::string_view as_tool;
};

/// The name of a motion and its descriptions for people.
struct MotionText {
  std::string_view name;  ///< its `type` in files
  std::string_view description;
  /// Its name in `fissure plan`: "scripted motion".
  std::string_view in_plan;
};

}  // namespace fissure
