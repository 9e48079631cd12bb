#include "base/error.h"
#include "hdf5/h5.h"

namespace fissure::h5 {

namespace {

Id nativeType(hid_t type, const std::string& name) {
  return Id(H5Tget_native_type(type, H5T_DIR_ASCEND), H5Tclose, "cannot copy", name);
}

}  // namespace

void copyAttribute(hid_t from, hid_t to, const std::string& name) {
  const Id source(H5Aopen(from, name.c_str(), H5P_DEFAULT), H5Aclose, "cannot open attribute", name);
  const Id type(H5Aget_type(source), H5Tclose, "cannot read attribute", name);
  const Id space(H5Aget_space(source), H5Sclose, "cannot read attribute", name);
  const Id memory = nativeType(type, name);
  const auto count =
      static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space), "cannot read attribute", name));
  if (static_cast<double>(count) > fileBytes(source))
    throw RunError("attribute " + name + " states more values than its file has bytes");
  std::vector<char> values(count * H5Tget_size(memory));
  check(H5Aread(source, memory, values.data()), "cannot read attribute", name);
  removeAttribute(to, name);
  const Id made(H5Acreate2(to, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                "cannot create attribute", name);
  check(H5Awrite(made, memory, values.data()), "cannot write attribute", name);
  check(H5Dvlen_reclaim(memory, space, H5P_DEFAULT, values.data()), "cannot read attribute", name);
}

void copyValues(hid_t from, hid_t selection, hid_t to, const std::string& name) {
  const Id type(H5Dget_type(from), H5Tclose, "cannot read", name);
  const Id memory = nativeType(type, name);
  const auto count = static_cast<hsize_t>(check(H5Sget_select_npoints(selection), "cannot read", name));
  if (count == 0) return;
  const Id space(H5Screate_simple(1, &count, nullptr), H5Sclose, "cannot read", name);
  std::vector<char> values(count * H5Tget_size(memory));
  const Id transfer = transferOf(memory);
  check(H5Dread(from, memory, space, selection, transfer, values.data()), "cannot read", name);
  check(H5Dwrite(to, memory, space, H5S_ALL, transfer, values.data()), "cannot write dataset", name);
  check(H5Dvlen_reclaim(memory, space, H5P_DEFAULT, values.data()), "cannot read", name);
}

}  // namespace fissure::h5
