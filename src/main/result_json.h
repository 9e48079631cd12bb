#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "store/result_file.h"

namespace fissure {

/// The output of `fissure info` for programs; numbers that are not finite become null.
nlohmann::ordered_json resultJson(const std::filesystem::path& file, const ResultInfo& info);

/// JSON as text; invalid UTF-8 is replaced and is no error.
std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace fissure
