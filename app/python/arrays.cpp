#include "app/python/arrays.h"

#include <pybind11/stl.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/friction/curve_file.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

/// Gathers rows of a table, which all have the same names.
class ColumnsOfRows {
 public:
  void add(const Json& row) {
    if (columns_.empty())
      for (const auto& [name, cell] : row.items()) columns_.push_back({name, {}, {}, true});
    for (Column& column : columns_) {
      const Json& cell = row.at(column.name);
      column.isWhole = column.isWhole && cell.is_number_integer();
      column.numbers.push_back(cell.is_number() ? cell.get<double>() : kNotApplicable);
      if (!cell.is_string() && column.texts.empty()) continue;
      column.texts.resize(column.numbers.size());
      if (cell.is_string()) column.texts.back() = cell.get<std::string>();
    }
  }

  py::dict take() {
    py::dict columns;
    for (Column& column : columns_) columns[py::str(column.name)] = toObject(column);
    return columns;
  }

 private:
  struct Column {
    std::string name;
    std::vector<double> numbers;
    std::vector<std::string> texts;  // empty: there are none
    bool isWhole;
  };

  static py::object toObject(Column& column) {
    if (!column.texts.empty()) return py::cast(column.texts);
    if (!column.isWhole) return toArray(std::move(column.numbers));
    std::vector<std::int64_t> whole;
    for (const double number : column.numbers) whole.push_back(std::llround(number));
    return toArray(std::move(whole));
  }

  std::vector<Column> columns_;
};

}  // namespace

py::array arrayView(const std::vector<double>& numbers, const py::object& owner) {
  py::array_t<double> view(static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

py::dict toColumns(const Json& rows) {
  ColumnsOfRows columns;
  for (const Json& row : rows) columns.add(row);
  return columns.take();
}

py::dict toColumns(const std::vector<CurvePoint>& points) {
  return toColumns(tableJson(CurveTable(points, {}).of(points)));
}

}  // namespace asperity
