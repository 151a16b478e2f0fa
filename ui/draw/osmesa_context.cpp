#include "ui/draw/osmesa_context.h"

#include <stdexcept>
#include <string>

#include "ui/draw/renderer.h"
#include "ui/draw/shared_library.h"

#include <GL/osmesa.h>

namespace asperity {
namespace {

struct OsmesaLibrary : SharedLibrary {
  OsmesaLibrary() : SharedLibrary("libOSMesa.so.8", "ASPERITY_OSMESA_LIBRARY", "libosmesa6") {
    find(createContext, "OSMesaCreateContextAttribs");
    find(destroyContext, "OSMesaDestroyContext");
    find(makeCurrent, "OSMesaMakeCurrent");
    find(pixelStore, "OSMesaPixelStore");
    find(getProcAddress, "OSMesaGetProcAddress");
  }

  decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaPixelStore) pixelStore = nullptr;
  decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
};

constexpr int kAttributes[] = {OSMESA_FORMAT,
                               OSMESA_RGBA,
                               OSMESA_DEPTH_BITS,
                               0,
                               OSMESA_PROFILE,
                               OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION,
                               3,
                               OSMESA_CONTEXT_MINOR_VERSION,
                               3,
                               0};

}  // namespace

struct OsmesaContext::Body {
  Body() : context(library.createContext(kAttributes, nullptr)) {
    if (context == nullptr)
      throw std::runtime_error("The library " + library.name() +
                               " is too old for pictures: it offers no OpenGL 3.3 core context.");
    try {
      makeCurrent(1, 1);
      library.pixelStore(OSMESA_Y_UP, 0);
      renderer = std::make_unique<Renderer>([this](const char* name) {
        return reinterpret_cast<void*>(library.getProcAddress(name));
      });
      finish = reinterpret_cast<void (*)()>(library.getProcAddress("glFinish"));
    } catch (...) {
      release();
      throw;
    }
    release(false);
  }

  ~Body() {
    if (library.makeCurrent(context, pixels.rgba.data(), GL_UNSIGNED_BYTE, pixels.width,
                            pixels.height))
      renderer.reset();
    release();
  }

  /// Makes the context current; it draws into `pixels` of this size.
  void makeCurrent(int width, int height) {
    pixels.width = width;
    pixels.height = height;
    pixels.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (!library.makeCurrent(context, pixels.rgba.data(), GL_UNSIGNED_BYTE, width, height))
      throw std::runtime_error("A picture of " + std::to_string(width) + " x " +
                               std::to_string(height) + " pixels cannot be drawn by " +
                               library.name() + ".");
  }

  void release(bool destroy = true) {
    library.makeCurrent(nullptr, nullptr, 0, 0, 0);
    if (destroy) library.destroyContext(context);
  }

  OsmesaLibrary library;
  OSMesaContext context;
  Pixels pixels;
  std::unique_ptr<Renderer> renderer;
  void (*finish)() = nullptr;
};

OsmesaContext::OsmesaContext() : body_(std::make_unique<Body>()) {}

OsmesaContext::~OsmesaContext() = default;

Pixels OsmesaContext::draw(const DrawList& list) {
  checkPictureSize(list);
  body_->makeCurrent(list.width, list.height);
  body_->renderer->draw(list, 0);
  body_->finish();
  body_->library.makeCurrent(nullptr, nullptr, 0, 0, 0);
  return body_->pixels;
}

}  // namespace asperity
