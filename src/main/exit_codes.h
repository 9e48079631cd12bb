#pragma once

namespace fissure {

inline constexpr int exit_good = 0;
inline constexpr int exit_differs = 1;  ///< a comparison or an expectation failed
inline constexpr int exit_usage = 2;    ///< bad input or usage
inline constexpr int exit_run_failed =
    3;  ///< a crash, the time limit, a non-finite state, a full disk (workers: exit_unwritten)
inline constexpr int exit_interrupted = 130;  ///< stopped on request; finished work is kept

}  // namespace fissure
