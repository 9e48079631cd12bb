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

void describeForceLaws(hid_t force, const std::vector<ForceSettings>& laws) {
  for (const ForceSettings& law : laws) {
    h5::setAttribute(force, law.name + "_model", law.model);
    h5::setAttribute(force, law.name + "_k", law.k);
    if (law.model != "hunt_crossley") {
      h5::setAttribute(force, law.name + "_k_units", std::string("newton per metre"));
      continue;
    }
    h5::setAttribute(force, law.name + "_k_units", std::string("newton per metre to the power n"));
    h5::setAttribute(force, law.name + "_lambda", law.lambda);
    h5::setAttribute(force, law.name + "_lambda_units",
                     std::string("newton second per metre to the power n + 1"));
    h5::setAttribute(force, law.name + "_n", law.n);
    h5::setAttribute(force, law.name + "_rate", law.rate);
  }
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
