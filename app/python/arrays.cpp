#include "app/python/arrays.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/friction/curve_file.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

py::object columnOf(const Json& rows, const std::string& name) {
  bool isText = false, isWhole = true;
  for (const Json& row : rows) {
    const Json& cell = row.at(name);
    isText = isText || cell.is_string();
    isWhole = isWhole && cell.is_number_integer();
  }
  if (isText) {
    py::list texts;
    for (const Json& row : rows)
      texts.append(row.at(name).is_string() ? row.at(name).get<std::string>() : std::string());
    return texts;
  }
  if (isWhole) {
    std::vector<std::int64_t> numbers;
    for (const Json& row : rows) numbers.push_back(row.at(name).get<std::int64_t>());
    return arrayOf(std::move(numbers));
  }
  std::vector<double> numbers;
  for (const Json& row : rows) {
    const Json& cell = row.at(name);
    numbers.push_back(cell.is_number() ? cell.get<double>() : kNotApplicable);
  }
  return arrayOf(std::move(numbers));
}

}  // namespace

py::array viewOf(const std::vector<double>& numbers, const py::object& owner) {
  py::array_t<double> view(static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

py::dict columnsOf(const Json& rows) {
  py::dict columns;
  if (rows.empty()) return columns;
  for (const auto& [name, first] : rows.front().items())
    columns[py::str(name)] = columnOf(rows, name);
  return columns;
}

py::dict columnsOf(const std::vector<CurvePoint>& points) {
  // A table looks at the first point of each curve for what further columns there are: each point
  // is a curve of its own.
  std::vector<std::vector<CurvePoint>> single;
  std::vector<const std::vector<CurvePoint>*> curves;
  single.reserve(points.size());
  for (const CurvePoint& point : points) curves.push_back(&single.emplace_back(1, point));
  const CurveTable table(curves);
  Json rows = Json::array();
  for (const CurvePoint& point : points) rows.push_back(table.json(point));
  return columnsOf(rows);
}

}  // namespace asperity
