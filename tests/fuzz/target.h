#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fissure::fuzz {

/// A kind of input, and what is done with one.
struct Target {
  std::string_view name;
  void (*take)(const std::string& bytes);
};

/// All targets.
const std::vector<Target>& targets();
/// The target of that name. Ends the program with a line where there is none.
const Target& targetNamed(const std::string& name);

// Each takes any bytes, and ends the program where the reader breaks a promise.
void takeScenario(const std::string& bytes);
void takeSweep(const std::string& bytes);
void takeStudy(const std::string& bytes);
void takeLog(const std::string& bytes);
void takeCurve(const std::string& bytes);
void takeMesh(const std::string& bytes);
void takeVolume(const std::string& bytes);
void takeResult(const std::string& bytes);
void takeJournal(const std::string& bytes);
void takeManifest(const std::string& bytes);

/// Ends the program as a crash does, with `promise` on standard error, unless it holds.
void require(bool holds, const std::string& promise);

/// The folder of the repository.
const std::filesystem::path& house();
/// A folder of this process for inputs that must be files; in memory where $TMPDIR is.
const std::filesystem::path& scratch();
/// Writes `<scratch>/<name>`, with the folders above it, and returns its path.
std::filesystem::path put(const std::string& name, const std::string& bytes);

/// What a refusal is: an InputError about a file or a line of it, or about a file that the program has
/// written itself, also a RunError.
enum class Refusal { file, line, own_file };

/// What refusals of a YAML file of these bytes are: none of its lines is wrong where it is empty, or a
/// result.
Refusal ofYaml(const std::string& bytes);

/// Runs `read`, and returns whether it accepted its input. A refusal must be an error of that kind, in one
/// line; an InputError begins with `file`. Any other exception ends the program.
bool accepts(const std::filesystem::path& file, Refusal refusal, const std::function<void()>& read);

/// Whether `text` is one line of at most 2000 bytes. (The program escapes what controls a terminal when it
/// prints.)
bool isOneLine(const std::string& text);

/// Runs `work` in a child process, as the program runs what a library may crash on. Returns false where it
/// ended within `library` (part of a file name, as "libhdf5"), took more than 5 s or 2 GiB, or was killed; a
/// finding of a sanitizer in other code and a broken promise end this process too. What the child reached
/// counts as reached here.
bool survives(const std::string& library, const std::function<void()>& work);

}  // namespace fissure::fuzz
