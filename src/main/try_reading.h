#pragma once

#include <filesystem>
#include <functional>

namespace fissure {

/// Runs `read` in a process of its own first: on damaged files HDF5 1.10 may crash, or loop for ever. Throws
/// InputError about `file` when it does; an exception of `read` is left for the caller to meet.
void tryReading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace fissure
