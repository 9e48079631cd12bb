#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissure::programs {

/// How a program ended, seen from outside.
struct Outcome {
  int code = -1;    ///< exit code; -1: killed
  int signal = 0;   ///< that killed it; 0: none
  std::string out;  ///< its standard output
  std::string err;  ///< its standard error
};

/// A folder of a test's own, removed at its end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Names of everything inside, hidden files too, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// A program that runs in `folder`, or has run. Signals are as in a fresh shell.
class Program {
 public:
  struct Limits {
    std::optional<unsigned long> file_bytes;
    bool error_is_terminal = false;  ///< stderr is a pseudo-terminal 100 columns wide
    bool out_is_terminal = false;    ///< stdout is the same one; what it gets is in Outcome::err
  };
  Program(const Folder& folder, const std::vector<std::string>& words, const Limits& limits);
  Program(const Folder& folder, const std::vector<std::string>& words) : Program(folder, words, Limits()) {}
  ~Program();  ///< kills it when it still runs
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t process() const { return process_; }
  void send(int signal) const;
  /// Waits for a child of this program, other than `not_this`, that has become an engine's worker; 0 when it
  /// ends before.
  pid_t waitForWorker(pid_t not_this = 0) const { return waitForChild("fissure-engine-f64", not_this); }
  /// The same for any program whose file's name begins with `program`.
  pid_t waitForChild(const std::string& program, pid_t not_this = 0) const;
  Outcome wait();

 private:
  bool running() const;

  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t process_ = -1;
  int terminal_ = -1;
};

/// The front program's path, and a worker's.
std::string fissureProgram();
std::string engineWorkerProgram();

/// `fissure WORDS...` in `folder`, to its end.
Outcome runFissure(const Folder& folder, std::vector<std::string> words);
/// Any other program, found on PATH.
Outcome runTool(const Folder& folder, const std::vector<std::string>& words);

/// True when `process` ends within `most_s` seconds; a zombie has ended.
bool endsSoon(pid_t process, double most_s = 5);

/// A python3 that has `module`; empty when there is none.
std::string pythonWith(const std::string& module);

/// Whether a line of `text` holds what a POSIX extended regular expression says.
bool hasMatch(const std::string& text, const std::string& expression);

/// Is `text` one line: text, and one '\n' at its end?
bool isOneLine(const std::string& text);

}  // namespace fissure::programs
