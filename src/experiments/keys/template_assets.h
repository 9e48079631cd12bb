#pragma once

#include <string_view>

namespace fissure::assets {

/// The contents of the files in configs/templates, which CMake embeds in the program (embed.cmake).
extern const std::string_view press_yaml;
extern const std::string_view clamp_yaml;
extern const std::string_view fissure_yaml;
extern const std::string_view replay_yaml;
extern const std::string_view replay_csv;
extern const std::string_view organ_yaml;
extern const std::string_view organ_obj;
extern const std::string_view elastic_yaml;
extern const std::string_view sweep_yaml;
extern const std::string_view sweep_scene_yaml;

}  // namespace fissure::assets
