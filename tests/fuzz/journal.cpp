#include "sweep/journal.h"

#include <fmt/core.h>

#include <memory>

#include "base/hash.h"
#include "sweep/sweep_state.h"
#include "target.h"
#include "task/task_record.h"

namespace fissure::fuzz {

namespace {

namespace fs = std::filesystem;

/// The plan that journals belong to, one of the seeds.
const SweepPlan& plan() {
  static const auto planned = [] {
    const fs::path folder = house() / "tests/fuzz/seeds/journal_plan";
    return std::make_unique<SweepPlan>(readManifest(folder), folder);
  }();
  return *planned;
}

/// A record that was read is written and read as the same one.
void takeRecord(const std::string& bytes) {
  TaskRecord record;
  if (!accepts("", Refusal::own_file, [&] { record = decodeRecord(bytes); })) return;
  const std::string written = encodeRecord(record);
  require(encodeRecord(decodeRecord(written)) == written, "a record reads back");
  TaskNumbers numbers;
  if (!accepts("", Refusal::own_file, [&] { numbers = decodeNumbers(record.numbers); })) return;
  require(numbers.values.size() == numbers.rows * numbers.names.size(), "rows have all their values");
  const std::string again = encodeNumbers(numbers);
  require(encodeNumbers(decodeNumbers(again)) == again, "numbers read back");
}

void readJournal(const std::string& bytes) {
  const fs::path file = put("sweep/journals/fuzzed.journal", bytes);
  const fs::path folder = file.parent_path().parent_path();
  Journals journals(file.parent_path());
  std::size_t end = 0;
  journals.each([&](const std::string& record, const JournalPlace& place) {
    constexpr std::size_t head = 36;
    require(journals.read(place, 0, record.size()) == record, "a record is read at its place");
    end = static_cast<std::size_t>(place.offset) + head + record.size();
    takeRecord(record);
  });
  require(journals.damaged().empty() == (end == bytes.size()), "bytes behind the last record are damage");
  accepts(file, Refusal::own_file, [&] {
    const SweepState state(plan(), folder);
    for (std::size_t i = 0; i < plan().tasks().size(); ++i) {
      if (!state.task(i).place) continue;
      const SweepState::Head found = state.head(i);
      if (!found.numbers.names.empty() && found.numbers.rows > 0)
        state.numbers(i, found, found.numbers.values_at, found.numbers.names.size());
    }
    state.unfinished();
  });
}

}  // namespace

/// The bytes as a journal, and as a whole record of one: no change of a byte passes its checksum.
void takeJournal(const std::string& bytes) {
  readJournal(bytes);
  readJournal(fmt::format("FSR1{:016x}", bytes.size()) + fnv1a64(bytes) + bytes);
}

}  // namespace fissure::fuzz
