#pragma once

#include <iosfwd>
#include <streambuf>
#include <string>
#include <string_view>

namespace fissure {

/// Passes text on to another buffer in a form that controls no terminal: a control character (isControl) is
/// written as an escape like \u009b, as in JSON, and a byte that is not part of valid UTF-8 like \xff. Line
/// ends and tabs stay. The bytes of a character may arrive in several pieces.
class PlainTextBuffer : public std::streambuf {
 public:
  explicit PlainTextBuffer(std::streambuf& to) : to_(to) {}
  ~PlainTextBuffer() override;
  PlainTextBuffer(const PlainTextBuffer&) = delete;
  PlainTextBuffer& operator=(const PlainTextBuffer&) = delete;

  /// The errno of the first write that failed; 0: none failed, or the reason is unknown.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool put(std::string_view text);
  /// Keeps errno unless `good` is true; returns `good`.
  bool noteError(bool good);

  std::streambuf& to_;
  std::string begun_;  ///< first bytes of a character that is not complete yet
  int error_ = 0;
};

/// During its lifetime everything that is written to a stream goes through a PlainTextBuffer.
class PlainOutput {
 public:
  explicit PlainOutput(std::ostream& stream);
  ~PlainOutput();
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

  /// Throws RunError about `name`, with the system's reason, unless all that was printed is written, so that
  /// lost output never looks like success. A pipe that its reader has closed, as `head` does, is no error.
  void requireWritten(const std::string& name);

 private:
  std::ostream& stream_;
  std::streambuf* before_;
  PlainTextBuffer plain_;
};

}  // namespace fissure
