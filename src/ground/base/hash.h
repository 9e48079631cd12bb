#pragma once

#include <string>
#include <string_view>

namespace fissure {

/// FNV-1a, 64 bits (Fowler, Noll and Vo), as 16 hexadecimal digits: the same everywhere. It tells contents
/// apart but is no cryptographic hash: whoever wants to can make two contents with one hash.
std::string fnv1a64(std::string_view bytes);

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::string_view bytes);

}  // namespace fissure
