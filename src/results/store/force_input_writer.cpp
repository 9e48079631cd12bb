#include "store/force_input_writer.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/error.h"

namespace fissure {

namespace {

constexpr std::size_t chunk_observations = 1024;
constexpr std::size_t buffered_observations = 8 * chunk_observations;

const Dimension observations{"obs", chunk_observations, true};

GroupBuilder makeGroup(const GroupBuilder& parent, const std::vector<std::string>& laws) {
  GroupBuilder group(parent.id(), "force_inputs");
  group.addLabels("law", laws);
  group.addLabels("xyz", {"x", "y", "z"});
  return group;
}

GrowingDataset makeRowSizes(GroupBuilder& group, std::size_t chunk_rows) {
  GrowingDataset made = group.addGrowing({"row_size",
                                          "1",
                                          "colliding triangles of each step, one observation each",
                                          ValueType::count,
                                          {{"time", chunk_rows, true}}});
  h5::setAttribute(h5::openDataset(group.id(), "row_size"), "sample_dimension", "obs");
  return made;
}

}  // namespace

ForceInputWriter::ForceInputWriter(GroupBuilder& group, const std::vector<std::string>& laws,
                                   std::size_t chunk_rows)
    : laws_(laws.size()),
      group_(makeGroup(group, laws)),
      time_data_(
          group_.addGrowing({"time", "s", "simulated time", ValueType::real, {{"time", chunk_rows, true}}})),
      row_size_data_(makeRowSizes(group_, chunk_rows)),
      observation_data_(group_.addGrowing({"obs",
                                           "1",
                                           "running number: of a step as many as its row_size",
                                           ValueType::count,
                                           {observations}})),
      triangle_data_(group_.addGrowing(
          {"triangle", "1", "of all bodies, as in faces", ValueType::count, {observations}})),
      deformation_data_(group_.addGrowing({"deformation",
                                           "m",
                                           "x of the triangle, by the law's own kind of deformation",
                                           ValueType::real,
                                           {observations, {"law", laws.size()}}})),
      rate_data_(group_.addGrowing({"deformation_rate",
                                    "m s-1",
                                    "x' of the triangle, by the law's own kind of rate",
                                    ValueType::real,
                                    {observations, {"law", laws.size()}}})),
      area_data_(
          group_.addGrowing({"area", "m2", "of the triangle at rest", ValueType::real, {observations}})),
      direction_data_(group_.addGrowing({"direction",
                                         "1",
                                         "force on the tools together, one newton of the law",
                                         ValueType::real,
                                         {observations, {"xyz", 3}}})) {}

bool ForceInputWriter::append(const State& state) {
  if (state.law_inputs.size() != state.colliding_triangles.size() * laws_)
    throw std::logic_error("the inputs of the force laws are not one a colliding triangle and law");
  times_s_.push_back(state.time_s);
  row_sizes_.push_back(static_cast<std::int64_t>(state.colliding_triangles.size()));
  for (std::size_t i = 0; i < state.colliding_triangles.size(); ++i) {
    triangles_.push_back(state.colliding_triangles[i]);
    const LawInput& first = state.law_inputs[i * laws_];
    areas_m2_.push_back(first.area_m2);
    directions_.insert(directions_.end(), first.direction.data(), first.direction.data() + 3);
    for (std::size_t law = 0; law < laws_; ++law) {
      deformations_m_.push_back(state.law_inputs[i * laws_ + law].deformation_m);
      rates_m_s_.push_back(state.law_inputs[i * laws_ + law].rate_m_s);
    }
  }
  return triangles_.size() >= buffered_observations;
}

void ForceInputWriter::writeData() {
  if (times_s_.empty()) return;
  if (const hsize_t count = triangles_.size(); count > 0) {
    observations_.resize(count);
    std::iota(observations_.begin(), observations_.end(), written_);
    written_ += static_cast<std::int64_t>(count);
    observation_data_.append(observations_.data(), count);
    triangle_data_.append(triangles_.data(), count);
    deformation_data_.append(deformations_m_.data(), count);
    rate_data_.append(rates_m_s_.data(), count);
    area_data_.append(areas_m2_.data(), count);
    direction_data_.append(directions_.data(), count);
  }
  row_size_data_.append(row_sizes_.data(), row_sizes_.size());
  time_data_.append(times_s_.data(), times_s_.size());
  for (std::vector<double>* values : {&times_s_, &deformations_m_, &rates_m_s_, &areas_m2_, &directions_})
    values->clear();
  row_sizes_.clear();
  triangles_.clear();
}

hsize_t observationCount(hid_t force_inputs, hsize_t rows) {
  const h5::Id dataset = h5::openDataset(force_inputs, "row_size");
  h5::requireStored(dataset);
  std::vector<std::int64_t> sizes(h5::shapeOf(dataset).front());
  if (sizes.size() < rows) throw RunError("force_inputs/row_size is shorter than its times");
  h5::check(H5Dread(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, sizes.data()), "cannot read",
            "row_size");
  const auto end = sizes.begin() + static_cast<std::ptrdiff_t>(rows);
  if (std::any_of(sizes.begin(), end, [](std::int64_t size) { return size < 0; }))
    throw RunError("force_inputs/row_size is negative");
  return static_cast<hsize_t>(std::accumulate(sizes.begin(), end, std::int64_t{0}));
}

}  // namespace fissure
