#pragma once

#include <GL/osmesa.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "render/canvas.h"

namespace fissure {

/// The functions of OpenGL that are needed, looked up at run time: their types come from the headers, and
/// nothing is linked.
struct GlFunctions {
  decltype(&::glBlendEquation) blendEquation = nullptr;
  decltype(&::glBlendFunc) blendFunc = nullptr;
  decltype(&::glClear) clear = nullptr;
  decltype(&::glClearColor) clearColor = nullptr;
  decltype(&::glColorPointer) colorPointer = nullptr;
  decltype(&::glCullFace) cullFace = nullptr;
  decltype(&::glDepthFunc) depthFunc = nullptr;
  decltype(&::glDepthMask) depthMask = nullptr;
  decltype(&::glDisable) disable = nullptr;
  decltype(&::glDrawArrays) drawArrays = nullptr;
  decltype(&::glEnable) enable = nullptr;
  decltype(&::glEnableClientState) enableClientState = nullptr;
  decltype(&::glFinish) finish = nullptr;
  decltype(&::glGetError) getError = nullptr;
  decltype(&::glGetIntegerv) getIntegerv = nullptr;
  decltype(&::glGetString) getString = nullptr;
  decltype(&::glLineStipple) lineStipple = nullptr;
  decltype(&::glLineWidth) lineWidth = nullptr;
  decltype(&::glLoadMatrixd) loadMatrixd = nullptr;
  decltype(&::glMatrixMode) matrixMode = nullptr;
  decltype(&::glPolygonOffset) polygonOffset = nullptr;
  decltype(&::glReadPixels) readPixels = nullptr;
  decltype(&::glVertexPointer) vertexPointer = nullptr;
  decltype(&::glViewport) viewport = nullptr;
};

/// An OSMesa context with its own picture of 8 bits per channel (RGBA) and 24 bits of depth. It belongs to
/// one thread.
class OsMesa {
 public:
  /// Loads `library`, which stays in memory until the process ends, and makes a context. Throws RunError when
  /// the library or one of its functions is missing, or when it refuses the size.
  OsMesa(int width_px, int height_px, const std::string& library = "libOSMesa.so.8");

  /// Makes this context the one on which gl() acts. Throws RunError when OSMesa refuses.
  void makeCurrent();
  const GlFunctions& gl() const { return gl_; }
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// The version, as "3.1 Mesa 22.3.6", and the renderer, as "llvmpipe (LLVM 15.0.6, 256 bits)"; or
  /// "unknown".
  std::string version() const { return text(GL_VERSION); }
  std::string renderer() const { return text(GL_RENDERER); }

  /// The picture after all drawing has finished: 4 bytes per pixel, rows from bottom to top. Throws RunError
  /// when OpenGL reports an error.
  std::span<const std::uint8_t> finishedPicture();
  /// A part of the depth buffer in the same order, values from 0 (near) to 1 (far).
  std::vector<float> depths(const PixelRectangle& part) const;

 private:
  using Context = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(&::OSMesaDestroyContext)>;
  struct CloseLibrary {
    void operator()(void* library) const;
  };

  void loadFunctions(const std::string& library);
  std::string text(GLenum name) const;

  int width_px_ = 0;
  int height_px_ = 0;
  std::unique_ptr<void, CloseLibrary> library_;
  decltype(&::OSMesaMakeCurrent) make_current_ = nullptr;
  GlFunctions gl_;
  std::vector<std::uint8_t> rgba_;
  Context context_{nullptr, nullptr};
};

}  // namespace fissure
