#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "store/result_file.h"

namespace fissure {

/// What `info` prints, for machines; numbers that are not finite become null.
nlohmann::ordered_json resultJson(const std::filesystem::path& file, const ResultInfo& info);

/// As text: invalid UTF-8 is replaced, never an error.
std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace fissure
