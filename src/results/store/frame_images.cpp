#include "store/frame_images.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "hdf5/group_builder.h"

namespace fissure {

namespace {

const char* const doing = "cannot make a view of frame";

std::string imageName(hsize_t frame) {
  return fmt::format("{:06}", frame);
}

void addImage(hid_t images, const std::string& name, hsize_t frame, const std::string& source,
              const std::vector<hsize_t>& stack) {
  const std::array<hsize_t, 3> shape = {stack[1], stack[2], stack[3]};
  const std::array<hsize_t, 4> start = {frame, 0, 0, 0};
  const std::array<hsize_t, 4> size = {1, stack[1], stack[2], stack[3]};
  const h5::Id view(H5Screate_simple(3, shape.data(), nullptr), H5Sclose, doing, name);
  const h5::Id from(H5Screate_simple(4, stack.data(), nullptr), H5Sclose, doing, name);
  h5::check(H5Sselect_hyperslab(from, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), doing,
            name);
  const h5::Id creation = h5::datasetProperties();
  // "." is this very file, whatever it is called.
  h5::check(H5Pset_virtual(creation, view, ".", source.c_str(), from), doing, name);
  const h5::Id image(
      H5Dcreate2(images, name.c_str(), H5T_NATIVE_UINT8, view, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose,
      doing, name);
  h5::setAttribute(image, "units", std::string("1"));
  h5::setAttribute(image, "long_name", "frame " + std::to_string(frame));
  h5::setAttribute(image, dimensions_attribute, std::string("image_y image_x channel"));
}

void markAsImage(hid_t image) {
  h5::setImageAttribute(image, "CLASS", "IMAGE");
  h5::setImageAttribute(image, "IMAGE_VERSION", "1.2");
  h5::setImageAttribute(image, "IMAGE_SUBCLASS", "IMAGE_TRUECOLOR");
  h5::setImageAttribute(image, "INTERLACE_MODE", "INTERLACE_PIXEL");
}

}  // namespace

void addFrameImages(hid_t group, const std::string& group_path) {
  const std::vector<hsize_t> stack = h5::shapeOf(h5::openDataset(group, "frames"));
  GroupBuilder images(group, "frame_images");
  images.addIndex("image_y", stack[1]);
  images.addIndex("image_x", stack[2]);
  images.addLabels("channel", h5::readTexts(h5::openDataset(group, "channel")));
  const hsize_t count = std::min(stack[0], most_frame_images);
  for (hsize_t frame = 0; frame < count; ++frame) {
    addImage(images.id(), imageName(frame), frame, group_path + "/frames", stack);
  }
  // Scales first: what is marked as an image takes none.
  attachScales(images.id());
  for (hsize_t frame = 0; frame < count; ++frame) {
    markAsImage(h5::openDataset(images.id(), imageName(frame)));
  }
}

}  // namespace fissure
