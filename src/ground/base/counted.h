#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fissure {

/// "1 vertex", "2 vertices": a number and what it counts, one and several of it. `many` empty: `one` with an
/// s.
std::string counted(std::size_t count, std::string_view one, std::string_view many = {});

}  // namespace fissure
