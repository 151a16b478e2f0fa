// A library that is opened at run time, once in the process, and never closed, because its threads
// outlive any context. Its names stay invisible to other libraries. Private to ui/draw. Failure:
// std::runtime_error in one sentence with the names of the library and its package.
#pragma once

#include <string>

namespace asperity {

class SharedLibrary {
 public:
  /// Loads the library. `variable`: an environment variable that names another file.
  SharedLibrary(const char* file, const char* variable, const char* package);

  template <typename Function>
  void find(Function& function, const char* symbol) const {
    function = reinterpret_cast<Function>(address(symbol));
  }
  const std::string& name() const { return name_; }

 private:
  void* address(const char* symbol) const;

  std::string name_;
  void* handle_ = nullptr;
};

}  // namespace asperity
