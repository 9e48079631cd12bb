#include "render/osmesa.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <cstdlib>

#include "base/error.h"

namespace fissure {
namespace {

template <typename Function>
Function lookUp(void* handle, const char* name, const std::string& library) {
  void* address = dlsym(handle, name);
  if (address == nullptr) {
    throw RunError(
        fmt::format("frames: {} has no {}, expected OSMesa of Debian's package libosmesa6", library, name));
  }
  return reinterpret_cast<Function>(address);
}

/// Sets an environment variable for as long as this lives, unless the user has set it.
class EnvironmentDefault {
 public:
  EnvironmentDefault(const char* name, const char* value) : name_(name), ours_(std::getenv(name) == nullptr) {
    setenv(name, value, 0);
  }
  ~EnvironmentDefault() {
    if (ours_) {
      unsetenv(name_);
    }
  }
  EnvironmentDefault(const EnvironmentDefault&) = delete;
  EnvironmentDefault& operator=(const EnvironmentDefault&) = delete;

 private:
  const char* name_;
  bool ours_;
};

}  // namespace

void OsMesa::CloseLibrary::operator()(void* library) const {
  dlclose(library);
}

OsMesa::OsMesa(int width_px, int height_px, const std::string& library)
    : width_px_(width_px), height_px_(height_px) {
  // Parallelism is across runs: as many workers as cores must not each bring as many drawing threads as
  // cores.
  const EnvironmentDefault one_thread("LP_NUM_THREADS", "0");
  // Mesa leaves threads and exit handlers behind that must find its code, hence NODELETE.
  library_.reset(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE));
  if (!library_) {
    throw RunError("frames: cannot load " + library +
                   " (Debian package libosmesa6): install it or record no frames");
  }
  loadFunctions(library);
  const auto create =
      lookUp<decltype(&::OSMesaCreateContextExt)>(library_.get(), "OSMesaCreateContextExt", library);
  context_ = {create(OSMESA_RGBA, 24, 0, 0, nullptr),
              lookUp<decltype(&::OSMesaDestroyContext)>(library_.get(), "OSMesaDestroyContext", library)};
  if (!context_) {
    throw RunError("frames: OSMesa cannot create a context of 24 bits depth");
  }
  rgba_.resize(static_cast<std::size_t>(width_px) * height_px * 4);
  makeCurrent();
  GLint largest_px[2] = {0, 0};
  gl_.getIntegerv(GL_MAX_VIEWPORT_DIMS, largest_px);
  if (width_px > largest_px[0] || height_px > largest_px[1]) {
    throw RunError(fmt::format("frames: OSMesa draws at most {} x {} pixels", largest_px[0], largest_px[1]));
  }
}

void OsMesa::loadFunctions(const std::string& library) {
  const auto function = [&](auto& pointer, const char* name) {
    pointer = lookUp<std::remove_reference_t<decltype(pointer)>>(library_.get(), name, library);
  };
  function(make_current_, "OSMesaMakeCurrent");
  function(gl_.blendEquation, "glBlendEquation");
  function(gl_.blendFunc, "glBlendFunc");
  function(gl_.clear, "glClear");
  function(gl_.clearColor, "glClearColor");
  function(gl_.colorPointer, "glColorPointer");
  function(gl_.cullFace, "glCullFace");
  function(gl_.depthFunc, "glDepthFunc");
  function(gl_.depthMask, "glDepthMask");
  function(gl_.disable, "glDisable");
  function(gl_.drawArrays, "glDrawArrays");
  function(gl_.enable, "glEnable");
  function(gl_.enableClientState, "glEnableClientState");
  function(gl_.finish, "glFinish");
  function(gl_.getError, "glGetError");
  function(gl_.getIntegerv, "glGetIntegerv");
  function(gl_.getString, "glGetString");
  function(gl_.lineStipple, "glLineStipple");
  function(gl_.lineWidth, "glLineWidth");
  function(gl_.loadMatrixd, "glLoadMatrixd");
  function(gl_.matrixMode, "glMatrixMode");
  function(gl_.polygonOffset, "glPolygonOffset");
  function(gl_.readPixels, "glReadPixels");
  function(gl_.vertexPointer, "glVertexPointer");
  function(gl_.viewport, "glViewport");
}

std::string OsMesa::text(GLenum name) const {
  const GLubyte* text = gl_.getString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

void OsMesa::makeCurrent() {
  if (make_current_(context_.get(), rgba_.data(), GL_UNSIGNED_BYTE, width_px_, height_px_) != GL_TRUE) {
    throw RunError(fmt::format("frames: OSMesa refuses a picture of {} x {} pixels", width_px_, height_px_));
  }
}

std::span<const std::uint8_t> OsMesa::finishedPicture() {
  gl_.finish();
  if (const GLenum error = gl_.getError(); error != GL_NO_ERROR) {
    throw RunError(fmt::format("frames: OpenGL error {} while drawing", error));
  }
  return rgba_;
}

std::vector<float> OsMesa::depths(const PixelRectangle& part) const {
  std::vector<float> depths(static_cast<std::size_t>(part.columns) * part.rows);
  gl_.readPixels(part.left, part.bottom, part.columns, part.rows, GL_DEPTH_COMPONENT, GL_FLOAT,
                 depths.data());
  return depths;
}

}  // namespace fissure
