#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fissure {

/// Throws InputError about `file` unless it is a regular file: a pipe or a device may deliver nothing, or
/// never end. `expected`: the word for its contents in messages, as "a mesh".
void requireInputFile(const std::filesystem::path& file, const std::string& expected);

/// The whole contents of a regular file of at most `most_bytes`, a multiple of 1 MiB; by default of any size
/// that fits into memory. A file of size 0, as in /proc, counts as empty without being read. Throws
/// InputError about `file` as requireInputFile does, and when it is larger (the message states the limit),
/// cannot be read, or changes its size while it is read.
std::string readInputFile(const std::filesystem::path& file, const std::string& expected,
                          std::uintmax_t most_bytes = UINTMAX_MAX);

}  // namespace fissure
