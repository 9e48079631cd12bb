#include "mesh/ply_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>

#include "base/error.h"

namespace fissure {
namespace {

constexpr double most_elements = 1e15;  ///< more than any file has: it ends first

[[noreturn]] void endsEarly() {
  throw InputError("ends before all that its header states (a damaged file)");
}

/// Assimp takes each of these characters for the end of a line, and skips what follows up to the next '\n'.
void refuseOddLineEnds(std::string_view text) {
  using namespace std::string_view_literals;
  constexpr std::string_view odd = "\r\f\0"sv;
  for (std::size_t at = text.find_first_of(odd); at != std::string_view::npos;
       at = text.find_first_of(odd, at + 1)) {
    if (text.substr(at, 2) != "\r\n")
      throw InputError(
          "has a carriage return, form feed or NUL within a line, expected lines that end in "
          "LF or CR LF");
  }
}

std::size_t sizeOf(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  if (found == sizes.end())
    throw InputError("has a PLY property of type \"" + type + "\", expected int, float ...");
  return found->second;
}

/// Passes over words.
class WordWalker {
 public:
  explicit WordWalker(std::string_view text) : text_(text) {}
  void value(std::size_t) { next(); }
  std::uint64_t count(std::size_t) {
    std::uint64_t number = 0;
    for (const char c : next()) {
      if (c < '0' || c > '9' || number > text_.size()) endsEarly();
      number = 10 * number + static_cast<std::uint64_t>(c - '0');
    }
    return number;
  }

 private:
  std::string_view next() {
    constexpr const char* blank = " \t\r\n";
    const std::size_t from = text_.find_first_not_of(blank, at_);
    if (from == std::string_view::npos) endsEarly();
    at_ = std::min(text_.find_first_of(blank, from), text_.size());
    return text_.substr(from, at_ - from);
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Passes over binary values.
class ByteWalker {
 public:
  ByteWalker(std::string_view bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}
  void value(std::size_t size) { next(size); }
  std::uint64_t count(std::size_t size) {
    const std::string_view bytes = next(size);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size; ++i)
      number = number << 8 | static_cast<unsigned char>(bytes[big_endian_ ? i : size - 1 - i]);
    return number;
  }

 private:
  std::string_view next(std::size_t size) {
    if (size > bytes_.size() - at_) endsEarly();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::string_view bytes_;
  bool big_endian_;
  std::size_t at_ = 0;
};

}  // namespace

PlyLayout::PlyLayout(std::string_view bytes) {
  constexpr std::string_view last = "end_header";
  const std::size_t end = bytes.find(last);
  if (!bytes.starts_with("ply") || end == std::string_view::npos)
    throw InputError("is no PLY file, expected a header from ply to end_header");
  body_ = std::min(bytes.find('\n', end), bytes.size() - 1) + 1;
  refuseOddLineEnds(bytes.substr(0, body_));
  std::istringstream header{std::string(bytes.substr(0, end))};
  for (std::string line; std::getline(header, line);) takeLine(line);
}

void PlyLayout::takeLine(const std::string& line) {
  std::istringstream words(line);
  std::string key, type, other;
  words >> key >> type;
  if (key == "format") {
    encoding_ = type == "ascii"                  ? Encoding::text
                : type == "binary_little_endian" ? Encoding::little_endian
                                                 : Encoding::big_endian;
  } else if (key == "element") {
    Element element;
    if (!(words >> element.count) || !(element.count >= 0))
      throw InputError("has a PLY element without a count (a damaged file)");
    elements_.push_back(element);
  } else if (key == "property") {
    if (elements_.empty()) throw InputError("has a PLY property of no element (a damaged file)");
    Property property;
    if (type == "list") {
      words >> other >> type;
      property.count_size = sizeOf(other);
    }
    property.size = sizeOf(type);
    elements_.back().properties.push_back(property);
  }
}

template <class Walker>
void PlyLayout::walk(Walker walker) const {
  for (const Element& element : elements_) {
    if (element.properties.empty()) continue;
    const auto count = static_cast<std::uint64_t>(std::ceil(std::min(element.count, most_elements)));
    for (std::uint64_t i = 0; i < count; ++i)
      for (const Property& property : element.properties) {
        std::uint64_t values = 1;
        if (property.count_size > 0) values = walker.count(property.count_size);
        for (std::uint64_t k = 0; k < values; ++k) walker.value(property.size);
      }
  }
}

void PlyLayout::requireAll(std::string_view bytes) const {
  const std::string_view body = bytes.substr(body_);
  if (encoding_ == Encoding::text) {
    refuseOddLineEnds(body);
    return walk(WordWalker(body));
  }
  walk(ByteWalker(body, encoding_ == Encoding::big_endian));
}

}  // namespace fissure
