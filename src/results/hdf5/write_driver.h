#pragma once

#include <hdf5.h>

#include <string>

namespace fissure::h5 {

/// A killed process leaves a write half done only between two pages of memory (Linux, generic_perform_write).
inline constexpr unsigned page_size = 4096;

/// What went wrong on the disk while a file was written.
struct DiskErrors {
  int open_errno = 0;      ///< of the last attempt to open; 0 after success
  int first_errno = 0;     ///< of the first write, truncation or close that failed; 0: none
  bool cut_short = false;  ///< that was because somebody else had made the file shorter
};

/// Makes `access` (file access properties) write through a file driver of ours, with ordinary POSIX files. It
/// never tells HDF5 that a write failed: HDF5 1.10 crashes or reports success when a full disk interrupts its
/// flushing and closing. Instead the first failure is kept in `errors`, which must outlive the file; whoever
/// writes asks there, soon. After it nothing more is written; HDF5's own structures stay readable from
/// memory, so that it can close in peace. A file that somebody else has cut short counts as a failed write: a
/// later write would turn what is missing into a hole, which reads as zeros. Throws RunError.
void useWriteDriver(hid_t access, DiskErrors& errors);

}  // namespace fissure::h5
