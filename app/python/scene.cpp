// Scenes for Python: read, changed and looked up by the keys of the table of parameters, with the
// program's own validation.
#include <pybind11/stl.h>

#include "app/python/module.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "core/scene/range.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Assignments = std::vector<std::string>;

/// Returns "real", "whole", "choice", "text" or "list".
const char* fieldKind(const Parameter& row) {
  if (std::holds_alternative<RealField>(row.field)) return "real";
  if (std::holds_alternative<IntegerField>(row.field)) return "whole";
  if (std::holds_alternative<ChoiceField>(row.field)) return "choice";
  return isList(row) ? "list" : "text";
}

py::object toObject(const ParameterValue& value) {
  return std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
}

py::object valueIn(const Scene& scene, const std::string& key) {
  const Parameter& row = knownParameter(key);
  if (!isApplicable(row, scene)) throw InputError("", key, "has no meaning in this scene");
  return toObject(parameterValue(row, scene));
}

py::list applicableKeys(const Scene& scene) {
  py::list keys;
  for (const Parameter& row : parameters())
    if (isApplicable(row, scene)) keys.append(std::string(row.key));
  return keys;
}

py::object numberFromWord(const std::string& key, const std::string& text) {
  const Parameter& row = numberRow(key);
  const double number = parseNumber(row, text);
  if (std::holds_alternative<IntegerField>(row.field))
    return py::int_(static_cast<std::int64_t>(number));
  return py::float_(number);
}

/// Returns whether two scenes are equivalent: their folders matter only where they name files.
bool areEqual(const Scene& a, Scene b) {
  const bool hasFiles =
      hasSurfaceFile(a.surface) || !a.elastomer.material.empty() || !a.comparison.data.empty();
  if (!hasFiles) b.folder = a.folder;
  return a == b;
}

py::list parameterTable() {
  py::list all;
  for (const Parameter& row : parameters()) {
    py::dict entry;
    entry["key"] = std::string(row.key);
    entry["kind"] = fieldKind(row);
    entry["label"] = std::string(row.label);
    entry["symbol"] = std::string(row.symbol);
    entry["unit"] = std::string(row.unit);
    entry["allowed"] = allowedText(row).english();
    entry["default"] = toObject(defaultValue(row));
    entry["meaning"] = std::string(row.sentence);
    all.append(entry);
  }
  return all;
}

/// Returns the values of a range such as "1mN:1N:20:log" in the key's unit.
std::vector<double> sweptValues(const Scene& scene, const std::string& key,
                                const std::string& text) {
  const ParameterRange range = parseRange(key, text);
  checkRange(range, scene);
  return rangeValues(range);
}

}  // namespace

void addScene(py::module_& module) {
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene")
      .def(py::init([](const std::string& json, const std::string& name, const std::string& folder,
                       const Assignments& assignments) {
        return std::make_shared<Scene>(readScene(json, name, folder, assignments));
      }))
      .def(py::init([](const std::string& file, const Assignments& assignments) {
        return std::make_shared<Scene>(readSceneFile(file, assignments));
      }))
      .def(py::init([](const Scene& scene) { return std::make_shared<Scene>(scene); }))
      .def("assign",
           [](Scene& scene, const Assignments& assignments) {
             scene = changedScene(scene, assignments, "");
           })
      .def("value", &valueIn)
      .def("keys", &applicableKeys)
      .def("json", &writeScene)
      .def_property_readonly("folder", [](const Scene& scene) { return scene.folder.string(); })
      .def("__eq__", &areEqual);
  module.def("found_scene", [](const std::string& file) {
    return std::make_shared<Scene>(findScene(std::filesystem::path(file)).scene);
  });
  module.def("kind", [](const std::string& key) { return fieldKind(knownParameter(key)); });
  module.def("is_key", [](const std::string& key) { return findParameter(key) != nullptr; });
  module.def("nearest_word", [](const std::string& word, const std::vector<std::string>& known) {
    return std::string(
        nearestWord(word, std::vector<std::string_view>(known.begin(), known.end())));
  });
  module.def("number", &numberFromWord);
  module.def("parameters", &parameterTable);
  module.def("range_values", &sweptValues);
}

}  // namespace asperity
