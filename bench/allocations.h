#pragma once

namespace fissure::bench {

/// Calls of `operator new` so far, on this thread: Mesa's threads allocate when they please.
long long allocations();

}  // namespace fissure::bench
