// Contacts, motions and surfaces for Python.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "app/python/arrays.h"
#include "app/python/call.h"
#include "app/python/module.h"
#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "core/measured/measured_file.h"
#include "core/run/motion_table.h"
#include "core/run/rigid_line.h"
#include "core/run/steady_frames.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

// ---- one contact

/// A steady contact of one line at the scene's own points. Immutable: arrays are views of it.
struct Contact {
  Scene scene;
  SteadyResult result;
  Frame frame;
  std::vector<double> position, gap;  // m
};

/// A stop is noticed between the steps, each of which takes memory of its own.
std::shared_ptr<Contact> findContact(const Scene& scene, std::int64_t realization,
                                     const std::stop_token& stop) {
  requireSteadySliding(scene, "asperity.state");
  if (realization != 0) LineSource(scene, 1).requireRealization(realization, "--realization");
  const auto contact = std::make_shared<Contact>();
  contact->scene = scene;
  const SteadySolver sliding(scene);
  const RigidLine rigid(scene, realization);
  throwIfStopped(stop);
  const SteadyState state = sliding.at(rigid.prepared, scene.sliding.velocity);
  throwIfStopped(stop);
  requireBalance(state.result, scene.sliding.velocity);
  contact->result = state.result;
  contact->frame = stillFrame(std::make_shared<const Scene>(scene), rigid, sliding, state,
                              state.result, {true, true, true});
  const Frame& frame = contact->frame;
  for (std::size_t i = 0; i < frame.lineHeight.size(); ++i) {
    contact->position.push_back(static_cast<double>(i) * frame.spacing);
    const bool touches = frame.pressure[i] > 0;
    contact->gap.push_back(touches ? 0 : frame.lineHeight[i] - frame.surfaceHeight[i]);
  }
  return contact;
}

/// Returns a function that makes an array of a vector in what was found, without a copy.
template <class Found, class Member>
auto viewed(Member member) {
  return [member](const py::object& self) {
    return arrayView(std::invoke(member, self.cast<const Found&>()), self);
  };
}

void addContactClass(py::module_& module) {
  const auto ofFrame = [](std::vector<double> Frame::*field) {
    return viewed<Contact>([field](const Contact& contact) -> const std::vector<double>& {
      return contact.frame.*field;
    });
  };
  const auto ofResult = [](double SteadyResult::*field) {
    return [field](const Contact& contact) { return contact.result.*field; };
  };
  py::class_<Contact, std::shared_ptr<Contact>>(module, "Contact")
      .def_property_readonly("x", viewed<Contact>(&Contact::position))
      .def_property_readonly("z", ofFrame(&Frame::lineHeight))
      .def_property_readonly("u", ofFrame(&Frame::surfaceHeight))
      .def_property_readonly("gap", viewed<Contact>(&Contact::gap))
      .def_property_readonly("p", ofFrame(&Frame::pressure))
      .def_property_readonly("slope", ofFrame(&Frame::lineSlope))
      .def_property_readonly("time_since_contact", ofFrame(&Frame::sinceContact))
      .def_property_readonly("power", ofFrame(&Frame::power))
      .def_property_readonly("length", [](const Contact& contact) { return contact.frame.length; })
      .def_property_readonly("spacing",
                             [](const Contact& contact) { return contact.frame.spacing; })
      .def_property_readonly("velocity",
                             [](const Contact& contact) { return contact.frame.velocity; })
      .def_property_readonly("indentation", ofResult(&SteadyResult::indentation))
      .def_property_readonly("normal_force", ofResult(&SteadyResult::normalForce))
      .def_property_readonly("tangential_force", ofResult(&SteadyResult::tangentialForce))
      .def_property_readonly("mu", ofResult(&SteadyResult::mu))
      .def_property_readonly("mu_interface", ofResult(&SteadyResult::muInterface))
      .def_property_readonly("contact_fraction", ofResult(&SteadyResult::contactFraction))
      .def_property_readonly("rms_slope_contact", ofResult(&SteadyResult::rmsSlopeContact))
      .def_property_readonly("power_dissipated", ofResult(&SteadyResult::powerDissipated))
      .def_property_readonly("residual", ofResult(&SteadyResult::residual))
      .def("scene", [](const Contact& contact) { return contact.scene; });
}

// ---- motions

struct MotionOfScene {
  Scene scene;
  MotionTable table;
};

std::shared_ptr<MotionOfScene> runMotion(const Scene& scene, std::int64_t every, std::int64_t lines,
                                         int threads, const py::object& progress) {
  checkThreads(threads);
  if (every < 1) throw InputError("", "--every", "is below 1");
  if (lines < 1) throw InputError("", "--lines", "is below 1");
  return compute(progress, [scene, every, lines, threads](const Call& call) {
    MotionOptions options{
        .every = every,
        .lines = lines,
        .threads = threads,
        .stop = call.stop(),
        .progress = [&call](std::int64_t done, std::int64_t total) { call.report(done, total); }};
    return std::make_shared<MotionOfScene>(MotionOfScene{scene, marchMotion(scene, options)});
  });
}

