#include "store/force_inputs.h"

#include <fmt/core.h>

#include "base/error.h"
#include "store/run_reader.h"

namespace fissure {

namespace {

const StoredQuantity& stored(const RunReader& run, const std::string& pipeline, const std::string& name) {
  if (const StoredQuantity* found = run.find("force_inputs/" + name)) return *found;
  throw InputError(inFile(run.file()), "run " + pipeline + " has no force_inputs/" + name +
                                           ", expected a run with record: {force_inputs: true}");
}

}  // namespace

ForceInputs readForceInputs(const std::filesystem::path& file, const std::string& pipeline) {
  const RunReader run(file, pipeline);
  const auto all = [&](const char* name) { return run.all(stored(run, pipeline, name)); };
  ForceInputs read;
  read.times_s = all("time");
  const StoredQuantity& deformation = stored(run, pipeline, "deformation");
  if (deformation.axes.size() == 2) read.laws = deformation.axes[1].labels;
  const std::vector<double> deformations_m = run.all(deformation), rates_m_s = all("deformation_rate"),
                            areas_m2 = all("area"), directions = all("direction");
  const std::size_t count = areas_m2.size(), laws = read.laws.size();
  std::size_t left = count;
  bool fits = directions.size() == 3 * count && deformations_m.size() == laws * count &&
              rates_m_s.size() == laws * count;
  for (const double size : all("row_size")) {
    fits = fits && size >= 0 && size <= static_cast<double>(left);
    if (!fits) break;
    read.row_sizes.push_back(static_cast<std::size_t>(size));
    left -= read.row_sizes.back();
  }
  if (!fits || left > 0 || read.row_sizes.size() != read.times_s.size())
    throw InputError(
        inFile(file),
        fmt::format("the force_inputs of run {} are damaged: their lengths do not fit together", pipeline));
  read.inputs.reserve(laws * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 direction = Vec3::Map(&directions[3 * i]);
    for (std::size_t law = 0; law < laws; ++law)
      read.inputs.push_back(
          {deformations_m[i * laws + law], rates_m_s[i * laws + law], areas_m2[i], direction});
  }
  return read;
}

}  // namespace fissure
