// The parts of the Python module `asperity._core`. The package asperity/__init__.py wraps them in
// its public functions; nothing else uses them.
#pragma once

#include <pybind11/pybind11.h>

namespace asperity {

void addScene(pybind11::module_& module);
void addFriction(pybind11::module_& module);
void addContact(pybind11::module_& module);
void addMaterial(pybind11::module_& module);

}  // namespace asperity
