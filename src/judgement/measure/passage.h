#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/crossing.h"

namespace fissure {

/// Follows the samples of one tool through one body and finds those that have passed right through it
/// (measure/METHOD.md 2). A sample has passed when it entered through one sheet of the surface and left
/// through another in the same direction:
///   direction_in . direction_out > 0  (motion of the sample relative to the tissue it crosses), and
///   normal_in . normal_out < 0        (the sheets face opposite ways).
/// Going in and coming out again is not passing; nor is clipping a side, where both normals point to that
/// side. Tissue in which a sample starts was not entered. A jump over the whole body within a step is
/// passing, by the two crossings on the path.
class Passage {
 public:
  explicit Passage(std::size_t sample_count) : entered_(sample_count, 0), entries_(sample_count) {}

  /// Takes one step of one sample: its crossings in order of time, and whether it is inside the body
  /// afterwards (by winding number). Returns whether it passed through the body in this step.
  bool advance(std::size_t sample, std::span<const Crossing> crossings, bool inside);
  /// Forgets how samples entered, because their positions are not connected to those before. Samples that are
  /// inside count as started there.
  void restart();

 private:
  std::vector<std::uint8_t> entered_;  // [sample] 1: it entered from outside and has not left
  std::vector<Crossing> entries_;      // [sample] where it entered; rarely read
};

}  // namespace fissure
