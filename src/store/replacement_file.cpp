#include "store/replacement_file.h"

namespace fissure {

ReplacementFile::ReplacementFile(const std::filesystem::path& target)
    : temporary_(target), file_(h5::OutputFile::create(temporary_.path(), H5F_ACC_EXCL)) {}

}  // namespace fissure
