#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "hdf5/h5.h"
#include "scenario/forces.h"
#include "scenario/pipelines.h"

namespace fissure {

/// Values of the root attributes `format` and `format_version`. Readers refuse newer versions.
inline constexpr const char* result_format = "fissure-result";
inline constexpr const char* part_format = "fissure-part";
inline constexpr const char* sweep_format = "fissure-sweep";
inline constexpr std::int32_t format_version = 1;

/// Sets the attributes pipeline, description, precision, status and status_detail of a run's group, in this
/// order.
void describePipeline(hid_t group, const PipelineSettings& pipeline, const RunStatus& status);

/// Sets the attributes of the `force` dataset: model, kind of deformation and coefficients of each law. The
/// coefficients' units have no valid UDUNITS form and are stored in words.
void describeForceLaws(hid_t force, const std::vector<ForceSettings>& laws);

/// The times of the committed rows of a growing axis: those up to the last row with a time. `time` is the
/// coordinate dataset of that axis.
std::vector<double> committedTimes_s(hid_t time);

}  // namespace fissure
