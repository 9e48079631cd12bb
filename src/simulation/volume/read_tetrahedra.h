#pragma once

#include <string_view>

namespace fissure::assets {

/// The text of read_tetrahedra.py, which CMake copies into the program (embed.cmake).
extern const std::string_view read_tetrahedra_py;

}  // namespace fissure::assets
