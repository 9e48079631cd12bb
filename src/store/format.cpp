#include "store/format.h"

#include <cmath>

#include "scenario/catalog.h"

namespace fissure {

void describePipeline(hid_t group, const PipelineSettings& pipeline, const RunStatus& status) {
  std::string description;
  for (const CatalogEntry& entry : catalog().pipelines) {
    if (entry.name == pipeline.pipeline) description = entry.description;
  }
  h5::setAttribute(group, "pipeline", pipeline.pipeline);
  h5::setAttribute(group, "description", description);
  h5::setAttribute(group, "precision", pipeline.precision);
  h5::setAttribute(group, "status", status.status);
  h5::setAttribute(group, "status_detail", status.detail);
}

hsize_t committedLength(hid_t time) {
  std::vector<double> times_s(h5::shapeOf(time).front());
  h5::check(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times_s.data()),
            "cannot read the times");
  // A block whose length was on disk before its values reads as missing.
  while (!times_s.empty() && std::isnan(times_s.back())) times_s.pop_back();
  return times_s.size();
}

}  // namespace fissure
