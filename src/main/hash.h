#pragma once

#include <string>
#include <string_view>

namespace fissure {

/// "fnv1a64:" and 16 hexadecimal digits (Fowler, Noll and Vo, 64 bits). Finds an input that has changed; it
/// does not resist somebody who wants two inputs with one hash.
std::string hashText(std::string_view bytes);

}  // namespace fissure
