#include "hdf5/write_driver.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <map>
#include <new>

#include "hdf5/h5.h"

namespace fissure::h5 {

namespace {

constexpr herr_t succeed = 0;
constexpr herr_t failed = -1;

// The property list copies this by its bytes.
struct DriverInfo {
  DiskErrors* errors = nullptr;
};

using Page = std::array<char, page_size>;

struct OpenFile : H5FD_t {
  OpenFile() : H5FD_t{} {}
  int descriptor = -1;
  haddr_t allocated_end = 0;
  haddr_t file_end = 0;
  haddr_t disk_end = 0;  ///< how long the file on the disk is, unless somebody else changed it
  dev_t device = 0;
  ino_t inode = 0;
  DiskErrors* errors = nullptr;
  std::map<haddr_t, Page> unwritten;  ///< by page number: what HDF5 believes to be in the file

  bool broken() const { return errors->first_errno != 0; }
  void remember(int reason) {
    if (!broken()) errors->first_errno = reason;
  }
};

OpenFile& ours(H5FD_t* file) {
  return *static_cast<OpenFile*>(file);
}
const OpenFile& ours(const H5FD_t* file) {
  return *static_cast<const OpenFile*>(file);
}

int systemFlags(unsigned flags) {
  int system = (flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY;
  if ((flags & H5F_ACC_TRUNC) != 0) system |= O_TRUNC;
  if ((flags & H5F_ACC_CREAT) != 0) system |= O_CREAT;
  if ((flags & H5F_ACC_EXCL) != 0) system |= O_EXCL;
  return system | O_CLOEXEC;
}

H5FD_t* openFile(const char* name, unsigned flags, hid_t access, haddr_t) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
  if (!info || !info->errors) return nullptr;
  const int descriptor = ::open(name, systemFlags(flags), 0666);
  info->errors->open_errno = descriptor < 0 ? errno : 0;
  if (descriptor < 0) return nullptr;
  struct stat status {};
  auto* file = new (std::nothrow) OpenFile;
  if (!file || ::fstat(descriptor, &status) != 0) {
    delete file;
    ::close(descriptor);
    return nullptr;
  }
  file->descriptor = descriptor;
  file->file_end = static_cast<haddr_t>(status.st_size);
  file->disk_end = file->file_end;
  file->device = status.st_dev;
  file->inode = status.st_ino;
  file->errors = info->errors;
  return file;
}

herr_t closeFile(H5FD_t* file) {
  OpenFile& open = ours(file);
  // Some network file systems say only here that they had no room.
  if (::close(open.descriptor) != 0) open.remember(errno);
  delete &open;
  return succeed;
}

int compareFiles(const H5FD_t* first, const H5FD_t* second) {
  const OpenFile& a = ours(first);
  const OpenFile& b = ours(second);
  if (a.device != b.device) return a.device < b.device ? -1 : 1;
  if (a.inode != b.inode) return a.inode < b.inode ? -1 : 1;
  return 0;
}

herr_t queryFeatures(const H5FD_t*, unsigned long* features) {
  if (features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
                H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  }
  return succeed;
}

haddr_t allocatedEnd(const H5FD_t* file, H5FD_mem_t) {
  return ours(file).allocated_end;
}

herr_t setAllocatedEnd(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  ours(file).allocated_end = end;
  return succeed;
}

haddr_t fileEnd(const H5FD_t* file, H5FD_mem_t) {
  return ours(file).file_end;
}

bool readFromDisk(int descriptor, haddr_t address, std::size_t size, char* to) {
  while (size > 0) {
    const ssize_t got = ::pread(descriptor, to, size, static_cast<off_t>(address));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) break;
    to += got;
    address += static_cast<haddr_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  // HDF5 expects zeros beyond the end of the file.
  std::memset(to, 0, size);
  return true;
}

bool writeToDisk(int descriptor, haddr_t address, std::size_t size, const char* from) {
  while (size > 0) {
    const ssize_t put = ::pwrite(descriptor, from, size, static_cast<off_t>(address));
    if (put < 0 && errno == EINTR) continue;
    if (put == 0) errno = ENOSPC;
    if (put <= 0) return false;
    from += put;
    address += static_cast<haddr_t>(put);
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

// Calls visit(page number, offset in the page, offset in the range, bytes) for each page of a range.
template <typename Visit>
void forEachPage(haddr_t address, std::size_t size, Visit visit) {
  for (std::size_t done = 0; done < size;) {
    const haddr_t number = (address + done) / page_size;
    const auto offset = static_cast<std::size_t>((address + done) % page_size);
    const std::size_t bytes = std::min<std::size_t>(page_size - offset, size - done);
    visit(number, offset, done, bytes);
    done += bytes;
  }
}

void keepUnwritten(OpenFile& open, haddr_t address, std::size_t size, const char* from) {
  forEachPage(address, size, [&](haddr_t number, std::size_t offset, std::size_t done, std::size_t bytes) {
    const auto [page, is_new] = open.unwritten.try_emplace(number);
    if (is_new) readFromDisk(open.descriptor, number * page_size, page_size, page->second.data());
    std::copy_n(from + done, bytes, page->second.data() + offset);
  });
}

herr_t readBytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  const OpenFile& open = ours(file);
  auto* to = static_cast<char*>(buffer);
  if (!readFromDisk(open.descriptor, address, size, to)) return failed;
  if (open.unwritten.empty()) return succeed;
  forEachPage(address, size, [&](haddr_t number, std::size_t offset, std::size_t done, std::size_t bytes) {
    const auto page = open.unwritten.find(number);
    if (page != open.unwritten.end()) std::copy_n(page->second.data() + offset, bytes, to + done);
  });
  return succeed;
}

void checkLength(OpenFile& open) {
  struct stat status {};
  if (::fstat(open.descriptor, &status) != 0) return open.remember(errno);
  if (static_cast<haddr_t>(status.st_size) >= open.disk_end) return;
  open.remember(EIO);
  open.errors->cut_short = true;
}

herr_t writeBytes(H5FD_t* file, H5FD_mem_t kind, hid_t, haddr_t address, std::size_t size,
                  const void* buffer) {
  OpenFile& open = ours(file);
  const auto* from = static_cast<const char*>(buffer);
  open.file_end = std::max<haddr_t>(open.file_end, address + size);
  if (!open.broken()) checkLength(open);
  if (!open.broken()) {
    if (writeToDisk(open.descriptor, address, size, from)) {
      open.disk_end = std::max<haddr_t>(open.disk_end, address + size);
      return succeed;
    }
    open.remember(errno);
  }
  // HDF5 interprets what it reads back of its own structures, but never the values.
  if (kind == H5FD_MEM_DRAW) return succeed;
  try {
    keepUnwritten(open, address, size, from);
  } catch (const std::bad_alloc&) {
    return failed;
  }
  return succeed;
}

herr_t truncateFile(H5FD_t* file, hid_t, hbool_t) {
  OpenFile& open = ours(file);
  if (open.allocated_end == open.file_end) return succeed;
  if (!open.broken() && ::ftruncate(open.descriptor, static_cast<off_t>(open.allocated_end)) != 0) {
    open.remember(errno);
  }
  open.file_end = open.allocated_end;
  open.disk_end = open.allocated_end;
  return succeed;
}

// File systems that know no locks are no reason to refuse a file.
herr_t lockFile(H5FD_t* file, hbool_t exclusive) {
  const int operation = (exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB;
  const bool refused = ::flock(ours(file).descriptor, operation) != 0 && errno == EWOULDBLOCK;
  if (refused) ours(file).errors->open_errno = EWOULDBLOCK;
  return refused ? failed : succeed;
}

herr_t unlockFile(H5FD_t* file) {
  ::flock(ours(file).descriptor, LOCK_UN);
  return succeed;
}

const H5FD_class_t& driverClass() {
  static const H5FD_class_t driver = [] {
    H5FD_class_t functions{};
    functions.name = "fissure_write";
    functions.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
    functions.fc_degree = H5F_CLOSE_WEAK;
    functions.fapl_size = sizeof(DriverInfo);
    functions.open = openFile;
    functions.close = closeFile;
    functions.cmp = compareFiles;
    functions.query = queryFeatures;
    functions.get_eoa = allocatedEnd;
    functions.set_eoa = setAllocatedEnd;
    functions.get_eof = fileEnd;
    functions.read = readBytes;
    functions.write = writeBytes;
    functions.truncate = truncateFile;
    functions.lock = lockFile;
    functions.unlock = unlockFile;
    const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(kinds), std::end(kinds), functions.fl_map);
    return functions;
  }();
  return driver;
}

}  // namespace

void useWriteDriver(hid_t access, DiskErrors& errors) {
  static const hid_t driver = check(H5FDregister(&driverClass()), "cannot prepare a file");
  const DriverInfo info{&errors};
  check(H5Pset_driver(access, driver, &info), "cannot prepare a file");
}

}  // namespace fissure::h5
