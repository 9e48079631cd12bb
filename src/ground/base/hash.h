#pragma once

#include <string>
#include <string_view>

namespace fissure {

/// FNV-1a, 64 bits (Fowler, Noll and Vo), as 16 hexadecimal digits: the same everywhere. Tells contents
/// apart; it does not resist somebody who wants two contents with one hash.
std::string fnv1a64(std::string_view bytes);

}  // namespace fissure
