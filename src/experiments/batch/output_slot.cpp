#include "batch/output_slot.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/temporary_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Folders of parts.
bool isPartsOf(const fs::path& result, const fs::directory_entry& entry) {
  std::error_code ignored;
  const std::string beginning = hiddenBeside(result, ".").filename().string();
  const std::string name = entry.path().filename().string();
  return name.starts_with(beginning) && name.size() == beginning.size() + 6 &&
         fs::is_directory(entry.symlink_status(ignored));
}

}  // namespace

OutputSlot::OutputSlot(const fs::path& output, bool replace) : output_(output), claim_(output, replace) {
  removeLeftovers();
  std::string name = hiddenBeside(output, ".XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw InputError(inFile(output), std::string("cannot be written: ") + std::strerror(errno));
  parts_ = name;
}

OutputSlot::~OutputSlot() {
  std::error_code ignored;
  fs::remove_all(parts_, ignored);
}

fs::path OutputSlot::interruptedOutput() const {
  return fs::path(output_).replace_extension(".interrupted.h5");
}

/// What runs that were killed left behind, beside what the claim removes. While it is ours, nobody uses it;
/// the name for interrupted batches may be the ordinary output of another run.
void OutputSlot::removeLeftovers() const {
  const fs::path folder = output_.has_parent_path() ? output_.parent_path() : fs::path(".");
  std::error_code ignored;
  std::vector<fs::path> ours;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (isPartsOf(output_, entry)) ours.push_back(entry.path());
  for (const fs::path& leftover : ours) fs::remove_all(leftover, ignored);
  if (unfinishedOf(interruptedOutput()).empty()) return;
  try {
    const OutputClaim claim(interruptedOutput(), true);
  } catch (const InputError&) {
    return;  // its own run cleans up
  }
}

}  // namespace fissure
