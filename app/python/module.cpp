// The module itself, its errors, and the dictionary of columns.
#include "app/python/module.h"

#include <algorithm>
#include <string>

#include "app/python/call.h"
#include "app/vector_target.h"
#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "core/measured/measured_file.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

namespace py = pybind11;

py::object textOrNone(const std::string& text) {
  return text.empty() ? py::object(py::none()) : py::object(py::str(text));
}

/// An option of the command line is an argument of a Python function.
std::string argumentName(std::string key) {
  if (!key.starts_with("--")) return key;
  key.erase(0, 2);
  std::ranges::replace(key, '-', '_');
  return key;
}

/// The class of bad input: kept for ever, like the module.
py::handle inputErrorClass;

void raise(const InputError& error) {
  const std::string key = argumentName(error.key());
  const std::string file = error.file() == "--set" ? std::string() : error.file();
  const InputError shown(file, key, error.message());
  const py::object made = inputErrorClass(shown.what());
  made.attr("file") = textOrNone(file);
  made.attr("key") = textOrNone(key);
  made.attr("message") = error.message().english();
  PyErr_SetObject(inputErrorClass.ptr(), made.ptr());
}

py::list columnDictionary() {
  py::list all;
  for (const Column& column : kColumns) {
    py::dict entry;
    entry["name"] = std::string(column.name);
    entry["unit"] = std::string(column.unit);
    entry["meaning"] = std::string(column.meaning);
    entry["equation"] = std::string(column.equation);
    entry["tables"] = std::string(column.tables);
    all.append(entry);
  }
  return all;
}

void addErrors(py::module_& module) {
  py::dict members;
  members["file"] = py::none();
  members["key"] = py::none();
  members["message"] = "";
  members["__module__"] = "asperity";
  inputErrorClass = PyErr_NewExceptionWithDoc(
      "asperity.InputError",
      "Bad input, with the program's own message.\n\n"
      "file: the file that is wrong, or None; key: the key of a scene or the argument, or None;\n"
      "message: what is wrong with it and what is allowed.",
      PyExc_ValueError, members.ptr());
  module.attr("InputError") = inputErrorClass;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise(error);
    } catch (const StopRequested&) {
      PyErr_SetString(PyExc_RuntimeError, "the computation was stopped");
    }
  });
}

}  // namespace
}  // namespace asperity

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace asperity;
  module.doc() = "What asperity/__init__.py is made of; use the package, not this module.";
  addErrors(module);
  chooseVectorTarget();
  addScene(module);
  addFriction(module);
  addContact(module);
  addMaterial(module);
  module.attr("version") = ASPERITY_VERSION;
  module.def("columns", &columnDictionary);
  py::module_::import("atexit").attr("register")(py::cpp_function(&joinDetachedThreads));
}
