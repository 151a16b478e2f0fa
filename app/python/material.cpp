// Materials from measured moduli for Python, with the options of `asperity material` as arguments.
#include <pybind11/stl.h>

#include <algorithm>

#include "app/python/call.h"
#include "app/python/module.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/material/material_options.h"
#include "core/material/material_summary.h"
#include "core/scene/material_tables.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Texts = std::vector<std::string>;

/// Puts the options into the order of the program, not of the arguments.
MaterialChoices orderedChoices(WrittenOptions options) {
  const auto names = materialOptionNames();
  for (const auto& [name, value] : options) {
    if (isOneOf(name, names)) continue;
    const std::string_view nearest = nearestWord(name, names);
    std::string argument(nearest.empty() ? nearest : nearest.substr(2));
    std::ranges::replace(argument, '-', '_');
    throw InputError(
        "", name,
        argument.empty()
            ? message("unknown argument of asperity.material")
            : message("unknown argument of asperity.material; did you mean {}?", argument));
  }
  std::ranges::stable_sort(options, {}, [names](const auto& option) {
    return std::ranges::find(names, std::string_view(option.first)) - names.begin();
  });
  return materialChoices(options);
}

}  // namespace

void addMaterial(py::module_& module) {
  py::class_<Material, std::shared_ptr<Material>>(module, "Material")
      .def("json", &materialJson)
      .def("summary", [](const Material& material) { return englishOf(materialSummary(material)); })
      .def("is_measured", &Material::isMeasured)
      .def("prony_csv", &pronyCsv)
      .def("isotherms_csv", &isothermsCsv)
      .def("shifts_csv", &shiftsCsv);
  module.def("material", [](const std::string& file, const WrittenOptions& options,
                            const py::object& progress) {
    const MaterialChoices choices = orderedChoices(options);
    return compute(progress, [file, choices](const Call&) {
      return std::make_shared<Material>(readMaterial(file, choices));
    });
  });
}

}  // namespace asperity
