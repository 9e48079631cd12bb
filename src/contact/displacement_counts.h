#pragma once

namespace fissure {

/// What displacing tissue took so far.
struct DisplacementCounts {
  long long sweeps = 0;  ///< over the contacts of a step, where there were any
  long long pushes = 0;  ///< of a contact in a sweep, where it moved its tissue
};

}  // namespace fissure
