#include "base/run_status.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace fissure::run_status_test {

namespace {

struct Named {
  RunEnd end;
  std::string name;
};

// Files and tables hold these names: none may ever change.
TEST(RunEnds, HaveNamesThatAreReadBack) {
  const std::vector<Named> all = {
      {RunEnd::ok, "ok"},
      {RunEnd::non_finite, "non_finite"},
      {RunEnd::timeout, "timeout"},
      {RunEnd::crashed, "crashed"},
      {RunEnd::interrupted, "interrupted"},
      {RunEnd::failed, "failed"},
      {RunEnd::salvaged, "salvaged"},
      {RunEnd::incomplete, "incomplete"},
      {RunEnd::missing, "missing"},
  };
  for (const Named& named : all) {
    EXPECT_EQ(nameOf(named.end), named.name);
    EXPECT_EQ(runEndNamed(named.name), named.end);
  }
}

TEST(RunEnds, OtherNamesAreRefused) {
  for (const std::string name : {"", "OK", "ok ", "melted"}) EXPECT_THROW(runEndNamed(name), InputError);
  try {
    runEndNamed("melted");
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "the status \"melted\" of a run is unknown, expected one of ok, non_finite, timeout, crashed, "
        "interrupted, failed, salvaged, incomplete, missing: damaged, or written by a newer fissure");
  }
}

}  // namespace
}  // namespace fissure::run_status_test
