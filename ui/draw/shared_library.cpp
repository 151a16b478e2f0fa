#include "ui/draw/shared_library.h"

#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>

namespace asperity {

SharedLibrary::SharedLibrary(const char* file, const char* variable, const char* package)
    : name_(file) {
  if (const char* other = std::getenv(variable); other != nullptr && *other != '\0') name_ = other;
  // With RTLD_LOCAL the gl* names stay invisible to the window's libraries.
  handle_ = dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ != nullptr) return;
  const char* reason = dlerror();
  throw std::runtime_error("Pictures need the library " + name_ + " (package " + package +
                           "): " + (reason != nullptr ? reason : "it cannot be opened") + ".");
}

void* SharedLibrary::address(const char* symbol) const {
  void* found = dlsym(handle_, symbol);
  if (found == nullptr)
    throw std::runtime_error("The library " + name_ + " is too old for pictures: it has no " +
                             symbol + ".");
  return found;
}

}  // namespace asperity
