#include "store/part_reader.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/error.h"
#include "hdf5/group_builder.h"
#include "store/force_input_writer.h"
#include "store/format.h"

namespace fissure {

namespace {

using Lengths = std::map<std::string, hsize_t>;

// The committed length of each growing axis; the times all lie in the pipeline's own group.
Lengths committedLengths(hid_t group) {
  Lengths lengths;
  for (const char* axis : {"time", "snapshot_time", "frame_time"}) {
    if (h5::exists(group, axis)) lengths[axis] = committedTimes_s(h5::openDataset(group, axis)).size();
  }
  if (h5::exists(group, "force_inputs"))
    lengths["obs"] = observationCount(h5::openGroup(group, "force_inputs"), lengths["time"]);
  return lengths;
}

// Every dataset must be there as far as its times say; opening each also finds damaged ones.
void checkDatasets(hid_t group, const Lengths& lengths) {
  for (const std::string& name : h5::childNames(group)) {
    const h5::Id child = h5::openObject(group, name);
    if (h5::isGroup(child)) {
      checkDatasets(child, lengths);
      continue;
    }
    const std::vector<hsize_t> shape = h5::shapeOf(child);
    const std::vector<std::string> axes = dimensionNames(child);
    if (axes.size() != shape.size()) throw RunError("the axes of " + name + " are not named");
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto length = lengths.find(axes[i]);
      if (length != lengths.end() && shape[i] < length->second)
        throw RunError(name + " is shorter than its times");
    }
  }
}

void cut(hid_t dataset, const Lengths& lengths) {
  std::vector<hsize_t> shape = h5::shapeOf(dataset);
  const std::vector<std::string> axes = dimensionNames(dataset);
  const std::vector<hsize_t> before = shape;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (const auto length = lengths.find(axes[i]); length != lengths.end()) shape[i] = length->second;
  }
  if (shape != before) h5::check(H5Dset_extent(dataset, shape.data()), "cannot cut a dataset");
}

// Link by link: copying whole groups would order their links by name.
void copyContents(hid_t from, hid_t to, const Lengths& lengths, const h5::OutputFile& file) {
  for (const std::string& name : h5::childNames(from)) {
    const h5::Id child = h5::openObject(from, name);
    if (h5::isGroup(child)) {
      const h5::Id copy = h5::createGroup(to, name);
      for (const std::string& attribute : h5::attributeNames(child))
        h5::copyAttribute(child, copy, attribute);
      copyContents(child, copy, lengths, file);
      continue;
    }
    h5::check(H5Ocopy(from, name.c_str(), to, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "cannot copy dataset",
              name);
    file.checkWritten();
    cut(h5::openDataset(to, name), lengths);
  }
}

}  // namespace

PartReader::PartReader(const std::filesystem::path& path, const std::string& pipeline)
    : file_(h5::openToRead(path)) {
  if (h5::textAttribute(file_, "format") != part_format) throw RunError("not a part file");
  group_ = h5::openGroup(file_, "/pipelines/" + pipeline);
  checkDatasets(group_, committedLengths(group_));
}

std::vector<std::pair<std::string, std::string>> PartReader::provenance() const {
  std::vector<std::pair<std::string, std::string>> texts;
  const h5::Id group = h5::openGroup(file_, "provenance");
  for (const std::string& name : h5::attributeNames(group))
    texts.emplace_back(name, h5::textAttribute(group, name));
  return texts;
}

std::vector<double> PartReader::times_s() const {
  return committedTimes_s(h5::openDataset(group_, "time"));
}

void PartReader::copyTo(hid_t group, const h5::OutputFile& file) const {
  copyContents(group_, group, committedLengths(group_), file);
}

}  // namespace fissure
