#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/crossing.h"

namespace fissure {

/// Follows the samples of one tool through one body and tells which have passed right through it. A sample
/// has passed when it came in through one sheet of the surface and left through another going on in the same
/// direction:
///   direction_in . direction_out > 0  (motion of the sample relative to the tissue it crosses), and
///   normal_in . normal_out < 0        (the sheets face opposite ways).
/// Going in and coming out again is not passing; nor is clipping a side, where both normals point to that
/// side. Tissue in which a sample starts was not entered. A jump over the whole body within a step counts, by
/// the two crossings on the way.
class Passage {
 public:
  explicit Passage(std::size_t sample_count) : entered_(sample_count, 0), entries_(sample_count) {}

  /// One step of one sample: its crossings in order of time, and whether it is inside the body (winding
  /// number) after it. Returns whether it passed through the body in this step.
  bool advance(std::size_t sample, std::span<const Crossing> crossings, bool inside);
  /// Forgets how samples came in: positions are not connected to those before. Samples inside count as
  /// started there.
  void restart();

 private:
  std::vector<std::uint8_t> entered_;  // 1: the sample came in from outside and has not left
  std::vector<Crossing> entries_;      // how; kept apart, because most steps need only the flag
};

}  // namespace fissure
