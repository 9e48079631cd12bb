#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "table/sweep_table.h"

namespace fissure {

/// The output of `fissure info` for a sweep's table: how its runs ended, its axes, quantities, curves and
/// provenance.
std::string sweepInfoText(const SweepTable& table);

/// The same for programs.
nlohmann::ordered_json sweepInfoJson(const std::filesystem::path& file, const SweepTable& table);

}  // namespace fissure
