#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>

#include "base/error.h"
#include "salvaged.h"
#include "store/part_file.h"

namespace fissure::part_test {

namespace {

// A limit on the size of files stands for a full disk: writes beyond it fail. For every limit up to the size
// a whole part needs: either all is there, or each call from the first failed one on throws, and nothing is
// printed.
TEST(FullDisk, PartEitherWholeOrRunError) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(3000, true);
  const auto path = folder / "default.part";
  writeSamplePart(path, run, "default");
  const auto whole = std::filesystem::file_size(path);
  std::size_t failures = 0;
  for (rlim_t limit = 0; limit <= whole + 4096; limit += whole / 40) {
    const ChildResult child = runInChild([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limits{limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &limits);
      try {
        const auto part = openSamplePart(path, run, "default");
        try {
          appendSamples(*part, run);
          part->finish({RunEnd::ok, ""}, {{"steps", 3000LL}});
        } catch (const RunError&) {
          try {
            part->finish({RunEnd::ok, ""}, {});
          } catch (const RunError&) {
            return 42;
          }
          return 43;
        }
      } catch (const RunError&) {
        return 42;
      }
      return 0;
    });
    ASSERT_TRUE(child.exited) << "limit " << limit << ", signal " << child.code;
    EXPECT_EQ(child.errors, "") << "limit " << limit;
    if (child.code == 0) {
      EXPECT_EQ(nameOf(statusOf(path).end), "ok");
      EXPECT_EQ(salvagedRows(folder, run, path), 3000U) << "limit " << limit;
    } else {
      EXPECT_EQ(child.code, 42) << "limit " << limit;
      ++failures;
    }
  }
  EXPECT_GT(failures, 30U) << "the limit did not bite";
}

TEST(FullDisk, ResultIsWholeOrTheOldOneStays) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(3000, true);
  const auto part = folder / "default.part";
  writeSamplePart(part, run, "default");
  std::filesystem::create_directory(folder / "out");
  const auto path = folder / "out" / "sample.h5";
  const std::vector<PartResult> parts = {{run.scenario.pipelines.at(1), part, {RunEnd::ok, ""}}};
  assembleResult(path, loadedSample(run), {{"version", "old"}}, parts);
  const auto whole = std::filesystem::file_size(path);
  std::size_t failures = 0;
  for (rlim_t limit = 0; limit <= whole + 4096; limit += whole / 60) {
    const ChildResult child = runInChild([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limits{limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &limits);
      try {
        assembleResult(path, loadedSample(run), {{"version", "new"}}, parts);
      } catch (const RunError& error) {
        return std::string(error.what()).find("sample.h5") == std::string::npos ? 43 : 42;
      }
      return 0;
    });
    ASSERT_TRUE(child.exited) << "limit " << limit << ", signal " << child.code;
    EXPECT_EQ(child.errors, "") << "limit " << limit;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1) << "limit " << limit;
    const ResultInfo info = readResultInfo(path);
    EXPECT_TRUE(info.complete);
    EXPECT_EQ(info.provenance.at(0).second, child.code == 0 ? "new" : "old") << "limit " << limit;
    EXPECT_EQ(readSeries(path, "/pipelines/default/frames").values,
              readSeries(part, "/pipelines/default/frames").values);
    EXPECT_EQ(readSeries(path, "/pipelines/default/force").values,
              readSeries(part, "/pipelines/default/force").values);
    failures += child.code == 42 ? 1 : 0;
    if (child.code == 0) assembleResult(path, loadedSample(run), {{"version", "old"}}, parts);
  }
  EXPECT_GT(failures, 50U) << "the limit did not bite";
}

// A real full file system, where mounting one is allowed: a tmpfs that holds a part but not the result beside
// it.
TEST(FullDisk, FullFileSystemIsSaidInOneLine) {
  const ScratchFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) {
    GTEST_SKIP() << "may not mount a small file system here";
  }
  const SampleRun run = makeSampleRun(3000, false);
  const ChildResult child = runInChild([&] {
    const auto part = openSamplePart(folder / "default.part", run, "default");
    appendSamples(*part, run);
    part->finish({RunEnd::ok, ""}, {});
    return 0;
  });
  ::umount(folder.path().c_str());
  EXPECT_EQ(child.code, 3);
  EXPECT_NE(child.errors.find("default.part: "), std::string::npos) << stringOf(child);
  EXPECT_NE(child.errors.find("No space left on device"), std::string::npos) << stringOf(child);
  EXPECT_EQ(child.errors.find('\n'), std::string::npos) << stringOf(child);
}

}  // namespace

}  // namespace fissure::part_test
