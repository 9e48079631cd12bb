#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace fissure {

/// Writes what `make` returns to `target`, whole or not at all, in a process of its own (apart.h) with
/// `most_s` seconds of processor time: it may read damaged files. Throws what `make` throws, as InputError or
/// RunError, LostApart when its process is lost, and RunError when the file cannot be written.
void writePageApart(const std::filesystem::path& target, const std::function<std::string()>& make,
                    unsigned long most_s);

}  // namespace fissure
