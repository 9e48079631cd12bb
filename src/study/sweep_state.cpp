#include "study/sweep_state.h"

#include <unordered_map>

#include "base/error.h"
#include "base/hash.h"

namespace fissure {

std::filesystem::path journalFolder(const std::filesystem::path& folder) {
  return folder / "journals";
}

std::filesystem::path resultFolder(const std::filesystem::path& folder) {
  return folder / "runs";
}

SweepState::SweepState(const SweepPlan& plan, const std::filesystem::path& folder)
    : plan_(plan), journals_(journalFolder(folder)), tasks_(plan.tasks().size()) {
  for (Task& task : tasks_) task.status = {"missing", ""};
  std::unordered_map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < plan.tasks().size(); ++i) known.emplace(plan.tasks()[i].id, i);
  journals_.each([&](const std::string& bytes, const JournalPlace& place) {
    const TaskRecord record = decodeRecord(bytes);
    const auto at = known.find(record.task);
    if (at == known.end())
      ++strangers_;
    else
      take(at->second, record, place);
  });
  compareRepeats();
}

void SweepState::take(std::size_t index, const TaskRecord& record, const JournalPlace& place) {
  Task& task = tasks_[index];
  const std::string hash = record.finished() ? fnv1a64(record.status.status + "\n" + record.numbers) : "";
  if (task.finished && record.finished() && task.numbers_hash != hash)
    throw RunError(journals_.files()[place.journal].string() + ": two runs of task " + record.task +
                   " gave different numbers (the other is in " +
                   journals_.files()[task.place->journal].string() + "), expected the same");
  if (task.place && !record.finished()) return;
  task.place = place;
  task.status = record.status;
  task.finished = record.finished();
  task.numbers_hash = hash;
  task.file = record.file;
  task.file_bytes = record.file_bytes;
  task.file_time = record.file_time;
  const auto wall = record.timing.find("timing/worker_wall_s");
  if (wall != record.timing.end()) task.wall_s = wall->second;
}

void SweepState::compareRepeats() const {
  const std::vector<SweepTask>& tasks = plan_.tasks();
  for (std::size_t i = 1; i < tasks.size(); ++i) {
    if (tasks[i].repeat == 0 || !tasks_[i].finished || !tasks_[i - 1].finished) continue;
    if (tasks_[i].numbers_hash != tasks_[i - 1].numbers_hash)
      throw RunError("two repeats of one run gave different numbers (tasks " + tasks[i - 1].id + " and " +
                     tasks[i].id + "), expected the same");
  }
}

TaskRecord SweepState::record(std::size_t index) const {
  return decodeRecord(journals_.read(*tasks_[index].place));
}

void SweepState::forget(std::size_t index) {
  tasks_[index] = {};
  tasks_[index].status = {"missing", ""};
}

std::vector<std::size_t> SweepState::unfinished() const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tasks_.size(); ++i)
    if (!tasks_[i].finished) indices.push_back(i);
  return indices;
}

}  // namespace fissure
