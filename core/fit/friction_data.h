// Measured coefficients of friction from a table of a user: columns of velocity and mu and, where
// present, of their errors, the normal force or the nominal pressure, the temperature and a label.
// The columns are recognized by name and unit (friction_columns.h, friction_roles.h).
// Pure; any thread. Failure: InputError that names the file and the row.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/message.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// One row of the table. A value that the table does not have is NaN: the scene's own value
/// applies.
struct MeasuredPoint {
  double velocity = 0;  // m/s, above 0
  double mu = 0;        // above 0; of deformation and interface together
  double muError = kNotApplicable;
  double velocityError = kNotApplicable;    // m/s
  double normalForce = kNotApplicable;      // N
  double nominalPressure = kNotApplicable;  // Pa
  double temperature = kNotApplicable;      // K
  std::string label{};
  int row = 0;  // the line of the file, counted from 1
};

struct FrictionData {
  std::string name{};  // for legends: as it was given, or the file's
  std::vector<MeasuredPoint> points{};
  std::vector<Message> notes{};  // how the columns were understood

  bool hasErrors() const { return !points.empty() && !std::isnan(points.front().muError); }
};

/// Returns the notes of all tables, each with the name of its table.
std::vector<Message> notesOf(std::span<const FrictionData> tables);

/// Read a table of at least two rows. The columns need names unless there are two (velocity and mu)
/// or three (with the error of mu). Units: those of SI with their usual prefixes; km/h; % for
/// errors (of mu: percentage points where mu is in %, else a share); degrees Celsius or Fahrenheit
/// if stated. Cells may have units of their own, and those of mu its standard error. Lines above
/// the table, such as "Temperature: 5 C", hold for all points where no column says otherwise; so do
/// those below the only table that state a load, a temperature or a velocity and nothing else,
/// where no line above does. label: replaces the file's name.
FrictionData readFrictionData(const std::filesystem::path& file, const std::string& label = {});
FrictionData parseFrictionData(std::string_view bytes, const std::string& name);

/// Returns the error of a fit without any table.
InputError missingFrictionData();

/// Returns whether a text has a table with named columns of a velocity and of a coefficient of
/// friction, or another one that is read as friction by its names.
bool isFrictionTable(std::string_view bytes);

/// Returns the scene at a measured point: in steady sliding at its velocity, with the force,
/// pressure and temperature of the table. Throws InputError with the row where the scene's
/// elastomer has no shift at this temperature.
Scene sceneAtPoint(const MeasuredPoint& point, const Scene& scene);

/// Returns the note on normal forces of a table that, on one period of the scene's line, are
/// nominal pressures far from that of the scene: a test states the force on its whole sample.
/// Nothing where the load of the scene is no pressure, or some force is near it.
std::optional<Message> forceNote(const FrictionData& data, const Scene& scene);

}  // namespace asperity
