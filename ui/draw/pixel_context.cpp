#include "ui/draw/pixel_context.h"

#include <stdexcept>

namespace asperity {
namespace {

constexpr int kLargest = 16384;  // pixels per side, the limit of OpenGL in software, too

}  // namespace

std::unique_ptr<PixelContext> makePixelContext(PixelBackend backend) {
  if (backend == PixelBackend::Egl) return makeEglContext();
  if (backend == PixelBackend::Osmesa) return makeOsmesaContext();
  return makeRasterContext();
}

PixelContext& contextOfThread() {
  thread_local const std::unique_ptr<PixelContext> context = makePixelContext();
  return *context;
}

void checkPictureSize(const DrawList& list) {
  if (list.width <= 0 || list.height <= 0)
    throw std::runtime_error("A picture needs a width and a height of at least one pixel.");
  if (list.width > kLargest || list.height > kLargest)
    throw std::runtime_error("A picture may be at most " + std::to_string(kLargest) +
                             " pixels wide and high.");
}

}  // namespace asperity
