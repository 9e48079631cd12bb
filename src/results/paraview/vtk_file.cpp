#include "paraview/vtk_file.h"

#include <fmt/core.h>

#include <array>
#include <numeric>

namespace fissure {

namespace {

const char* const doing = "cannot write the VTK dataset";

using Numbers = std::vector<std::int64_t>;

h5::Id spaceOf(const std::vector<hsize_t>& shape) {
  return h5::Id(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, doing);
}

h5::Id create(hid_t group, const std::string& name, hid_t type, hid_t space, hid_t creation = H5P_DEFAULT) {
  return h5::Id(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose,
                doing, name);
}

void writeNumbers(hid_t group, const std::string& name, const Numbers& numbers, hsize_t columns = 1) {
  const hsize_t rows = numbers.size() / columns;
  const h5::Id space = columns == 1 ? spaceOf({rows}) : spaceOf({rows, columns});
  const h5::Id dataset = create(group, name, H5T_NATIVE_INT64, space);
  h5::check(H5Dwrite(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), doing, name);
}

// The reader compares every byte of the type's name, so there is no NUL behind it.
void setType(hid_t group) {
  const std::string value = "PolyData";
  const h5::Id type(H5Tcopy(H5T_C_S1), H5Tclose, doing);
  h5::check(H5Tset_size(type, value.size()), doing);
  h5::check(H5Tset_strpad(type, H5T_STR_NULLPAD), doing);
  const h5::Id space(H5Screate(H5S_SCALAR), H5Sclose, doing);
  const h5::Id attribute(H5Acreate2(group, "Type", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, doing);
  h5::check(H5Awrite(attribute, type, value.data()), doing);
}

void setVersion(hid_t group) {
  const std::array<std::int64_t, 2> version = {2, 0};
  const h5::Id space = spaceOf({version.size()});
  const h5::Id attribute(H5Acreate2(group, "Version", H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, doing);
  h5::check(H5Awrite(attribute, H5T_NATIVE_INT64, version.data()), doing);
}

void writeCells(hid_t root, const std::string& name, const Numbers& connectivity, std::size_t corners) {
  const h5::Id group = h5::createGroup(root, name);
  const auto ids = static_cast<std::int64_t>(connectivity.size());
  Numbers offsets = {0};
  while (offsets.back() < ids) offsets.push_back(offsets.back() + static_cast<std::int64_t>(corners));
  writeNumbers(group, "NumberOfCells", {static_cast<std::int64_t>(offsets.size()) - 1});
  writeNumbers(group, "NumberOfConnectivityIds", {ids});
  writeNumbers(group, "Connectivity", connectivity);
  writeNumbers(group, "Offsets", offsets);
}

// A reader wants all four kinds of cells, those without any cell too.
void writeTopology(hid_t root, const MovingMesh& mesh) {
  Numbers points;
  if (mesh.corners.empty()) {
    points.resize(mesh.points);
    std::iota(points.begin(), points.end(), std::int64_t{0});
  }
  writeNumbers(root, "NumberOfPoints", {static_cast<std::int64_t>(mesh.points)});
  writeCells(root, "Vertices", points, 1);
  writeCells(root, "Lines", {}, 2);
  writeCells(root, "Polygons", mesh.corners, 3);
  writeCells(root, "Strips", {}, 3);
}

/// Where each step's points begin in a dataset that holds them step by step.
Numbers beginnings(std::size_t steps, std::size_t points) {
  Numbers first(steps);
  for (std::size_t step = 0; step < steps; ++step) first[step] = static_cast<std::int64_t>(step * points);
  return first;
}

// The one part and its cells serve all steps: counts are stored once, and their offsets are 0.
void writeSteps(hid_t root, const MovingMesh& mesh, const std::vector<double>& times_s) {
  constexpr hsize_t kinds_of_cells = 4;
  const h5::Id steps = h5::createGroup(root, "Steps");
  const std::size_t count = times_s.size();
  h5::setAttribute(steps, "NSteps", static_cast<std::int64_t>(count));
  const h5::Id space = spaceOf({count});
  const h5::Id values = create(steps, "Values", H5T_NATIVE_DOUBLE, space);
  h5::check(H5Dwrite(values, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times_s.data()), doing);
  writeNumbers(steps, "NumberOfParts", Numbers(count, 1));
  writeNumbers(steps, "PartOffsets", Numbers(count, 0));
  writeNumbers(steps, "PointOffsets", beginnings(count, mesh.points));
  writeNumbers(steps, "CellOffsets", Numbers(count * kinds_of_cells, 0), kinds_of_cells);
  writeNumbers(steps, "ConnectivityIdOffsets", Numbers(count * kinds_of_cells, 0), kinds_of_cells);
  const h5::Id offsets = h5::createGroup(steps, "PointDataOffsets");
  for (const PointArray& array : mesh.arrays)
    writeNumbers(offsets, array.name, array.moves ? beginnings(count, mesh.points) : Numbers(count, 0));
}

hid_t typeOf(const PointArray& array, hid_t real) {
  if (array.type == ValueType::real) return real;
  return array.type == ValueType::flag ? H5T_NATIVE_UINT8 : H5T_NATIVE_INT64;
}

std::vector<hsize_t> shapeFor(const PointArray& array, hsize_t points) {
  return array.components == 1 ? std::vector<hsize_t>{points}
                               : std::vector<hsize_t>{points, array.components};
}

/// Selects the points of one step in a dataset that holds them step by step.
h5::Id selectStep(const PointArray& array, std::size_t points, std::size_t steps, std::size_t step) {
  h5::Id all = spaceOf(shapeFor(array, steps * points));
  const std::vector<hsize_t> size = shapeFor(array, points);
  std::vector<hsize_t> start(size.size(), 0);
  start[0] = step * points;
  h5::check(H5Sselect_hyperslab(all, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), doing);
  return all;
}

/// `path`: the array's dataset in the same file.
void addView(hid_t group, const PointArray& array, const std::string& path, hid_t type, hid_t part,
             std::size_t points) {
  const h5::Id own = spaceOf(shapeFor(array, points));
  const h5::Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, doing);
  // "." is this very file, whatever it is called.
  h5::check(H5Pset_virtual(creation, own, ".", path.c_str(), part), doing, array.name);
  create(group, array.name, type, own, creation);
}

/// All steps of an array in `group`, whose name is `path`, and views of them when it moves.
void writeArray(hid_t group, const std::string& path, const PointArray& array, hid_t real,
                const std::vector<h5::Id>& snapshots, std::size_t points) {
  const std::size_t steps = array.moves ? snapshots.size() : 1;
  const hid_t type = typeOf(array, real);
  const h5::Id space = spaceOf(shapeFor(array, steps * points));
  const h5::Id dataset = create(group, array.name, type, space);
  const h5::Id memory = spaceOf(shapeFor(array, points));
  for (std::size_t step = 0; step < steps; ++step) {
    const h5::Id part = selectStep(array, points, steps, step);
    const std::vector<double> values = array.values(step);
    h5::check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, memory, part, H5P_DEFAULT, values.data()), doing,
              array.name);
    if (array.moves) addView(snapshots[step], array, path + array.name, type, part, points);
  }
}

}  // namespace

std::string snapshotGroup(std::size_t snapshot) {
  return fmt::format("snapshots/{:06}", snapshot);
}

void writeVtkFile(hid_t file, const MovingMesh& mesh, const std::vector<double>& times_s) {
  const h5::Id root = h5::createGroup(file, "VTKHDF");
  setVersion(root);
  setType(root);
  writeTopology(root, mesh);
  writeSteps(root, mesh, times_s);
  const h5::Id all = h5::createGroup(file, "snapshots");
  std::vector<h5::Id> snapshots;
  for (std::size_t i = 0; i < times_s.size(); ++i)
    snapshots.push_back(h5::createGroup(file, snapshotGroup(i)));
  writeArray(root, "/VTKHDF/", mesh.positions_m, H5T_NATIVE_DOUBLE, snapshots, mesh.points);
  const h5::Id point_data = h5::createGroup(root, "PointData");
  for (const PointArray& array : mesh.arrays)
    writeArray(point_data, vtk_point_data, array, H5T_NATIVE_FLOAT, snapshots, mesh.points);
}

}  // namespace fissure
