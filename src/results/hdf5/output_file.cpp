#include "hdf5/output_file.h"

#include <cstring>

#include "base/error.h"

namespace fissure::h5 {

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  // The file first: closing it may still write down an error.
  id_ = std::move(other.id_);
  errors_ = std::move(other.errors_);
  return *this;
}

void OutputFile::take(hid_t id, std::string_view doing) {
  if (id < 0 && errors_->open_errno != 0) {
    throw RunError(std::string(doing) + ": " + std::strerror(errors_->open_errno));
  }
  id_ = Id(id, H5Fclose, doing);
}

OutputFile OutputFile::create(const std::filesystem::path& path, unsigned flags, Space space) {
  OutputFile file;
  const Id access = accessProperties();
  useWriteDriver(access, *file.errors_);
  const Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "cannot prepare a file");
  check(H5Pset_link_creation_order(creation, tracked_order), "cannot prepare a file");
  check(H5Pset_attr_creation_order(creation, tracked_order), "cannot prepare a file");
  if (space == Space::paged) {
    check(H5Pset_file_space_strategy(creation, H5F_FSPACE_STRATEGY_PAGE, false, 1), "cannot prepare a file");
    // In pages of that size HDF5 lets no structure smaller than a page cross from one into the next.
    check(H5Pset_file_space_page_size(creation, page_size), "cannot prepare a file");
  }
  file.take(H5Fcreate(path.c_str(), flags, creation, access), "cannot create");
  return file;
}

OutputFile OutputFile::openToChange(const std::filesystem::path& path) {
  OutputFile file;
  const Id access = accessProperties();
  useWriteDriver(access, *file.errors_);
  file.take(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), "cannot open");
  return file;
}

std::optional<std::string> OutputFile::writeFailure() const {
  if (errors_->first_errno == 0) return std::nullopt;
  if (errors_->cut_short) return "cannot write: somebody else has cut the file short";
  return std::string("cannot write: ") + std::strerror(errors_->first_errno);
}

void OutputFile::checkWritten() const {
  if (const auto failure = writeFailure()) throw RunError(*failure);
}

void OutputFile::flush() const {
  check(H5Fflush(id_, H5F_SCOPE_LOCAL), "cannot write");
  checkWritten();
}

void OutputFile::close() {
  id_.close("cannot write");
  checkWritten();
}

}  // namespace fissure::h5

namespace fissure {

ReplacementFile::ReplacementFile(const std::filesystem::path& target)
    : temporary_(target), file_(h5::OutputFile::create(temporary_.path(), H5F_ACC_EXCL)) {}

}  // namespace fissure
