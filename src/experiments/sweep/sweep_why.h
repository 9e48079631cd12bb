#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sweep/sweep_state.h"

namespace fissure {

/// Why a simulation of a sweep would run now, or why it would not.
enum class WhyRun {
  finished,     ///< not run: its record is there
  other_shard,  ///< not run here, though not finished: it belongs to another shard
  no_record,    ///< it was never recorded
  failed,       ///< it was recorded without an end of its own, and is tried again
  lost,         ///< it was finished, but the result that it kept is gone or damaged
  changed,      ///< its values were planned before, but something that its numbers depend on is another
  added,        ///< the plan before had no simulation of these values
};

/// The reason as `--json` names it: the enumerator's own name.
std::string nameOf(WhyRun why);

struct TaskReason {
  WhyRun why = WhyRun::no_record;
  std::string text;  ///< one line for people, which begins with what the reason is

  bool runs() const { return why != WhyRun::finished && why != WhyRun::other_shard; }
};

/// The reasons of all tasks of a plan, as a session of shard `shard` (from 0) of `shards` would find them.
/// `state`: that of the sweep's folder, after results that were lost are forgotten. Throws InputError where
/// the folder could not take the plan, as putManifest() would.
std::vector<TaskReason> whyTasksRun(const SweepState& state, const std::filesystem::path& folder,
                                    std::size_t shard, std::size_t shards);

/// A row a task: its id, pipeline, values, and the reason's text.
std::vector<std::vector<std::string>> whyRows(const SweepPlan& plan, const std::vector<TaskReason>& reasons);
/// The same for machines, with the reason's name and whether it runs.
nlohmann::ordered_json whyJson(const SweepPlan& plan, const std::vector<TaskReason>& reasons);

}  // namespace fissure
