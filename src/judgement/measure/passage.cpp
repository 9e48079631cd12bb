#include "measure/passage.h"

#include <algorithm>

namespace fissure {

bool Passage::advance(std::size_t sample, std::span<const Crossing> crossings, bool inside) {
  bool entered = entered_[sample] != 0;
  bool passed = false;
  bool left = false;
  for (const Crossing& crossing : crossings) {
    Crossing& entry = entries_[sample];
    if (crossing.entering) {
      if (!entered || left) entry = crossing;
      entered = true;
      left = false;
    } else if (entered) {
      passed =
          passed || (entry.direction.dot(crossing.direction) > 0 && entry.normal.dot(crossing.normal) < 0);
      left = true;
    }
  }
  // The winding number has the last word: after the inner of two overlapping sheets a sample is still inside.
  entered_[sample] = entered && inside;
  return passed;
}

void Passage::restart() {
  std::fill(entered_.begin(), entered_.end(), std::uint8_t{0});
}

}  // namespace fissure
