#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/curve_rank.h"
#include "table/sweep_table.h"

namespace fissure {

/// The runs of a sweep in the order of their misfit to a measured curve.
struct SweepRanking {
  MeasuredCurve curve;  ///< its points that the sweep's curves may reach; a warning counts the others
  std::vector<Misfit> misfits;
};

/// By the sweep's curve `force`, one a law, over its time; by depth over its curve `indentation` (m, since
/// first contact). Throws InputError when the table lacks them, or no run can be compared.
SweepRanking rankSweep(const SweepTable& table, const MeasuredCurve& curve, MatchBy by,
                       std::optional<double> fixed_offset_N);

/// Reads all of a table that a ranking may need: whether that is damaged.
void readRanked(const SweepTable& table);

/// For people: the best `most` runs with their axes' values.
std::string rankingText(const SweepTable& table, const SweepRanking& ranking, std::size_t most);

/// All runs, for machines.
nlohmann::ordered_json rankingJson(const SweepTable& table, const SweepRanking& ranking);

}  // namespace fissure
