#pragma once

#include <cstddef>
#include <string_view>

namespace fissure {

/// Vertices of a file that no face names.
struct UnusedVertices {
  std::size_t count = 0;
  int first_line = 0;  ///< line number of the first of them, from 1; 0: there is none
};

/// The unused vertices in the text of an OBJ file. Invalid lines, and faces with vertices that do not exist,
/// are ignored here; the reader of the mesh reports them.
UnusedVertices unusedVertices(std::string_view obj);

}  // namespace fissure
