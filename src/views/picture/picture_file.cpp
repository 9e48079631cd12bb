#include "picture/picture_file.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "base/error.h"
#include "files/temporary_file.h"

namespace fissure {

namespace {

std::vector<std::uint8_t> encoded(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width_px);
  png.height = static_cast<png_uint_32>(image.height_px);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<std::uint8_t> bytes(size);
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0)
    throw RunError(std::string("libpng: ") + static_cast<const char*>(png.message));
  bytes.resize(size);
  return bytes;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void writeBytes(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wbxe"));
  if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
      std::fclose(file.release()) != 0)
    throw RunError(std::string("cannot write: ") + std::strerror(errno));
}

}  // namespace

void writePng(const std::filesystem::path& file, const Image& image) try {
  TemporaryFile temporary(file);
  writeBytes(temporary.path(), encoded(image));
  temporary.commit();
} catch (const RunError& error) {
  throw RunError(file.string() + ": " + error.what());
}

}  // namespace fissure
