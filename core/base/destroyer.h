// Ownership of the objects of C libraries.
#pragma once

namespace asperity {

/// Destroys an object of a C library by its function: the deleter of a std::unique_ptr.
template <auto destroy>
struct Destroyer {
  template <typename T>
  void operator()(T* object) const {
    destroy(object);
  }
};

}  // namespace asperity
