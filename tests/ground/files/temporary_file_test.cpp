#include "files/temporary_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "files/write_file.h"

namespace fissure::temporary_file_test {

namespace {

namespace fs = std::filesystem;

/// The number of a process that has ended.
int deadProcess() {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(0);
  ::waitpid(process, nullptr, 0);
  return process;
}

TEST(ReplacedFiles, LoseWhatKilledProcessesHaveLeftAndNothingElse) {
  std::string name = (fs::temp_directory_path() / "fissure_replaced_XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  const fs::path file = folder / "cells.csv";
  const int dead = deadProcess();
  const std::set<fs::path> stay = {TemporaryFile::nameFor(file, ::getppid(), 0), folder / "cells.csv.x.0.tmp",
                                   TemporaryFile::nameFor(folder / "other.csv", dead, 0),
                                   folder / "cells.csv.tmp"};
  const std::set<fs::path> go = {TemporaryFile::nameFor(file, dead, 0),
                                 TemporaryFile::nameFor(file, dead, 7)};
  for (const std::set<fs::path>& some : {stay, go})
    for (const fs::path& left : some) std::ofstream(left).flush();
  replaceFile(file, "text\n");
  std::set<fs::path> found, expected = stay;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path());
  expected.insert(file);
  EXPECT_EQ(found, expected);
  fs::remove_all(folder);
}

}  // namespace

}  // namespace fissure::temporary_file_test
