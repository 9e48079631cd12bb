#pragma once

#include <filesystem>
#include <string>

#include "table/sweep_table.h"

namespace fissure {

/// A field of a table as RFC 4180 has it: in quotes, doubled within, where it holds a comma, a quote or the
/// end of a line.
std::string csvField(const std::string& text);

/// Writes the rows of a table as comma-separated values, whole or not at all, with a head of column names:
/// run, point, pipeline, repeat, the axes, status, status_detail, file, and all metrics but those of timing/,
/// so that the same runs give the same bytes. Numbers in the shortest form that reads back, but whole numbers
/// of what is counted (run, point, repeat, metrics without a unit) in plain digits, missing ones empty; no
/// curves; lines end with a line feed. Throws RunError about `path`, InputError about the table.
void writeSweepCsv(const std::filesystem::path& path, const SweepTable& table);

}  // namespace fissure
