#include "store/salvage.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "store/format.h"
#include "store/part_reader.h"
#include "store/result_file.h"

namespace fissure {

namespace {

/// Row 0 is the state before the first step.
std::string reached(const PartReader& part, const std::vector<double>& times_s) {
  const long long steps = part.expectedSteps();
  long long reached = part.stepsPerRow() * static_cast<long long>(times_s.size() - 1);
  if (steps > 0) reached = std::min(reached, steps);
  return fmt::format("up to step {}{} (t = {:g} s), what came after was not on the disk yet", reached,
                     steps > 0 ? fmt::format(" of {}", steps) : "", times_s.back());
}

}  // namespace

PartContent inspectPart(const std::filesystem::path& path) {
  const ResultInfo info = readResultInfo(path);
  const std::string name = path.string();
  if (info.format != part_format)
    throw InputError(inFile(name), "a result, expected the part file of one run");
  if (info.pipelines.size() != 1 || info.scenario_resolved.empty())
    throw InputError(inFile(name), "a part file without a run or its scenario, nothing can be salvaged");
  const PipelineResult& run = info.pipelines.front();
  PartContent content{run.name, info.scenario_resolved, run.status};
  try {
    const PartReader part(path, run.name);
    const std::vector<double> times_s = part.times_s();
    if (run.status.end != RunEnd::incomplete) return content;
    if (times_s.empty())
      throw InputError(inFile(name), "stopped before its first block was written, nothing to salvage");
    content.status = {RunEnd::salvaged, reached(part, times_s)};
  } catch (const RunError& error) {
    throw InputError(inFile(name), std::string("a damaged part file (") + error.what() + ")");
  }
  return content;
}

}  // namespace fissure