py::dict motionArrays(const MotionOfScene& found) {
  py::dict columns;
  for (MotionValues& column : motionColumns(found.table))
    columns[py::str(column.name)] = toArray(std::move(column.values));
  std::vector<std::int64_t> realization;
  for (std::size_t line = 0; line < found.table.lines.size(); ++line)
    realization.insert(realization.end(), found.table.lines[line].size(),
                       static_cast<std::int64_t>(line));
  columns["realization"] = toArray(std::move(realization));
  return columns;
}

// ---- surfaces

struct SurfaceOfScene {
  Scene scene;
  Line line;
  bool isFirst = true;           // of the realizations, as the program writes it
  std::vector<double> position;  // m
  std::string json;
  Texts facts;

  /// The options of its tables; none where the program does not make them.
  Json options() const { return isFirst ? Json::object() : Json(); }
};

std::shared_ptr<SurfaceOfScene> makeSurface(const Scene& scene, bool isOfFile,
                                            std::int64_t realization, const std::stop_token& stop) {
  const LineSource source(scene, writtenPointsPerElement(scene, isOfFile));
  source.requireRealization(realization, "--realization");
  const auto found = std::make_shared<SurfaceOfScene>();
  found->scene = scene;
  found->line = source.make(realization);
  found->isFirst = realization == 0;
  throwIfStopped(stop);
  const ProvenanceOptions given(found->options());
  std::optional<MeasuredSummary> measured;
  if (source.measured()) measured = measuredSummary(scene, source);
  found->json = surfaceJson(scene, source, found->line, measured ? &*measured : nullptr);
  throwIfStopped(stop);
  for (std::size_t i = 0; i < found->line.nodes(); ++i)
    found->position.push_back(static_cast<double>(i) * found->line.spacing);
  found->facts = englishOf(measured ? factsOf(*measured) : source.spectrumFacts());
  return found;
}

}  // namespace

void addContact(py::module_& module) {
  addContactClass(module);
  py::class_<MotionOfScene, std::shared_ptr<MotionOfScene>>(module, "Motion")
      .def("columns", &motionArrays)
      .def("scene", [](const MotionOfScene& found) { return found.scene; })
      .def("csv",
           [](const MotionOfScene& found) {
             const ProvenanceOptions own(Json::object());  // which has them all
             return provenanceComment(motionProvenance("motion", found.scene, found.table)) +
                    motionCsv(found.table);
           })
      .def("json",
           [](const MotionOfScene& found) {
             const ProvenanceOptions own(Json::object());
             return motionJson(found.scene, found.table);
           })
      .def("mu_error", [](const MotionOfScene& found) { return found.table.muError; })
      .def("relative_error", [](const MotionOfScene& found) { return found.table.relativeError; });
  const auto ofLine = [](std::vector<double> Line::*field) {
    return viewed<SurfaceOfScene>(
        [field](const SurfaceOfScene& found) -> const std::vector<double>& {
          return found.line.*field;
        });
  };
  py::class_<SurfaceOfScene, std::shared_ptr<SurfaceOfScene>>(module, "Surface")
      .def("position", viewed<SurfaceOfScene>(&SurfaceOfScene::position))
      .def("height", ofLine(&Line::height))
      .def("slope", ofLine(&Line::slopeAfter))
      .def("scene", [](const SurfaceOfScene& found) { return found.scene; })
      .def("facts", [](const SurfaceOfScene& found) { return found.facts; })
      .def("csv",
           [](const SurfaceOfScene& found) {
             const ProvenanceOptions given(found.options());
             return provenanceComment("surface", found.scene) + lineCsv(found.line);
           })
      .def("json", [](const SurfaceOfScene& found) { return found.json; });
  module.def("state", [](const Scene& scene, std::int64_t realization, const py::object& progress) {
    return compute(progress, [scene, realization](const Call& call) {
      return findContact(scene, realization, call.stop());
    });
  });
  module.def("march", &runMotion);
  module.def("is_surface_file", [](const std::string& name) { return isSurfaceFile(name); });
  module.def("surface_file_scene", [](const std::string& file, const Texts& assignments) {
    return std::make_shared<Scene>(surfaceFileScene(file, assignments));
  });
  module.def("surface", [](const Scene& scene, const std::string& file, std::int64_t realization,
                           const py::object& progress) {
    return compute(progress, [scene, file, realization](const Call& call) {
      const auto make = [&] { return makeSurface(scene, !file.empty(), realization, call.stop()); };
      return file.empty() ? make() : withSurfaceFile(file, make);
    });
  });
}

}  // namespace asperity
