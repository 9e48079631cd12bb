#include "batch/engine_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "base/error.h"

namespace fissure::engine_program_test {

namespace {

namespace fs = std::filesystem;

TEST(EngineProgram, IsFoundInTheNamedFolder) {
  const fs::path folder = fs::path(testing::TempDir()) / ("engines-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path program = folder / "fissure-engine-f64";
  std::ofstream(program) << "#!/bin/sh\n";
  ::setenv("FISSURE_ENGINE_DIR", folder.c_str(), 1);
  EXPECT_THROW(engineProgram("f64"), RunError) << "not executable";
  fs::permissions(program, fs::perms::owner_all);
  EXPECT_EQ(engineProgram("f64"), program);
  EXPECT_THROW(engineProgram("f32"), RunError);

  PipelineSettings pipeline;
  pipeline.name = "tuned";
  pipeline.time_limit_s = 7;
  const WorkerTask task = engineTask({"resolved.yaml", "configs", pipeline, "tuned.part"});
  EXPECT_EQ(task.program, program);
  EXPECT_EQ(task.arguments, (std::vector<std::string>{"--scenario", "resolved.yaml", "--directory", "configs",
                                                      "--pipeline", "tuned", "--part", "tuned.part"}));
  EXPECT_EQ(task.time_limit_s, 7);
  ::unsetenv("FISSURE_ENGINE_DIR");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace fissure::engine_program_test
