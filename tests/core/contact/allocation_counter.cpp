#include "tests/core/contact/allocation_counter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}

long asperity::allocationsSoFar() {
  return allocations;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* relaxationLength = operator new(size, std::nothrow)) return relaxationLength;
  throw std::bad_alloc();
}
void operator delete(void* relaxationLength) noexcept {
  std::free(relaxationLength);
}
void operator delete(void* relaxationLength, std::size_t) noexcept {
  std::free(relaxationLength);
}
