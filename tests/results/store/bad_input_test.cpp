#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/error.h"
#include "sample_run.h"
#include "store/read_series.h"
#include "store/result_file.h"
#include "store/salvage.h"

namespace fissure::bad_input_test {

namespace {

// The message of the InputError that reading `path` brings, without the path it starts with.
std::string complaintAbout(const std::filesystem::path& path) {
  try {
    readResultInfo(path);
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::string start = path.string() + ": ";
    EXPECT_EQ(message.substr(0, start.size()), start);
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
    return message.substr(std::min(start.size(), message.size()));
  }
  return "nothing";
}

void expectStart(const std::string& message, const std::string& start) {
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
}

std::filesystem::path writeResult(const ScratchFolder& folder) {
  const SampleRun run = makeSampleRun(50, true);
  const auto part = folder / "default.part";
  writeSamplePart(part, run, "default");
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), {}, {{run.scenario.pipelines.at(1), part, {RunEnd::ok, ""}}});
  return path;
}

// Changes a file as somebody else's program would.
void withH5py(const std::filesystem::path& path, const std::string& mode, const std::string& statement) {
  const std::string program =
      "import h5py; f = h5py.File('" + path.string() + "', '" + mode + "'); " + statement;
  ASSERT_EQ(std::system(("/usr/bin/python3 -B -c \"" + program + "\"").c_str()), 0);
}

TEST(BadInput, MissingFileAndFolder) {
  const ScratchFolder folder;
  EXPECT_EQ(complaintAbout(folder / "none.h5"), "no such file, expected a fissure result");
  EXPECT_EQ(complaintAbout(folder.path()), "is a folder, expected a fissure result");
}

TEST(BadInput, NoHdf5File) {
  const ScratchFolder folder;
  std::ofstream(folder / "notes.h5") << "not a result at all\n";
  expectStart(complaintAbout(folder / "notes.h5"), "not an HDF5 file");
  std::ofstream(folder / "empty.h5").flush();
  expectStart(complaintAbout(folder / "empty.h5"), "not an HDF5 file");
}

TEST(BadInput, OtherHdf5File) {
  const ScratchFolder folder;
  const auto path = folder / "other.h5";
  withH5py(path, "w", "f['time'] = [1.0, 2.0]");
  expectStart(complaintAbout(path), "an HDF5 file, but no fissure result");
}

TEST(BadInput, NewerFormatVersion) {
  const ScratchFolder folder;
  const auto path = writeResult(folder);
  EXPECT_EQ(complaintAbout(path), "nothing");
  withH5py(path, "a", "f.attrs.modify('format_version', 2)");
  EXPECT_EQ(complaintAbout(path), "format_version 2, expected at most 1: written by a newer fissure");
}

TEST(BadInput, UnknownStatus) {
  const ScratchFolder folder;
  const std::string unknown = "the status \"melted\" of a run is unknown, expected one of ok, non_finite, ";
  const auto path = writeResult(folder);
  withH5py(path, "a", "f['pipelines/default'].attrs['status'] = 'melted'");
  expectStart(complaintAbout(path), unknown);
  withH5py(path, "a", "del f['pipelines/default'].attrs['status']");
  expectStart(complaintAbout(path), "the status \"\" of a run is unknown");
  const auto part = folder / "default.part";
  withH5py(part, "a", "f['pipelines/default'].attrs['status'] = 'melted'");
  expectStart(complaintAbout(part), unknown);
  EXPECT_THROW(inspectPart(part), InputError) << "it is not known whether there is anything to salvage";
}

// A few hundred bytes claim 2^28 texts, of which none is stored: nothing is made for them.
TEST(BadInput, MoreTextsThanAreStored) {
  const ScratchFolder folder;
  const auto path = writeResult(folder);
  withH5py(path, "a",
           "del f['provenance/scenario_resolved']; f['provenance'].create_dataset('scenario_resolved', "
           "(2**28,), h5py.string_dtype(), chunks=(1024,))");
  expectStart(complaintAbout(path), "a damaged or truncated HDF5 file (a dataset states ");
  withH5py(path, "a",
           "del f['provenance/scenario_resolved']; f['provenance'].create_dataset('scenario_resolved', "
           "(2**22,), h5py.string_dtype(), chunks=(1024,))");
  expectStart(complaintAbout(path), "a damaged or truncated HDF5 file (a dataset states ");
}

TEST(BadInput, MoreNumbersThanAreStored) {
  const ScratchFolder folder;
  const auto path = folder / "a.h5";
  withH5py(path, "w",
           "f.create_dataset('none', (2**33,), chunks=(1024,)); f.create_dataset('few', (2**23,), "
           "chunks=(1024,)); "
           "f['few'][5] = 1; "
           "f.create_dataset('ones', (20000000,), 'u1', chunks=(1000000,), compression='gzip', fillvalue=0); "
           "f['ones'][:] = 1");
  EXPECT_THROW(readSeries(path, "none"), InputError);
  EXPECT_THROW(readSeries(path, "few"), InputError);
  EXPECT_EQ(readSeries(path, "ones").values.size(), 20000000u) << "well compressed";
}

// Cut anywhere, a result is refused, never half read.
TEST(BadInput, TruncatedAnywhere) {
  const ScratchFolder folder;
  const auto path = writeResult(folder);
  const auto whole = std::filesystem::file_size(path);
  for (auto size = whole - 1; size > whole / 50; size -= whole / 50) {
    std::filesystem::resize_file(path, size);
    expectStart(complaintAbout(path), "a damaged or truncated HDF5 file");
  }
}

}  // namespace
}  // namespace fissure::bad_input_test
