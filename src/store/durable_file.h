#pragma once

#include <filesystem>

namespace fissure {

/// Where `process` writes what shall stand under `target`: `<target>.<process>.<n>.tmp`, beside it.
std::filesystem::path temporaryName(const std::filesystem::path& target, int process, int n);

/// Makes a written file durable, renames it to `target` in the same folder and makes the folder durable.
/// Throws RunError.
void moveIntoPlace(const std::filesystem::path& written, const std::filesystem::path& target);

}  // namespace fissure
