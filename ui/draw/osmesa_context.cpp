// Draws into memory by an OpenGL 3.3 core context of libOSMesa.
#include <memory>
#include <stdexcept>
#include <string>

#include "ui/draw/gl_functions.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/renderer.h"

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

class OsmesaContext : public PixelContext {
 public:
  OsmesaContext() : context_(library_.createContext(kAttributes, nullptr)) {
    if (context_ == nullptr)
      throw std::runtime_error("The library " + library_.name() +
                               " is too old for pictures: it offers no OpenGL 3.3 core context.");
    try {
      makeCurrent(1, 1);
      library_.pixelStore(OSMESA_Y_UP, 0);
      renderer_ = std::make_unique<Renderer>([this](const char* name) {
        return reinterpret_cast<void*>(library_.getProcAddress(name));
      });
      finish_ = reinterpret_cast<void (*)()>(library_.getProcAddress("glFinish"));
      leave();
    } catch (...) {
      leave();
      library_.destroyContext(context_);
      throw;
    }
  }

  ~OsmesaContext() override {
    if (library_.makeCurrent(context_, pixels_.rgba.data(), GL_UNSIGNED_BYTE, pixels_.width,
                             pixels_.height))
      renderer_.reset();
    leave();
    library_.destroyContext(context_);
  }

  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string name() const override { return "osmesa"; }

  Pixels draw(const DrawList& list) override {
    checkPictureSize(list);
    makeCurrent(list.width, list.height);
    renderer_->draw(list, 0);
    finish_();
    leave();
    return pixels_;
  }

 private:
  /// Makes the context current; it draws into `pixels_` of this size.
  void makeCurrent(int width, int height) {
    pixels_.width = width;
    pixels_.height = height;
    pixels_.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (!library_.makeCurrent(context_, pixels_.rgba.data(), GL_UNSIGNED_BYTE, width, height))
      throw std::runtime_error("A picture of " + std::to_string(width) + " x " +
                               std::to_string(height) + " pixels cannot be drawn by " +
                               library_.name() + ".");
  }
  void leave() { library_.makeCurrent(nullptr, nullptr, 0, 0, 0); }

  OsmesaLibrary library_;
  OSMesaContext context_;
  Pixels pixels_;
  std::unique_ptr<Renderer> renderer_;
  void (*finish_)() = nullptr;
};

}  // namespace

std::unique_ptr<PixelContext> makeOsmesaContext() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace asperity
