#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The layout of a PLY file, as its header states it.
class PlyLayout {
 public:
  /// Parses the header at the beginning of `bytes`. Throws InputError, without a file's name, when it is no
  /// valid header.
  explicit PlyLayout(std::string_view bytes);

  /// Throws InputError when `bytes`, the whole file, is too short for the elements that the header states:
  /// Assimp makes up triangles where a file ends early.
  void requireAll(std::string_view bytes) const;

 private:
  struct Property {
    std::size_t size = 0;        ///< bytes of its value, or of each item of a list
    std::size_t count_size = 0;  ///< bytes of the length of a list; 0: no list
  };
  struct Element {
    double count = 0;
    std::vector<Property> properties;
  };
  enum class Encoding { text, little_endian, big_endian };

  void takeLine(const std::string& line);
  template <class Walker>
  void walk(Walker walker) const;

  Encoding encoding_ = Encoding::text;
  std::vector<Element> elements_;
  std::size_t body_ = 0;  ///< offset of the data behind the header, bytes
};

}  // namespace fissure
