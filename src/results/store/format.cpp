#include "store/format.h"

#include <cmath>

#include "scenario/catalog.h"

namespace fissure {

void describePipeline(hid_t group, const PipelineSettings& pipeline, const RunStatus& status) {
  h5::setAttribute(group, "pipeline", std::string(pipeline.traits().name));
  h5::setAttribute(group, "description", std::string(pipeline.traits().description));
  h5::setAttribute(group, "precision", nameIn(catalog().precisions, pipeline.precision));
  h5::setAttribute(group, "status", status.status);
  h5::setAttribute(group, "status_detail", status.detail);
}

void describeForceLaws(hid_t force, const std::vector<ForceSettings>& laws) {
  for (const ForceSettings& law : laws) {
    const auto set = [&](const char* name, const auto& value) {
      h5::setAttribute(force, law.name + "_" + name, value);
    };
    const auto setUnits = [&](const char* name, const char* plain, const char* per_area) {
      set(name, std::string(law.per_area ? per_area : plain));
    };
    set("model", law.model);
    set("deformation", law.deformation);
    set("per_area", std::string(law.per_area ? "true" : "false"));
    set("k", law.k);
    if (law.model == "hunt_crossley") {
      setUnits("k_units", "newton per metre to the power n", "newton per metre to the power n + 2");
      set("lambda", law.lambda);
      setUnits("lambda_units", "newton second per metre to the power n + 1",
               "newton second per metre to the power n + 3");
      set("n", law.n);
    } else {
      setUnits("k_units", "newton per metre", "newton per cubic metre");
    }
    if (law.model == "kelvin_voigt") {
      set("c", law.c);
      setUnits("c_units", "newton second per metre", "newton second per cubic metre");
    }
    if (law.model != "linear_elastic") set("rate", law.rate);
  }
}

std::vector<double> committedTimes_s(hid_t time) {
  std::vector<double> times_s(h5::shapeOf(time).front());
  h5::check(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times_s.data()),
            "cannot read the times");
  // A block whose length was on disk before its values reads as missing.
  while (!times_s.empty() && std::isnan(times_s.back())) times_s.pop_back();
  return times_s;
}

}  // namespace fissure
