#pragma once

#include <filesystem>
#include <string>

#include "table/sweep_table.h"

namespace fissure {

/// A field in the format of RFC 4180: in quotes, with quotes inside doubled, where it contains a comma, a
/// quote or a line end.
std::string csvField(const std::string& text);

/// Writes the rows of a table as comma-separated values; the file appears complete or not at all. The header
/// line names the columns: run, point, pipeline, repeat, the axes, status, status_detail, file, and all
/// metrics except those of timing/, so that equal runs give equal bytes. Numbers have the shortest form that
/// reads back to the same double, counts (run, point, repeat, metrics without a unit) plain digits; missing
/// numbers are empty. Curves are left out. Lines end with a line feed. Throws RunError about `path` and
/// InputError about the table.
void writeSweepCsv(const std::filesystem::path& path, const SweepTable& table);

}  // namespace fissure
