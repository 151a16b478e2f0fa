#include "ui/draw/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "ui/draw/renderer.h"
#include "ui/draw/shared_library.h"

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

}  // namespace

struct EglContext::Body {
  Body() : display(openDisplay(egl)), context(createContext(egl, display)) {
    try {
      makeCurrent();
      const ProcAddress find = [this](const char* name) {
        return reinterpret_cast<void*>(egl.getProcAddress(name));
      };
      gl = std::make_unique<FramebufferFunctions>(find);
      renderer = std::make_unique<Renderer>(find);
      gl->genFramebuffers(1, &framebuffer);
      gl->genRenderbuffers(1, &renderbuffer);
      gl->pixelStore(GL_PACK_ALIGNMENT, 1);
      leave();
    } catch (...) {
      leave();
      egl.destroyContext(display, context);
      throw;
    }
  }

  ~Body() {
    if (egl.makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      renderer.reset();
      gl->deleteFramebuffers(1, &framebuffer);
      gl->deleteRenderbuffers(1, &renderbuffer);
    }
    leave();
    egl.destroyContext(display, context);
  }

  void makeCurrent() {
    if (!egl.makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      egl.refuse("its context cannot be used without a surface");
  }
  void leave() { egl.makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  void resize(int newWidth, int newHeight) {
    gl->bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (newWidth == width && newHeight == height) return;
    gl->bindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl->storage(GL_RENDERBUFFER, GL_RGBA8, newWidth, newHeight);
    gl->attach(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    if (gl->status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      egl.refuse("a picture of " + std::to_string(newWidth) + " x " + std::to_string(newHeight) +
                 " pixels is too large");
    width = newWidth;
    height = newHeight;
  }

  /// Reads the pixels; OpenGL's rows begin at the bottom.
  Pixels read() const {
    Pixels pixels{width, height, {}};
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    pixels.rgba.resize(row * static_cast<std::size_t>(height));
    gl->readPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
    auto upper = pixels.rgba.begin(), lower = pixels.rgba.end() - static_cast<std::ptrdiff_t>(row);
    for (; upper < lower;
         upper += static_cast<std::ptrdiff_t>(row), lower -= static_cast<std::ptrdiff_t>(row))
      std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
    return pixels;
  }

  EglLibrary egl;
  EGLDisplay display;
  EGLContext context;
  std::unique_ptr<FramebufferFunctions> gl;
  std::unique_ptr<Renderer> renderer;
  GLuint framebuffer = 0, renderbuffer = 0;
  int width = 0, height = 0;
};

EglContext::EglContext() : body_(std::make_unique<Body>()) {}

EglContext::~EglContext() = default;

Pixels EglContext::draw(const DrawList& list) {
  checkPictureSize(list);
  body_->makeCurrent();
  try {
    body_->resize(list.width, list.height);
    body_->renderer->draw(list, body_->framebuffer);
    body_->gl->bindFramebuffer(GL_FRAMEBUFFER, body_->framebuffer);
    Pixels pixels = body_->read();
    body_->leave();
    return pixels;
  } catch (...) {
    body_->leave();
    throw;
  }
}

}  // namespace asperity
