#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/curve_rank.h"
#include "table/sweep_table.h"

namespace fissure {

/// The runs of a sweep, sorted by their misfit to a measured curve.
struct SweepRanking {
  /// The points within reach of the sweep's curves; a warning has the number of others.
  MeasuredCurve curve;
  std::vector<Misfit> misfits;
};

/// Compares the sweep's curve `force`, of each law, with the measured curve over time, or over depth by the
/// sweep's curve `indentation` (m, since first contact). Throws InputError when the table lacks these curves,
/// or no run can be compared.
SweepRanking rankSweep(const SweepTable& table, const MeasuredCurve& curve, MatchBy by,
                       std::optional<double> fixed_offset_N);

/// Reads all parts of a table that a ranking may need, to find out whether it is damaged.
void readRanked(const SweepTable& table);

/// The ranking as text for people: the best `most` runs with the values of their axes.
std::string rankingText(const SweepTable& table, const SweepRanking& ranking, std::size_t most);

/// The ranking of all runs, for programs.
nlohmann::ordered_json rankingJson(const SweepTable& table, const SweepRanking& ranking);

}  // namespace fissure
