#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "process/apart.h"

namespace fissure {

/// Calls `make` in a child process (doApart) with limits `allowance`, because it may read damaged files, and
/// writes the text it returns to `target`, completely or not at all. Throws what `make` throws as InputError
/// or RunError, LostApart when the child process is lost, Interrupted on request, and RunError when the file
/// cannot be written.
void writePageApart(const std::filesystem::path& target, const std::function<std::string()>& make,
                    const Allowance& allowance);

}  // namespace fissure
