#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>

#include "base/error.h"

namespace fissure {

/// A process that worked apart has crashed, or used up its time.
class LostApart : public RunError {
 public:
  explicit LostApart(pid_t process)
      : RunError("the library that reads it crashes or never ends"), process_(process) {}
  pid_t process() const { return process_; }

 private:
  pid_t process_;
};

/// Does `work` in a process of its own, which dies with this one and leaves nothing behind but the files it
/// has written: HDF5 1.10 and Assimp may crash on damaged files, or loop for ever. Throws what `work` throws,
/// as InputError (with its fields) or RunError, and LostApart when it crashed or took more than `most_s` of
/// processor time.
void doApart(const std::function<void()>& work, unsigned long most_s);

/// Processor time, in seconds, in which a whole `file` is read or copied by far: 3 and one a megabyte, where
/// 0.004 (series) to 0.1 (small pictures) were measured. A slow disk takes none.
unsigned long patience_s(const std::filesystem::path& file);

/// Reads a file that may be damaged apart first. Throws InputError about `file`, also when `read` does.
void tryReading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace fissure
