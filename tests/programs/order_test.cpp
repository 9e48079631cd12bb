// Orders that the front gives its workers.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"
#include "task/task_order.h"

namespace fissure::programs::order_test {
namespace {

namespace fs = std::filesystem;

TEST(Order, MayBeLargerThanAnyFileOfAUser) {
  const Folder folder;
  const TaskOrder order{.name = "many laws",
                        .scenario = pressScenario("[{pipeline: fukuhara}]", "0.01"),
                        .directory = folder.path(),
                        .pipeline = "fukuhara"};
  folder.write("small.order", orderText(order));
  folder.write("large.order", orderText(order) + std::string(std::size_t{65} << 20, ' '));
  const fs::path engine = fs::path(fissureProgram()).parent_path() / "fissure-engine-f64";
  for (const std::string name : {"small", "large"}) {
    const Outcome done = runTool(folder, {engine, "--order", name + ".order", "--record", name + ".record"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(fs::exists(folder / (name + ".record"))) << name;
  }
}

}  // namespace
}  // namespace fissure::programs::order_test
