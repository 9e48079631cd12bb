#pragma once

#include <cstddef>
#include <string_view>

namespace fissure {

/// Vertices that a file states and no face names.
struct UnusedVertices {
  std::size_t count = 0;
  int first_line = 0;  ///< of the first of them, from 1; 0: there is none
};

/// Of the text of an OBJ file. Faces that name vertices which do not exist, and lines that are no OBJ, are
/// left to the reader of the mesh.
UnusedVertices unusedVertices(std::string_view obj);

}  // namespace fissure
