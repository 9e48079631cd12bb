#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/state.h"

namespace fissure {

/// An RGB picture, 8 bits a channel, rows from top to bottom: size width x height x 3.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// Draws pictures of a run; made only when the scenario asks for frames.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// The scene in `state`, with `lines` of text (printable ASCII) in a corner. Throws RunError when drawing
  /// fails.
  virtual Image draw(const State& state, const std::vector<std::string>& lines) = 0;
  /// What draws, for provenance: names and versions, as in {"gl_renderer", "llvmpipe ..."}.
  virtual std::vector<std::pair<std::string, std::string>> versions() const = 0;
};

}  // namespace fissure
