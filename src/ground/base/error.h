#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fissure {

/// The place at which a value or a text was written, as error messages name it.
struct Origin {
  enum class Kind {
    nowhere,   ///< unknown
    file,      ///< in a file
    override,  ///< on the command line, as `--set path=value`
    axis,      ///< in a file, as the axis of a sweep that varies `path`
  };
  Kind kind = Kind::nowhere;
  std::string file;  ///< name of the file; empty where it is unknown, as it may be for an axis
  int line = 0;      ///< line in the file, from 1; 0: the file as a whole
  std::string path;  ///< key path in the scenario that an override or an axis changes; else empty

  /// The beginning of an error message about this place: "file:line: ", "file: ", "--set path: ", "file:line:
  /// axis path: " or "axis path: "; empty where the place is unknown.
  std::string beginning() const;
};

/// Makers of an Origin of kind file, override and axis. Lines count from 1; 0: the file as a whole.
Origin inFile(const std::filesystem::path& file, int line = 0);
Origin ofOverride(const std::string& path);
Origin ofAxis(const std::string& path, const std::string& file = "", int line = 0);

/// The message on one line, whatever it repeats of a file: final line ends and blanks are removed, and other
/// control characters of ASCII become blanks.
std::string onOneLine(std::string message);

/// An error in input or usage, to be corrected by the user. what() is one line: the origin, as far as it is
/// known, then text(), which says what is wrong and what was expected.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& text) : InputError(Origin(), text) {}
  InputError(const Origin& origin, const std::string& text)
      : std::runtime_error(onOneLine(origin.beginning() + text)), origin_(origin), text_(onOneLine(text)) {}

  const Origin& origin() const { return origin_; }
  const std::string& text() const { return text_; }
  /// Whether the error is about `file` as a whole, not about a line of it.
  bool isAbout(const std::filesystem::path& file) const;

 private:
  Origin origin_;
  std::string text_;
};

/// A failure that is no fault of the input: of a run, a worker or the disk. what() is one line.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& message) : std::runtime_error(onOneLine(message)) {}
};

}  // namespace fissure
