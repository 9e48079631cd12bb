#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// What the header of a PLY file says that follows it.
class PlyLayout {
 public:
  /// Throws InputError, without a file's name, when the header is none.
  explicit PlyLayout(std::string_view bytes);

  /// Throws InputError when the elements that the header states do not fit into `bytes`, the whole file:
  /// Assimp makes up triangles where a file ends early.
  void requireAll(std::string_view bytes) const;

 private:
  struct Property {
    std::size_t size = 0;        ///< of its value, or of each of a list's, bytes
    std::size_t count_size = 0;  ///< of a list's length; 0: no list
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
  std::size_t body_ = 0;  ///< where it starts
};

}  // namespace fissure
