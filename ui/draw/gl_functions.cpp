#include "ui/draw/gl_functions.h"

#include <stdexcept>
#include <string>

namespace asperity {
namespace {

void* find(const ProcAddress& procAddress, const char* name) {
  if (void* address = procAddress(name)) return address;
  throw std::runtime_error("OpenGL 3.3 is needed, but this one has no " + std::string(name) + ".");
}

}  // namespace

GlFunctions::GlFunctions(const ProcAddress& procAddress) {
#define ASPERITY_GL_FIND(Type, member, name) \
  member = reinterpret_cast<Type>(find(procAddress, name));
  ASPERITY_GL_FUNCTIONS(ASPERITY_GL_FIND)
#undef ASPERITY_GL_FIND
}

}  // namespace asperity
