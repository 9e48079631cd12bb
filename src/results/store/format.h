#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "hdf5/h5.h"
#include "scenario/forces.h"
#include "scenario/pipelines.h"

namespace fissure {

/// What opens a file of ours; a reader refuses newer versions.
inline constexpr const char* result_format = "fissure-result";
inline constexpr const char* part_format = "fissure-part";
inline constexpr const char* sweep_format = "fissure-sweep";
inline constexpr std::int32_t format_version = 1;

/// Attributes pipeline, description, precision, status and status_detail of a pipeline's group, in this
/// order.
void describePipeline(hid_t group, const PipelineSettings& pipeline, const RunStatus& status);

/// Attributes of the `force` dataset: model, kind of deformation and coefficients of each law. Their units
/// have no legal UDUNITS form and stand beside them in words.
void describeForceLaws(hid_t force, const std::vector<ForceSettings>& laws);

/// The times of the rows of a growing axis that count as written: those up to the last that has a time.
/// `time` is a coordinate.
std::vector<double> committedTimes_s(hid_t time);

}  // namespace fissure
