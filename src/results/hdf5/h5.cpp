#include "hdf5/h5.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "files/input_file.h"

namespace fissure::h5 {

namespace {

// Upwards, the first record is where things went wrong; those after it only say who had called.
herr_t keepFirst(unsigned, const H5E_error2_t* error, void* reason) {
  auto& text = *static_cast<std::string*>(reason);
  if (text.empty() && error->desc) text = error->desc;
  return 0;
}

// The library's own file driver hides the system's words in a long line: `... error message = 'No space ...',
// buf ...`.
std::string innermostReason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepFirst, &reason);
  const std::string mark = "error message = '";
  if (const std::size_t at = reason.find(mark); at != std::string::npos) {
    const std::size_t from = at + mark.size();
    reason = reason.substr(from, reason.find('\'', from) - from);
  }
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason.empty() ? "HDF5 gave no reason" : reason;
}

/// What `bytes` of a file may hold: deflate makes 1032 bytes of one at most. A killed writer has stated the
/// last rows of its series before it stored them.
double mostHeldBy(double bytes) {
  constexpr double deflate_ratio = 1032, unwritten_bytes = 16 << 20;
  return deflate_ratio * bytes + unwritten_bytes;
}

/// Returns the size of all values that the dataset states, as they are stored.
double statedBytes(hid_t dataset, const std::vector<hsize_t>& shape) {
  const Id type(H5Dget_type(dataset), H5Tclose, "cannot read the type of a dataset");
  double bytes = static_cast<double>(H5Tget_size(type));
  for (const hsize_t length : shape) bytes *= static_cast<double>(length);
  return bytes;
}

std::vector<hsize_t> statedShape(hid_t dataset) {
  const Id space(H5Dget_space(dataset), H5Sclose, "cannot read the shape of a dataset");
  const int rank = check(H5Sget_simple_extent_ndims(space), "cannot read the shape of a dataset");
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "cannot read the shape of a dataset");
  return shape;
}

/// Those who open files say themselves which file it is.
void requireRegular(const std::filesystem::path& path) try {
  requireInputFile(path, "an HDF5 file");
} catch (const InputError& error) {
  throw RunError(error.text());
}

[[noreturn]] void refuseStated(double stated_bytes) {
  std::ostringstream text;
  text << "a dataset states " << std::round(stated_bytes / 1e6) << " MB, more than is stored of it";
  throw RunError(text.str());
}

// Every file is closed by its owner, and at exit HDF5 crashes on one that damage kept from closing. Only the
// first call into the library is in time to say so.
[[maybe_unused]] const herr_t no_work_at_exit = H5dont_atexit();

}  // namespace

void fail(std::string_view doing, std::string_view name) {
  std::string message(doing);
  if (!name.empty()) message.append(" ").append(name);
  throw RunError(message + ": " + innermostReason());
}

Id& Id::operator=(Id&& other) noexcept {
  if (this == &other) return *this;
  reset();
  id_ = other.id_;
  close_ = other.close_;
  other.id_ = H5I_INVALID_HID;
  return *this;
}

void Id::close(std::string_view doing, std::string_view name) {
  if (!valid()) return;
  const hid_t id = id_;
  id_ = H5I_INVALID_HID;
  check(close_(id), doing, name);
}

void Id::reset() noexcept {
  if (valid()) close_(id_);
  id_ = H5I_INVALID_HID;
}

Id accessProperties() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot prepare a file");
  // SWMR needs the 1.10 format. A file system without locks is no reason to refuse a file.
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot prepare a file");
  check(H5Pset_file_locking(access, true, true), "cannot prepare a file");
  // What a writer has not finished is read again, after a pause that doubles: HDF5's own 100 attempts would
  // wait for years on damaged structures, these for a millisecond.
  check(H5Pset_metadata_read_attempts(access, 20), "cannot prepare a file");
  // What a full disk keeps from closing must not keep the file open.
  check(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "cannot prepare a file");
  return access;
}

Id openToRead(const std::filesystem::path& path) {
  requireRegular(path);
  const Id access = accessProperties();
  // A reader's lock would keep a worker that goes on from finishing its part; results change only by
  // renaming.
  check(H5Pset_file_locking(access, false, true), "cannot prepare a file");
  const hid_t plain = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (plain >= 0) return Id(plain, H5Fclose, "cannot open");
  // A killed writer leaves its SWMR mark in the file, and then only a SWMR reader is let in. Without the mark
  // the first answer was the true one.
  const hid_t marked = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access);
  if (marked >= 0) return Id(marked, H5Fclose, "cannot open");
  return Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "cannot open");
}

Id createGroup(hid_t parent, const std::string& name) {
  const Id creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "cannot prepare a group");
  check(H5Pset_link_creation_order(creation, tracked_order), "cannot prepare a group");
  check(H5Pset_attr_creation_order(creation, tracked_order), "cannot prepare a group");
  return Id(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose,
            "cannot create group", name);
}

