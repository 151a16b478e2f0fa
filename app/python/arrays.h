// Numbers of C++ as arrays of numpy, without copies: an array owns the vector that it was made of,
// or keeps alive the object that it is a view of. numpy is imported with the first array.
// Called with the interpreter's lock.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/friction/curve_point.h"

namespace asperity {

/// Returns an array of the vector's own memory.
template <class Number>
pybind11::array toArray(std::vector<Number> numbers) {
  auto* kept = new std::vector<Number>(std::move(numbers));
  const pybind11::capsule owner(kept,
                                [](void* held) { delete static_cast<std::vector<Number>*>(held); });
  return pybind11::array_t<Number>(static_cast<pybind11::ssize_t>(kept->size()), kept->data(),
                                   owner);
}

/// Returns an array that shows numbers of `owner`, which it keeps alive. It cannot be written to.
pybind11::array arrayView(const std::vector<double>& numbers, const pybind11::object& owner);

/// Returns the columns of a list of JSON objects with the same names: real and whole numbers as
/// arrays, null as NaN, texts as a list.
pybind11::dict toColumns(const nlohmann::ordered_json& rows);

/// Returns the columns of a curve's table for states that need not be of one curve: a further
/// column is there where any of them has it.
pybind11::dict toColumns(const std::vector<CurvePoint>& points);

}  // namespace asperity
