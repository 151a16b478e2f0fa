// Friction curves as text: the columns of one table as CSV, the same with scene, version and seed
// as JSON; and the table of the single lines behind a curve. Numbers have the shortest form that
// reads back to the same value; a value that does not apply is empty in CSV and null in JSON. Equal
// curves give equal bytes. Pure functions, and plain values for one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/data_table.h"
#include "core/scene/scene.h"

namespace asperity {

/// Return the notes on a point, in words of the column `notes` (core/scene/notes.h) separated by
/// blanks; empty for most points.
/// `unresolved_friction`: more than half of the friction by Eq. (4) is the work of the elastic
/// pressure, which should cancel: too few of the paper's elements bear the load, and mu is the
/// error of their sum, with either sign. `extrapolated_material`: friction rests on frequencies at
/// which the elastomer was not measured; `extrapolated_temperature`: on such a temperature.
/// `few_contacts` occurs only in tables of scenes that list contacts; the set has it for all.
std::string pointNotes(const CurvePoint& point);
NoteSet pointNoteSet(const CurvePoint& point);

/// Returns the names of all columns of a curve that are numbers, in the order of the tables.
std::vector<std::string_view> curveColumns();
/// Returns the number in a column; NaN where it does not apply.
double curveValue(const CurvePoint& point, std::string_view column);

/// What the columns of a table depend on besides its points.
struct CurveColumns {
  /// The key over which the curves go. Another one than velocity gives the first column, named by
  /// its last word, and the columns of forces.
  std::string sweptKey{kVelocityKey};
  bool hasForces = false;  // normal and tangential force, power and pressure in contact

  /// Returns the name of the first column.
  std::string_view sweptColumn() const;
};

/// Returns what a table of the scene's curve needs.
CurveColumns columnsFor(const Scene& scene, bool hasForces = false);

/// The columns of a table that may contain several curves: the columns of every curve, and further
/// ones (local friction, an interval, notes, ...) where one of the curves needs them.
class CurveTable {
 public:
  /// Makes the columns of every curve alone, those of the files of figures.
  CurveTable() = default;
  explicit CurveTable(std::span<const std::vector<CurvePoint>* const> curves,
                      CurveColumns columns = {});
  /// Makes the columns for rows that are no curve, because they differ in more than one key: a
  /// further column is there where any row has it, forces included. Columns with these names are
  /// left out.
  CurveTable(const std::vector<CurvePoint>& rows, std::vector<std::string> without);

  /// Return the names of the columns and the cells of one row, after those of a table's own.
  std::vector<std::string> header(std::vector<std::string> own = {}) const;
  std::vector<TableCell> row(const CurvePoint& point, std::vector<TableCell> own = {}) const;

  /// Returns the table of these points.
  DataTable of(const std::vector<CurvePoint>& points) const;

 private:
  bool isLeftOut(std::string_view column) const;
  bool isOfVelocity() const { return columns_.sweptKey == kVelocityKey; }
  double extraValue(std::size_t i, const CurvePoint& point) const;

  CurveColumns columns_;
  std::vector<std::size_t> extra_;  // indices in the list of further columns
  std::vector<std::string> without_;
  bool hasNotes_ = false;
};

/// Returns the table of a curve, with a column of notes where a point has one.
DataTable curveTable(const std::vector<CurvePoint>& points, const CurveColumns& columns);
std::string curveCsv(const std::vector<CurvePoint>& points, const CurveColumns& columns = {});
std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene,
                      bool hasForces = false);

/// The values of each random line behind a curve, of which its means and standard errors are made.
class RealizationTable {
 public:
  /// velocities: of the sweep, m/s.
  explicit RealizationTable(std::vector<double> velocities);

  /// Adds a realization's results at the velocities, in their order.
  void add(std::int64_t realization, std::span<const SteadyResult> results);

  /// Returns one row for each line and velocity: realization, velocity, mu, mu_interface,
  /// contact_fraction, rms_slope_contact, indentation, normal_force, tangential_force, rms_slope.
  const DataTable& table() const { return table_; }

 private:
  std::vector<double> velocities_;
  DataTable table_;
};

}  // namespace asperity
