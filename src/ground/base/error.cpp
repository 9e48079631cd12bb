#include "base/error.h"

#include <algorithm>

namespace fissure {

std::string Origin::beginning() const {
  std::string place = file;
  if (line > 0) place.append(":").append(std::to_string(line));
  place += ": ";
  switch (kind) {
    case Kind::nowhere:
      break;
    case Kind::file:
      return place;
    case Kind::override:
      return "--set " + path + ": ";
    case Kind::axis:
      return (file.empty() ? "" : place) + "axis " + path + ": ";
  }
  return "";
}

Origin inFile(const std::filesystem::path& file, int line) {
  return {Origin::Kind::file, file.string(), line, ""};
}

Origin ofOverride(const std::string& path) {
  return {Origin::Kind::override, "", 0, path};
}

Origin ofAxis(const std::string& path, const std::string& file, int line) {
  return {Origin::Kind::axis, file, line, path};
}

std::string onOneLine(std::string message) {
  constexpr char first_printable = 0x20, del = 0x7f;
  std::replace_if(
      message.begin(), message.end(), [](char c) { return (c >= 0 && c < first_printable) || c == del; },
      ' ');
  message.erase(message.find_last_not_of(' ') + 1);
  return message;
}

bool InputError::isAbout(const std::filesystem::path& file) const {
  return origin_.kind == Origin::Kind::file && origin_.line == 0 && origin_.file == file.string();
}

}  // namespace fissure
