#include "mesh/obj_vertices.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace fissure {

namespace {

constexpr std::string_view blanks = " \t";

/// Takes the next line, without its end: CR, LF or both.
std::string_view takeLine(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
  return line;
}

/// Takes the next word of a line; empty at its end.
std::string_view takeWord(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

/// The vertices so far, and which of them faces name.
class Vertices {
 public:
  void add(int line) {
    lines_.push_back(line);
    used_.push_back(0);
  }
  /// A corner of a face: "7", "7/1/2", or counted from the last vertex, "-1".
  void use(std::string_view corner) {
    long long index = 0;
    const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), index);
    if (error != std::errc()) return;
    const auto count = static_cast<long long>(used_.size());
    const long long at = index < 0 ? count + index : index - 1;
    if (at >= 0 && at < count) used_[static_cast<std::size_t>(at)] = 1;
    if (at >= count) named_later_.push_back(static_cast<std::size_t>(at));
  }
  UnusedVertices unused() {
    for (const std::size_t at : named_later_)
      if (at < used_.size()) used_[at] = 1;
    const auto first = std::find(used_.begin(), used_.end(), 0);
    if (first == used_.end()) return {};
    return {static_cast<std::size_t>(std::count(first, used_.end(), 0)),
            lines_[static_cast<std::size_t>(first - used_.begin())]};
  }

 private:
  std::vector<int> lines_;
  std::vector<char> used_;
  std::vector<std::size_t> named_later_;  ///< by faces that stand before their vertices
};

}  // namespace

UnusedVertices unusedVertices(std::string_view obj) {
  Vertices vertices;
  bool in_face = false, goes_on = false;  // a backslash at its end carries a line on
  for (int number = 1; !obj.empty(); ++number) {
    std::string_view line = takeLine(obj);
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    if (!goes_on) {
      const std::string_view key = takeWord(line);
      in_face = key == "f";
      if (key == "v") vertices.add(number);
    }
    goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    while (in_face && !line.empty())
      if (const std::string_view corner = takeWord(line); !corner.empty()) vertices.use(corner);
  }
  return vertices.unused();
}

}  // namespace fissure
