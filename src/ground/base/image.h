#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/state.h"

namespace fissure {

/// An RGB picture with 8 bits per channel. `rgb` has width x height x 3 bytes, row by row from the top.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// Draws pictures of a run; it exists only where the scenario asks for frames.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Returns a picture of the scene in `state`, with `lines` of text (printable ASCII) in a corner. Throws
  /// RunError when drawing fails.
  virtual Image draw(const State& state, const std::vector<std::string>& lines) = 0;
  /// Names and versions of the drawing libraries, for provenance, as in {"gl_renderer", "llvmpipe ..."}.
  virtual std::vector<std::pair<std::string, std::string>> versions() const = 0;
};

}  // namespace fissure
