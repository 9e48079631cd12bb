#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hdf5/write_driver.h"

namespace fissure::h5 {

/// Throws RunError `<doing> <name>: <HDF5's innermost reason>`.
[[noreturn]] void fail(std::string_view doing, std::string_view name);

/// Returns what an HDF5 call returned; throws RunError when the call failed (a negative result).
template <typename Result>
Result check(Result result, std::string_view doing, std::string_view name = {}) {
  if (result < 0) fail(doing, name);
  return result;
}

/// Owns one HDF5 identifier.
class Id {
 public:
  using Close = herr_t (*)(hid_t);

  Id() = default;
  /// Takes the identifier that an HDF5 call returned; throws RunError when the call failed.
  Id(hid_t id, Close closer, std::string_view doing, std::string_view name = {})
      : id_(check(id, doing, name)), close_(closer) {}
  Id(Id&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = H5I_INVALID_HID; }
  Id& operator=(Id&& other) noexcept;
  ~Id() { reset(); }

  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }
  /// Closes the identifier. Throws RunError when that fails, which the destructor ignores.
  void close(std::string_view doing, std::string_view name = {});
  void reset() noexcept;

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Links or attributes that keep their order of creation.
inline constexpr unsigned tracked_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
/// The file access properties of every file of this program. Also switches HDF5's own error printing off.
Id accessProperties();
/// Opens a file for reading, even one whose SWMR writer was killed. Throws RunError when it cannot be opened
/// or is no regular file.
Id openToRead(const std::filesystem::path& path);

/// Creates a group whose links and attributes keep their order of creation. This and the openers below throw
/// RunError.
Id createGroup(hid_t parent, const std::string& name);
Id openGroup(hid_t parent, const std::string& name);
Id openDataset(hid_t parent, const std::string& name);
/// Opens a group or a dataset.
Id openObject(hid_t parent, const std::string& name);
bool isGroup(const Id& object);
bool exists(hid_t parent, const std::string& name);
/// Creation properties of a dataset whose attributes keep their order.
Id datasetProperties();
std::vector<std::string> childNames(hid_t group);  ///< in order of creation
/// The lengths of a dataset's axes. Throws RunError when it states more values than a file of its size can
/// hold.
std::vector<hsize_t> shapeOf(hid_t dataset);
double fileBytes(hid_t object);  ///< size in bytes of the file that contains an object or attribute
/// Throws RunError when a dataset states many more values than are stored; to be called before all are read
/// at once. A few megabytes that a killed writer had not written yet are tolerated.
void requireStored(hid_t dataset);
bool isText(hid_t dataset);
/// The type of a dataset's values: "f64", "i64", "u8", "text" ...
std::string typeName(hid_t dataset);
/// Whether a dataset only shows parts of others (a virtual dataset).
bool isView(hid_t dataset);

/// The type of variable-length UTF-8 strings.
Id textType();
/// How values of a type in memory are read and written. For each call with texts HDF5 clears the buffers
/// through which it converts them, of a megabyte each where nothing is said: here they are of 16 KiB, as a
/// result has dozens of short texts.
Id transferOf(hid_t type);
void writeText(hid_t group, const std::string& name, const std::string& text);
/// The strings of a dataset in row-major order; a scalar dataset has one.
std::vector<std::string> readTexts(hid_t dataset);

/// Set an attribute; an existing one of that name is replaced.
void setAttribute(hid_t object, const std::string& name, const std::string& value);
void setAttribute(hid_t object, const std::string& name, double value);
void setAttribute(hid_t object, const std::string& name, std::int64_t value);
void setAttribute(hid_t object, const std::string& name, std::int32_t value);
void setAttribute(hid_t object, const std::string& name, const std::vector<std::uint8_t>& values);
/// Sets a text of fixed-length ASCII with a terminating NUL, as the HDF5 Image specification demands.
void setImageAttribute(hid_t object, const std::string& name, const std::string& value);
void removeAttribute(hid_t object, const std::string& name);
std::vector<std::string> attributeNames(hid_t object);  ///< in order of creation
/// Copies an attribute, also to another file; an existing one of that name is replaced. Not for references.
void copyAttribute(hid_t from, hid_t to, const std::string& name);
/// Copies the selected values of dataset `from` into dataset `to`, which has as many values.
void copyValues(hid_t from, hid_t selection, hid_t to, const std::string& name);

using AttributeValue = std::variant<double, long long, std::string>;
/// The value of a scalar attribute; no value when there is none of that name, or it is neither number nor
/// string.
std::optional<AttributeValue> attribute(hid_t object, const std::string& name);
/// The value of a string attribute; `otherwise` when there is none.
std::string textAttribute(hid_t object, const std::string& name, const std::string& otherwise = {});
/// The value of an integer attribute; `otherwise` when there is none.
long long integerAttribute(hid_t object, const std::string& name, long long otherwise);

}  // namespace fissure::h5
