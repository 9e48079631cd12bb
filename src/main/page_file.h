#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "process/apart.h"

namespace fissure {

/// Writes what `make` returns to `target`, whole or not at all, in a process of its own (apart.h) which
/// may use up `allowance`: it may read damaged files. Throws what `make` throws, as InputError or RunError,
/// LostApart when its process is lost, Interrupted, and RunError when the file cannot be written.
void writePageApart(const std::filesystem::path& target, const std::function<std::string()>& make,
                    const Allowance& allowance);

}  // namespace fissure
