#pragma once

#include <hdf5.h>

#include <string>

namespace fissure::h5 {

/// Bytes in a page. The write of a killed process can be incomplete only at a boundary of pages (Linux,
/// generic_perform_write).
inline constexpr unsigned page_size = 4096;

/// Errors of the disk while a file was written.
struct DiskErrors {
  int open_errno = 0;      ///< errno of the last attempt to open; 0 after success
  int first_errno = 0;     ///< errno of the first write, truncation or close that failed; 0: none
  bool cut_short = false;  ///< the first failure is that another process had shortened the file
};

/// Makes `access` (file access properties) write through a file driver of this program, on ordinary POSIX
/// files. The driver never tells HDF5 that a write failed, because HDF5 1.10 crashes or reports success when
/// a full disk interrupts its flushing and closing. Instead it keeps the first failure in `errors`, which
/// must outlive the file and which the writer must check soon. Nothing is written after a failure, but HDF5's
/// own structures stay readable from memory, so that it can close the file. A file that another process has
/// shortened counts as a failed write, because a later write would leave a hole that reads as zeros. Throws
/// RunError when the driver cannot be set.
void useWriteDriver(hid_t access, DiskErrors& errors);

}  // namespace fissure::h5
