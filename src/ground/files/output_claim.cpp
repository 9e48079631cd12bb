#include "files/output_claim.h"

#include <fmt/core.h>

#include <climits>

#include "base/error.h"
#include "files/temporary_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Beside `result.h5` come `.result.h5.XXXXXX`, `result.interrupted.h5` and what TemporaryFile::nameFor()
/// makes of that, up to `.4194304.1000.tmp`.
constexpr std::size_t longest_name = NAME_MAX - sizeof ".interrupted" - sizeof ".4194304.1000.tmp";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw InputError(inFile(path), reason);
}

}  // namespace

fs::path hiddenBeside(const fs::path& output, const std::string& ending) {
  std::string name(1, '.');
  return output.parent_path() / name.append(output.filename().string()).append(ending);
}

void refuseExisting(const fs::path& output, bool replace) {
  const std::size_t bytes = output.filename().string().size();
  if (bytes > longest_name)
    refuse(output, fmt::format("has a name of {} bytes, expected at most {}, as the files that are made "
                               "beside it have longer ones",
                               bytes, longest_name));
  std::error_code ignored;  // what cannot be looked at cannot be written either, and is said then
  const fs::file_status status = fs::status(output, ignored);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse(output, "is no regular file, expected a new name");
  if (!replace) refuse(output, "exists already, expected a new name or --force");
}

void refuseInput(const fs::path& input, const fs::path& output) {
  std::error_code missing;
  if (fs::equivalent(input, output, missing))
    throw InputError(inFile(output), "is the result itself, expected another name");
}

OutputClaim::OutputClaim(const fs::path& output, bool replace) {
  if (!output.has_filename()) refuse(output, "is a folder, expected the name of a file");
  refuseExisting(output, replace);
  std::error_code error;
  if (output.has_parent_path()) fs::create_directories(output.parent_path(), error);
  if (error) refuse(output, "cannot make its folder: " + error.message());
  lock_.emplace(hiddenBeside(output, ".lock"), output);
  refuseExisting(output, replace);  // another run may have finished it before the lock was ours
  std::error_code ignored;
  for (const fs::path& leftover : unfinishedOf(output)) fs::remove(leftover, ignored);
}

}  // namespace fissure
