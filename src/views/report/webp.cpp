#include "report/webp.h"

#include <webp/encode.h>

#include <algorithm>
#include <memory>

#include "base/error.h"

namespace fissure {

namespace {

/// Owns what libwebp allocates within a picture.
struct Picture {
  Picture() = default;
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  ~Picture() { WebPPictureFree(&picture); }

  WebPPicture picture = {};
};

void require(int done, const char* doing) {
  if (done == 0) throw RunError(std::string("libwebp cannot ") + doing);
}

int appendTo(const std::uint8_t* bytes, std::size_t count, const WebPPicture* picture) {
  static_cast<std::string*>(picture->custom_ptr)->append(bytes, bytes + count);
  return 1;
}

}  // namespace

std::string encodeWebp(const Image& image, int width_px, double quality) {
  WebPConfig config;
  require(WebPConfigPreset(&config, WEBP_PRESET_DRAWING, static_cast<float>(quality)), "start");
  config.method = 2;  // twice as fast as the default, for a few percent more bytes
  Picture owner;
  WebPPicture& picture = owner.picture;
  require(WebPPictureInit(&picture), "start");
  picture.width = image.width_px;
  picture.height = image.height_px;
  require(WebPPictureImportRGB(&picture, image.rgb.data(), 3 * image.width_px), "take a frame");
  if (image.width_px > width_px) {
    const int height_px = std::max(1, image.height_px * width_px / image.width_px);
    require(WebPPictureRescale(&picture, width_px, height_px), "make a frame smaller");
  }
  std::string bytes;
  picture.writer = appendTo;
  picture.custom_ptr = &bytes;
  require(WebPEncode(&config, &picture), "write a frame");
  return bytes;
}

}  // namespace fissure
