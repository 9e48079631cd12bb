#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fissure {

/// Throws InputError about `file` unless it is a regular file: a pipe or a device may bring nothing, or
/// never end. `expected`: what messages say that should be there, as "a mesh".
void requireInputFile(const std::filesystem::path& file, const std::string& expected);

/// The whole contents of a regular file of at most `most_bytes`, a multiple of 1 MiB, or of any size that
/// memory holds. A file whose size is 0 is empty, whatever reading it would bring (those of /proc).
/// Throws InputError about `file`: as requireInputFile, or it is larger (the message says the limit), cannot
/// be read, or grows or shrinks meanwhile.
std::string readInputFile(const std::filesystem::path& file, const std::string& expected,
                          std::uintmax_t most_bytes = UINTMAX_MAX);

}  // namespace fissure
