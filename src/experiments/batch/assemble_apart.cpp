#include "batch/assemble_apart.h"

#include <functional>
#include <string>

#include "base/error.h"
#include "process/apart.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

Allowance allowanceForAll(const std::vector<PartResult>& parts) {
  Allowance sum{.processor_s = 1, .stoppable = false};
  for (const PartResult& result : parts) {
    const Allowance part = result.part ? allowanceFor(*result.part) : Allowance{.processor_s = 1};
    sum.processor_s += part.processor_s;
    sum.memory_bytes += part.memory_bytes;
  }
  return sum;
}

/// `assemble` writes `output` from `parts`; nothing half written stays behind.
void writeApart(const fs::path& output, const std::vector<PartResult>& parts,
                const std::function<void()>& assemble) {
  try {
    doApart(assemble, allowanceForAll(parts));
  } catch (const LostApart& lost) {
    removeHalfWritten(output, lost.process());
    throw;
  }
}

void failFor(PartResult& result, const std::string& reason) {
  RunStatus& status = result.status;
  if (status.end == RunEnd::ok) status.end = RunEnd::failed;
  status.detail += (status.detail.empty() ? "" : "; ") + std::string("part file unreadable: ") + reason;
  result.part.reset();
}

}  // namespace

void assembleApart(const fs::path& output, const LoadedScenario& loaded, const Provenance& provenance,
                   std::vector<PartResult>& parts, const fs::path& scratch) {
  const auto assemble = [&](const fs::path& path, const std::vector<PartResult>& some) {
    writeApart(path, some, [&] { assembleResult(path, loaded, provenance, some); });
  };
  try {
    return assemble(output, parts);
  } catch (const LostApart&) {  // one of the parts is to blame, or several
  }
  for (PartResult& result : parts) {
    const fs::path alone = scratch / "alone.h5";
    try {
      if (result.part) assemble(alone, {result});
    } catch (const LostApart& lost) {
      failFor(result, lost.what());
    } catch (const RunError&) {  // no fault of the part's; the next attempt shows it too
    }
    std::error_code ignored;
    fs::remove(alone, ignored);
  }
  try {
    assemble(output, parts);
  } catch (const LostApart& lost) {
    throw RunError(output.string() + ": cannot be assembled: " + lost.what());
  }
}

void salvageApart(const fs::path& output, const LoadedScenario& loaded, const Provenance& provenance,
                  const PartResult& part) {
  try {
    writeApart(output, {part}, [&] { assembleSalvaged(output, loaded, provenance, part); });
  } catch (const LostApart& lost) {
    throw InputError(inFile(*part.part), std::string("a damaged part file (") + lost.what() + ")");
  }
}

}  // namespace fissure