Id openGroup(hid_t parent, const std::string& name) {
  return Id(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "cannot open group", name);
}

Id openDataset(hid_t parent, const std::string& name) {
  return Id(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "cannot open dataset", name);
}

Id openObject(hid_t parent, const std::string& name) {
  return Id(H5Oopen(parent, name.c_str(), H5P_DEFAULT), H5Oclose, "cannot open", name);
}

Id datasetProperties() {
  Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "cannot prepare a dataset");
  check(H5Pset_attr_creation_order(creation, tracked_order), "cannot prepare a dataset");
  return creation;
}

bool isGroup(const Id& object) {
  return H5Iget_type(object) == H5I_GROUP;
}

bool exists(hid_t parent, const std::string& name) {
  return check(H5Lexists(parent, name.c_str(), H5P_DEFAULT), "cannot look for", name) > 0;
}

std::vector<std::string> childNames(hid_t group) {
  H5G_info_t info{};
  check(H5Gget_info(group, &info), "cannot list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_of = [&](char* text, std::size_t size) {
      return check(
          H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, text, size, H5P_DEFAULT),
          "cannot list a group");
    };
    std::string name(static_cast<std::size_t>(name_of(nullptr, 0)), '\0');
    name_of(name.data(), name.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

double fileBytes(hid_t object) {
  const Id file(H5Iget_file_id(object), H5Fclose, "cannot read the size of a file");
  hsize_t bytes = 0;
  check(H5Fget_filesize(file, &bytes), "cannot read the size of a file");
  return static_cast<double>(bytes);
}

std::vector<hsize_t> shapeOf(hid_t dataset) {
  std::vector<hsize_t> shape = statedShape(dataset);
  const double stated_bytes = statedBytes(dataset, shape);
  if (stated_bytes > mostHeldBy(fileBytes(dataset))) refuseStated(stated_bytes);
  return shape;
}

void requireStored(hid_t dataset) {
  const double stated_bytes = statedBytes(dataset, statedShape(dataset));
  double stored_bytes = fileBytes(dataset);
  if (!isView(dataset))
    stored_bytes = std::min(stored_bytes, static_cast<double>(H5Dget_storage_size(dataset)));
  if (stated_bytes > mostHeldBy(stored_bytes)) refuseStated(stated_bytes);
}

bool isText(hid_t dataset) {
  const Id type(H5Dget_type(dataset), H5Tclose, "cannot read the type of a dataset");
  return H5Tget_class(type) == H5T_STRING;
}

std::string typeName(hid_t dataset) {
  const h5::Id type(H5Dget_type(dataset), H5Tclose, "cannot read the type of a dataset");
  const std::string bits = std::to_string(8 * H5Tget_size(type));
  switch (H5Tget_class(type)) {
    case H5T_STRING:
      return "text";
    case H5T_FLOAT:
      return "f" + bits;
    case H5T_INTEGER:
      return (H5Tget_sign(type) == H5T_SGN_NONE ? "u" : "i") + bits;
    default:
      return "other";
  }
}

bool isView(hid_t dataset) {
  const h5::Id creation(H5Dget_create_plist(dataset), H5Pclose, "cannot read the layout of a dataset");
  return H5Pget_layout(creation) == H5D_VIRTUAL;
}

Id textType() {
  Id type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a string type");
  check(H5Tset_size(type, H5T_VARIABLE), "cannot make a string type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "cannot make a string type");
  return type;
}

Id transferOf(hid_t type) {
  Id list(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "cannot make a transfer list");
  constexpr std::size_t text_buffer = 16384;
  if (check(H5Tis_variable_str(type), "cannot look at a type") > 0)
    check(H5Pset_buffer(list, text_buffer, nullptr, nullptr), "cannot make a transfer list");
  return list;
}

void writeText(hid_t group, const std::string& name, const std::string& text) {
  const Id type = textType();
  const Id space(H5Screate(H5S_SCALAR), H5Sclose, "cannot make a scalar");
  const Id dataset(
      H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, datasetProperties(), H5P_DEFAULT), H5Dclose,
      "cannot create dataset", name);
  const char* const pointer = text.c_str();
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, transferOf(type), &pointer), "cannot write dataset", name);
}

std::vector<std::string> readTexts(hid_t dataset) {
  requireStored(dataset);
  const Id type = textType();
  const Id space(H5Dget_space(dataset), H5Sclose, "cannot read a text");
  const hssize_t count = check(H5Sget_simple_extent_npoints(space), "cannot read a text");
  std::vector<char*> pointers(static_cast<std::size_t>(count), nullptr);
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, transferOf(type), pointers.data()), "cannot read a text");
  std::vector<std::string> texts;
  for (const char* text : pointers) texts.emplace_back(text ? text : "");
  check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data()), "cannot read a text");
  return texts;
}

}  // namespace fissure::h5
