#include "store/format.h"

#include <cmath>

#include "scenario/catalog.h"

namespace fissure {

void describePipeline(hid_t group, const PipelineSettings& pipeline, const RunStatus& status) {
  h5::setAttribute(group, "pipeline", std::string(pipeline.traits().name));
  h5::setAttribute(group, "description", std::string(pipeline.traits().description));
  h5::setAttribute(group, "precision", nameIn(catalog().precisions, pipeline.precision));
  h5::setAttribute(group, "status", nameOf(status.end));
  h5::setAttribute(group, "status_detail", status.detail);
}

void describeForceLaws(hid_t force, const std::vector<ForceSettings>& laws) {
  for (const ForceSettings& law : laws) {
    const auto set = [&](const std::string& name, const auto& value) {
      h5::setAttribute(force, law.name + "_" + name, value);
    };
    const ForceLawEntry& entry = entryOf(law.model);
    set("model", std::string(entry.name));
    set("deformation", nameIn(catalog().deformations, law.deformation));
    set("per_area", std::string(law.per_area ? "true" : "false"));
    for (const LawCoefficient& coefficient : entry.coefficients) {
      const std::string name(coefficient.name);
      set(name, law.coefficients.*coefficient.member);
      const std::string units(law.per_area ? coefficient.units_per_area : coefficient.units);
      if (!units.empty()) set(name + "_units", units);
    }
    if (entry.find(CoefficientRole::damping)) set("rate", nameIn(catalog().rates, law.rate));
  }
}

std::vector<double> committedTimes_s(hid_t time) {
  h5::requireStored(time);
  std::vector<double> times_s(h5::shapeOf(time).front());
  h5::check(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times_s.data()),
            "cannot read the times");
  // A block whose length was on disk before its values reads as missing.
  while (!times_s.empty() && std::isnan(times_s.back())) times_s.pop_back();
  return times_s;
}

}  // namespace fissure
