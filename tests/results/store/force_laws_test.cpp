// What a result says about each law of the table.
#include <gtest/gtest.h>
#include <hdf5.h>

#include "hdf5/output_file.h"
#include "sample_run.h"
#include "scenario/forces.h"
#include "store/format.h"

namespace fissure::force_laws_test {

namespace {

TEST(ForceLaws, AreStoredWithAllCoefficientsAndTheirUnits) {
  const ScratchFolder folder;
  for (std::size_t i = 0; i < forceLaws().size(); ++i) {
    const ForceLawEntry& entry = forceLaws()[i];
    for (const bool per_area : {false, true}) {
      SCOPED_TRACE(std::string(entry.name) + (per_area ? " per area" : ""));
      ForceSettings law{.name = "own", .model = static_cast<ForceModel>(i), .per_area = per_area};
      const auto file = h5::OutputFile::create(folder.path() / "laws.h5", H5F_ACC_TRUNC);
      describeForceLaws(file, {law});
      EXPECT_EQ(h5::textAttribute(file, "own_model"), entry.name);
      EXPECT_EQ(h5::textAttribute(file, "own_rate", "none") == "none",
                entry.find(CoefficientRole::damping) == nullptr);
      for (const LawCoefficient& of : entry.coefficients) {
        const auto stored = h5::attribute(file, "own_" + std::string(of.name));
        ASSERT_TRUE(stored.has_value()) << of.name;
        EXPECT_EQ(std::get<double>(*stored), law.coefficients.*of.member) << of.name;
        EXPECT_EQ(h5::textAttribute(file, "own_" + std::string(of.name) + "_units"),
                  per_area ? of.units_per_area : of.units);
      }
    }
  }
}

}  // namespace
}  // namespace fissure::force_laws_test
