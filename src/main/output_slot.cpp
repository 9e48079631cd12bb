#include "main/output_slot.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw InputError(path.string() + ": " + reason);
}

fs::path hiddenBeside(const fs::path& output, const std::string& ending) {
  std::string name(1, '.');
  return output.parent_path() / name.append(output.filename().string()).append(ending);
}

void checkFree(const fs::path& output, bool replace) {
  std::error_code ignored;  // what cannot be looked at cannot be written either, and is said then
  const fs::file_status status = fs::status(output, ignored);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse(output, "is no regular file, expected the name of a result file");
  if (!replace) refuse(output, "exists already, expected a new name or --force");
}

}  // namespace

OutputSlot::OutputSlot(const fs::path& output, bool replace) : output_(output) {
  if (!output.has_filename()) refuse(output, "is a folder, expected the name of a result file");
  checkFree(output, replace);
  std::error_code error;
  if (output.has_parent_path()) fs::create_directories(output.parent_path(), error);
  if (error) refuse(output, "cannot make its folder: " + error.message());
  lock_.emplace(hiddenBeside(output, ".lock"), output);
  checkFree(output, replace);  // another run may have finished it before the lock was ours
  removeLeftovers();
  std::string name = hiddenBeside(output, ".XXXXXX").string();
  if (!::mkdtemp(name.data())) refuse(output, std::string("cannot be written: ") + std::strerror(errno));
  parts_ = name;
}

OutputSlot::~OutputSlot() {
  std::error_code ignored;
  fs::remove_all(parts_, ignored);
}

/// What runs that were killed left behind: folders of parts, and half written results (which store/ names
/// so). While the lock is ours, nobody uses them.
void OutputSlot::removeLeftovers() const {
  const fs::path folder = output_.has_parent_path() ? output_.parent_path() : fs::path(".");
  const std::string result = output_.filename().string() + ".";
  const std::string parts = hiddenBeside(output_, ".").filename().string();
  std::error_code ignored;
  std::vector<fs::path> leftovers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const fs::file_status status = entry.symlink_status(ignored);
    const bool is_parts =
        name.starts_with(parts) && name.size() == parts.size() + 6 && fs::is_directory(status);
    const bool is_result = name.starts_with(result) && name.ends_with(".tmp") && fs::is_regular_file(status);
    if (is_parts || is_result) leftovers.push_back(entry.path());
  }
  for (const fs::path& leftover : leftovers) fs::remove_all(leftover, ignored);
}

}  // namespace fissure
