#include "base/error.h"
#include "hdf5/h5.h"

namespace fissure::h5 {

namespace {

void replaceAttribute(hid_t object, const std::string& name, hid_t type, hid_t space, const void* value) {
  removeAttribute(object, name);
  const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                     "cannot create attribute", name);
  check(H5Awrite(attribute, type, value), "cannot write attribute", name);
}

Id scalarSpace() {
  return Id(H5Screate(H5S_SCALAR), H5Sclose, "cannot make a scalar");
}

std::string readString(hid_t attribute, hid_t type, const std::string& name) {
  if (check(H5Tis_variable_str(type), "cannot read attribute", name) > 0) {
    const Id memory = textType();
    const Id space(H5Aget_space(attribute), H5Sclose, "cannot read attribute", name);
    char* text = nullptr;
    check(H5Aread(attribute, memory, &text), "cannot read attribute", name);
    const std::string value = text ? text : "";
    check(H5Dvlen_reclaim(memory, space, H5P_DEFAULT, &text), "cannot read attribute", name);
    return value;
  }
  std::string value(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, value.data()), "cannot read attribute", name);
  return value.substr(0, value.find('\0'));
}

}  // namespace

void setAttribute(hid_t object, const std::string& name, const std::string& value) {
  const char* const pointer = value.c_str();
  replaceAttribute(object, name, textType(), scalarSpace(), &pointer);
}

void setAttribute(hid_t object, const std::string& name, double value) {
  replaceAttribute(object, name, H5T_NATIVE_DOUBLE, scalarSpace(), &value);
}

void setAttribute(hid_t object, const std::string& name, std::int64_t value) {
  replaceAttribute(object, name, H5T_NATIVE_INT64, scalarSpace(), &value);
}

void setAttribute(hid_t object, const std::string& name, std::int32_t value) {
  replaceAttribute(object, name, H5T_NATIVE_INT32, scalarSpace(), &value);
}

void setAttribute(hid_t object, const std::string& name, const std::vector<std::uint8_t>& values) {
  const hsize_t count = values.size();
  const Id space(H5Screate_simple(1, &count, nullptr), H5Sclose, "cannot create attribute", name);
  replaceAttribute(object, name, H5T_NATIVE_UINT8, space, values.data());
}

void setImageAttribute(hid_t object, const std::string& name, const std::string& value) {
  const Id type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a string type");
  check(H5Tset_size(type, value.size() + 1), "cannot make a string type");
  replaceAttribute(object, name, type, scalarSpace(), value.c_str());
}

void removeAttribute(hid_t object, const std::string& name) {
  if (check(H5Aexists(object, name.c_str()), "cannot look for attribute", name) > 0) {
    check(H5Adelete(object, name.c_str()), "cannot remove attribute", name);
  }
}

std::vector<std::string> attributeNames(hid_t object) {
  H5O_info_t info{};
  check(H5Oget_info2(object, &info, H5O_INFO_NUM_ATTRS), "cannot list attributes");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.num_attrs; ++i) {
    const auto name_of = [&](char* text, std::size_t size) {
      return check(
          H5Aget_name_by_idx(object, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, text, size, H5P_DEFAULT),
          "cannot list attributes");
    };
    std::string name(static_cast<std::size_t>(name_of(nullptr, 0)), '\0');
    name_of(name.data(), name.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

std::optional<AttributeValue> attribute(hid_t object, const std::string& name) {
  if (check(H5Aexists(object, name.c_str()), "cannot look for attribute", name) == 0) return std::nullopt;
  const Id found(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "cannot open attribute", name);
  const Id space(H5Aget_space(found), H5Sclose, "cannot read attribute", name);
  if (H5Sget_simple_extent_npoints(space) != 1) return std::nullopt;
  const Id type(H5Aget_type(found), H5Tclose, "cannot read attribute", name);
  switch (H5Tget_class(type)) {
    case H5T_STRING:
      return readString(found, type, name);
    case H5T_INTEGER: {
      long long value = 0;
      check(H5Aread(found, H5T_NATIVE_LLONG, &value), "cannot read attribute", name);
      return value;
    }
    case H5T_FLOAT: {
      double value = 0;
      check(H5Aread(found, H5T_NATIVE_DOUBLE, &value), "cannot read attribute", name);
      return value;
    }
    default:
      return std::nullopt;
  }
}

std::string textAttribute(hid_t object, const std::string& name, const std::string& otherwise) {
  const std::optional<AttributeValue> value = attribute(object, name);
  const auto* text = value ? std::get_if<std::string>(&*value) : nullptr;
  return text ? *text : otherwise;
}

long long integerAttribute(hid_t object, const std::string& name, long long otherwise) {
  const std::optional<AttributeValue> value = attribute(object, name);
  const auto* number = value ? std::get_if<long long>(&*value) : nullptr;
  return number ? *number : otherwise;
}

}  // namespace fissure::h5
