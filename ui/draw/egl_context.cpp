// Draws into a framebuffer of an OpenGL 3.3 core context without a surface.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "ui/draw/gl_functions.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/renderer.h"

namespace asperity {
namespace {

struct EglLibrary : SharedLibrary {
  EglLibrary() : SharedLibrary("libEGL.so.1", "ASPERITY_EGL_LIBRARY", "libegl1") {
    find(getProcAddress, "eglGetProcAddress");
    find(queryString, "eglQueryString");
    find(initialize, "eglInitialize");
    find(bindApi, "eglBindAPI");
    find(chooseConfig, "eglChooseConfig");
    find(createContext, "eglCreateContext");
    find(destroyContext, "eglDestroyContext");
    find(makeCurrent, "eglMakeCurrent");
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::runtime_error("Pictures cannot be drawn by " + name() + ": " + why + ".");
  }

  decltype(&eglGetProcAddress) getProcAddress = nullptr;
  decltype(&eglQueryString) queryString = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bindApi = nullptr;
  decltype(&eglChooseConfig) chooseConfig = nullptr;
  decltype(&eglCreateContext) createContext = nullptr;
  decltype(&eglDestroyContext) destroyContext = nullptr;
  decltype(&eglMakeCurrent) makeCurrent = nullptr;
};

/// Functions that only this file needs; the renderer has its own table.
struct FramebufferFunctions {
  explicit FramebufferFunctions(const ProcAddress& find) {
    const auto get = [&find](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(find(name));
      if (function == nullptr) throw std::runtime_error(std::string(name) + " is missing");
    };
    get(genFramebuffers, "glGenFramebuffers");
    get(deleteFramebuffers, "glDeleteFramebuffers");
    get(bindFramebuffer, "glBindFramebuffer");
    get(genRenderbuffers, "glGenRenderbuffers");
    get(deleteRenderbuffers, "glDeleteRenderbuffers");
    get(bindRenderbuffer, "glBindRenderbuffer");
    get(storage, "glRenderbufferStorage");
    get(attach, "glFramebufferRenderbuffer");
    get(status, "glCheckFramebufferStatus");
    get(readPixels, "glReadPixels");
    get(pixelStore, "glPixelStorei");
  }

  PFNGLGENFRAMEBUFFERSPROC genFramebuffers;
  PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers;
  PFNGLBINDFRAMEBUFFERPROC bindFramebuffer;
  PFNGLGENRENDERBUFFERSPROC genRenderbuffers;
  PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers;
  PFNGLBINDRENDERBUFFERPROC bindRenderbuffer;
  PFNGLRENDERBUFFERSTORAGEPROC storage;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC attach;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC status;
  PFNGLREADPIXELSPROC readPixels;
  PFNGLPIXELSTOREIPROC pixelStore;
};

constexpr EGLint kConfig[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
constexpr EGLint kContext[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};

/// Opens the display without a screen. It belongs to the process and stays initialized: closing it
/// would end every other context on it.
EGLDisplay openDisplay(const EglLibrary& egl) {
  const char* extensions = egl.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      egl.getProcAddress("eglGetPlatformDisplayEXT"));
  if (extensions == nullptr || platformDisplay == nullptr ||
      std::strstr(extensions, "EGL_MESA_platform_surfaceless") == nullptr)
    egl.refuse("it knows no EGL_MESA_platform_surfaceless");
  EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY || !egl.initialize(display, nullptr, nullptr))
    egl.refuse("there is no driver for a display without a screen (package libegl-mesa0)");
  return display;
}

EGLContext createContext(const EglLibrary& egl, EGLDisplay display) {
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl.bindApi(EGL_OPENGL_API) || !egl.chooseConfig(display, kConfig, &config, 1, &count) ||
      count < 1)
    egl.refuse("its driver offers no OpenGL");
  EGLContext context = egl.createContext(display, config, EGL_NO_CONTEXT, kContext);
  if (context == EGL_NO_CONTEXT) egl.refuse("its driver offers no OpenGL 3.3 core context");
  return context;
}

class EglContext : public PixelContext {
 public:
  EglContext() : display_(openDisplay(egl_)), context_(createContext(egl_, display_)) {
    try {
      makeCurrent();
      const ProcAddress find = [this](const char* name) {
        return reinterpret_cast<void*>(egl_.getProcAddress(name));
      };
      gl_ = std::make_unique<FramebufferFunctions>(find);
      renderer_ = std::make_unique<Renderer>(find);
      gl_->genFramebuffers(1, &framebuffer_);
      gl_->genRenderbuffers(1, &renderbuffer_);
      gl_->pixelStore(GL_PACK_ALIGNMENT, 1);
      leave();
    } catch (...) {
      leave();
      egl_.destroyContext(display_, context_);
      throw;
    }
  }

  ~EglContext() override {
    if (egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      renderer_.reset();
      gl_->deleteFramebuffers(1, &framebuffer_);
      gl_->deleteRenderbuffers(1, &renderbuffer_);
    }
    leave();
    egl_.destroyContext(display_, context_);
  }

  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string name() const override { return "egl"; }

  Pixels draw(const DrawList& list) override {
    checkPictureSize(list);
    makeCurrent();
    try {
      resize(list.width, list.height);
      renderer_->draw(list, framebuffer_);
      gl_->bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
      Pixels pixels = read();
      leave();
      return pixels;
    } catch (...) {
      leave();
      throw;
    }
  }

 private:
  void makeCurrent() {
    if (!egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      egl_.refuse("its context cannot be used without a surface");
  }
  void leave() { egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  void resize(int newWidth, int newHeight) {
    gl_->bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (newWidth == width_ && newHeight == height_) return;
    gl_->bindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
    gl_->storage(GL_RENDERBUFFER, GL_RGBA8, newWidth, newHeight);
    gl_->attach(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
    if (gl_->status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      egl_.refuse("a picture of " + std::to_string(newWidth) + " x " + std::to_string(newHeight) +
                  " pixels is too large");
    width_ = newWidth;
    height_ = newHeight;
  }

  /// Reads the pixels; OpenGL's rows begin at the bottom.
  Pixels read() const {
    Pixels pixels{width_, height_, {}};
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    pixels.rgba.resize(row * static_cast<std::size_t>(height_));
    gl_->readPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
    auto upper = pixels.rgba.begin(), lower = pixels.rgba.end() - static_cast<std::ptrdiff_t>(row);
    for (; upper < lower;
         upper += static_cast<std::ptrdiff_t>(row), lower -= static_cast<std::ptrdiff_t>(row))
      std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
    return pixels;
  }

  EglLibrary egl_;
  EGLDisplay display_;
  EGLContext context_;
  std::unique_ptr<FramebufferFunctions> gl_;
  std::unique_ptr<Renderer> renderer_;
  GLuint framebuffer_ = 0, renderbuffer_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace

std::unique_ptr<PixelContext> makeEglContext() {
  return std::make_unique<EglContext>();
}

}  // namespace asperity
