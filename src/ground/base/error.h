#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fissure {

/// Where something was written.
struct Origin {
  enum class Kind {
    nowhere,   ///< nothing is known about it
    file,      ///< in a file
    override,  ///< on the command line, as `--set path=value`
    axis,      ///< in a file, as the axis of a sweep that varies `path`
  };
  Kind kind = Kind::nowhere;
  std::string file;  ///< of an axis it may be unknown, and is empty then
  int line = 0;      ///< from 1; 0: the file as a whole
  std::string path;  ///< the place in the scenario that an override or an axis changes; else empty

  /// What a message about it begins with: "file:line: ", "file: ", "--set path: ", "file:line: axis path: "
  /// or "axis path: "; nothing where nothing is known.
  std::string beginning() const;
};

Origin inFile(const std::filesystem::path& file, int line = 0);
Origin ofOverride(const std::string& path);
Origin ofAxis(const std::string& path, const std::string& file = "", int line = 0);

/// Bad input or usage. what() is one line: where it is wrong, as far as that is known, then text(): what is
/// wrong, and what was expected.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& text) : InputError(Origin(), text) {}
  InputError(const Origin& origin, const std::string& text)
      : std::runtime_error(origin.beginning() + text), origin_(origin), text_(text) {}

  const Origin& origin() const { return origin_; }
  const std::string& text() const { return text_; }
  /// Whether it is about `file` as a whole.
  bool isAbout(const std::filesystem::path& file) const;

 private:
  Origin origin_;
  std::string text_;
};

/// A run, a worker or the disk failed. what() is one line.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace fissure
