#include "sweep/sweep_results.h"

#include "base/error.h"
#include "process/apart.h"
#include "store/result_file.h"
#include "sweep/file_stamp.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

bool canBeRead(const fs::path& file) {
  try {
    tryReadingOwn(file, [&] {
      if (!readResultInfo(file).complete) throw InputError("not complete");
    });
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool hasSize(const fs::path& file, long long bytes) {
  std::error_code error;
  const std::uintmax_t found = fs::file_size(file, error);
  return !error && found == static_cast<std::uintmax_t>(bytes);
}

}  // namespace

void forgetLostResults(SweepState& state, const fs::path& folder, const std::vector<std::size_t>& tasks,
                       ResultCheck check) {
  if (!state.plan().keepsResults()) return;
  for (const std::size_t index : tasks) {
    const SweepState::Task& task = state.task(index);
    if (!task.finished || task.file.empty()) continue;
    const fs::path file = folder / task.file;
    const bool trusted = check == ResultCheck::size
                             ? hasSize(file, task.file_bytes)
                             : stampOf(file) == FileStamp{task.file_bytes, task.file_time};
    if (!trusted && !canBeRead(file)) state.forget(index);
  }
}

}  // namespace fissure
