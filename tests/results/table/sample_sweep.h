#pragma once

#include <filesystem>

#include "table/sweep_table.h"

namespace fissure {

/// A made-up sweep over k, n and the text axis `shape`, with two pipelines, two laws and two curves at
/// `times` instants. Every value follows from the number of its run; read_sweep.py knows the same formulas:
///   point = run / 2   pipeline = default, full in turn   k = 100 (point % 5 + 1)   n = 1 + (point / 5) / 10
///   max_penetration_depth_m = run / 1000, missing in run 1   steps = 3 run   timing/step_time_us = run / 8
///   depth[run][time] = run + time / 128, missing in the second half of every third run
///   force[run][law][time] = 1000 law + run + time / 128
SweepTableLayout sampleSweep(std::size_t runs, std::size_t times);
SweepRun sampleSweepRun(const SweepTableLayout& layout, std::size_t run);
void writeSampleSweep(const std::filesystem::path& path, const SweepTableLayout& layout,
                      bool complete = true);

}  // namespace fissure
