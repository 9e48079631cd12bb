#include "base/record.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fissure::record_test {

namespace {

TEST(RecordLayout, PlacesSeriesOneAfterTheOther) {
  RecordLayout layout;
  layout.addAxis({"xyz", {"x", "y", "z"}});
  layout.addAxis({"law", {"hc", "linear"}});
  EXPECT_EQ(layout.add({.name = "time", .units = "s", .long_name = "time"}), 0u);
  EXPECT_EQ(layout.add({.name = "force", .units = "N", .long_name = "force", .axes = {"law", "xyz"}}), 1u);
  EXPECT_EQ(layout.add({.name = "depth", .units = "m", .long_name = "depth"}), 7u);
  EXPECT_EQ(layout.columns(), 8u);
  ASSERT_NE(layout.find("force"), nullptr);
  EXPECT_EQ(layout.find("force")->columns, 6u);
  EXPECT_EQ(layout.find("nothing"), nullptr);
}

TEST(RecordLayout, AnAxisMayBeDeclaredTwiceOnlyWithTheSameLabels) {
  RecordLayout layout;
  layout.addAxis({"tool", {"a"}});
  EXPECT_NO_THROW(layout.addAxis({"tool", {"a"}}));
  EXPECT_THROW(layout.addAxis({"tool", {"a", "b"}}), std::logic_error);
  EXPECT_EQ(layout.axes().size(), 1u);
}

TEST(RecordLayout, RefusesDuplicateSeriesAndUnknownAxes) {
  RecordLayout layout;
  layout.add({.name = "time", .units = "s", .long_name = "time"});
  EXPECT_THROW(layout.add({.name = "time", .units = "s", .long_name = "time"}), std::logic_error);
  EXPECT_THROW(layout.add({.name = "x", .units = "1", .long_name = "x", .axes = {"nowhere"}}),
               std::logic_error);
}

}  // namespace
}  // namespace fissure::record_test
