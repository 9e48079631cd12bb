#include "sweep/sweep_state.h"

#include <fmt/core.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "base/hash.h"

namespace fissure {

std::filesystem::path journalFolder(const std::filesystem::path& folder) {
  return folder / "journals";
}

std::filesystem::path resultFolder(const std::filesystem::path& folder) {
  return folder / "runs";
}

namespace {

TaskRecord recordIn(const std::string& bytes, const std::filesystem::path& journal) {
  try {
    return decodeRecord(bytes);
  } catch (const RunError& error) {
    throw RunError(journal.string() + ": " + error.what());
  }
}

}  // namespace

SweepState::SweepState(const SweepPlan& plan, const std::filesystem::path& folder)
    : plan_(plan), journals_(journalFolder(folder)), tasks_(plan.tasks().size()) {
  for (Task& task : tasks_) task.status = {RunEnd::missing, ""};
  std::unordered_map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < plan.tasks().size(); ++i) known.emplace(plan.tasks()[i].id, i);
  journals_.each([&](const std::string& bytes, const JournalPlace& place) {
    const TaskRecord record = recordIn(bytes, journals_.files()[place.journal]);
    const auto at = known.find(record.task);
    if (at == known.end())
      ++unplanned_records_;
    else
      take(at->second, record, place);
  });
  compareRepeats();
}

void SweepState::take(std::size_t index, const TaskRecord& record, const JournalPlace& place) {
  Task& task = tasks_[index];
  const std::string hash =
      record.finished() ? fnv1a64(nameOf(record.status.end) + "\n" + record.numbers) : "";
  if (task.finished && record.finished() && task.numbers_hash != hash)
    throw RunError(
        fmt::format("{}: two runs of task {} gave different numbers (the other is in {}), expected the same; "
                    "remove the journal that is wrong, what it held is run again",
                    journals_.files()[place.journal].string(), record.task,
                    journals_.files()[task.place->journal].string()));
  if (task.place && !record.finished() && (task.finished || record.recorded_s < task.recorded_s)) return;
  task.place = place;
  task.status = record.status;
  task.finished = record.finished();
  task.numbers_hash = hash;
  task.file = record.file;
  task.file_bytes = record.file_bytes;
  task.file_time = record.file_time;
  task.recorded_s = record.recorded_s;
  const auto wall = record.timing.find("timing/worker_wall_s");
  if (wall != record.timing.end()) task.wall_s = wall->second;
}

void SweepState::compareRepeats() const {
  const std::vector<SweepTask>& tasks = plan_.tasks();  // repeats side by side
  std::size_t known = tasks.size();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].repeat == 0) known = tasks.size();
    if (!tasks_[i].finished) continue;
    if (known < tasks.size() && tasks_[i].numbers_hash != tasks_[known].numbers_hash)
      throw RunError(
          fmt::format("two repeats of one run gave different numbers (tasks {} and {}), expected the same",
                      tasks[known].id, tasks[i].id));
    known = i;
  }
}

SweepState::Head SweepState::head(std::size_t index) const {
  constexpr std::size_t enough = 8192;
  const JournalPlace& place = *tasks_[index].place;
  const auto read = [&](std::size_t bytes) {
    const std::string start = journals_.read(place, 0, bytes);
    auto [record, at] = decodeRecordHead(start);
    Head head{std::move(record), {}, at};
    if (at < start.size()) head.numbers = decodeNumbersHead(start.substr(at));
    return head;
  };
  try {
    return read(enough);
  } catch (const RunError&) {  // a longer head than most
    return read(std::size_t{1} << 22);
  }
}

std::vector<double> SweepState::numbers(std::size_t index, const Head& head, std::size_t first,
                                        std::size_t count) const {
  std::vector<double> found =
      numbersIn(journals_.read(*tasks_[index].place, head.numbers_at + first, count * sizeof(double)));
  if (found.size() != count)
    throw RunError(fmt::format("task {}: its record is cut", plan_.tasks()[index].id));
  return found;
}

void SweepState::forget(std::size_t index) {
  tasks_[index] = {};
  tasks_[index].status = {RunEnd::missing, ""};
}

std::vector<std::size_t> SweepState::unfinished() const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tasks_.size(); ++i)
    if (!tasks_[i].finished) indices.push_back(i);
  std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
    const Task &one = tasks_[a], &other = tasks_[b];
    return std::pair(one.place.has_value(), one.recorded_s) <
           std::pair(other.place.has_value(), other.recorded_s);
  });
  return indices;
}

}  // namespace fissure
