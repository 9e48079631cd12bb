#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fissure {

/// A number followed by the noun it counts: "1 vertex", "2 vertices". `one` is the singular, `many` the
/// plural; an empty `many` stands for `one` with an s.
std::string counted(std::size_t count, std::string_view one, std::string_view many = {});

}  // namespace fissure
