#include "core/fit/friction_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

/// What each point has of its own where a column gives it, beside velocity and friction.
constexpr std::array kOfEachPoint{Quantity::MuError, Quantity::Force, Quantity::Pressure,
                                  Quantity::Temperature};

/// The numbers of a table in SI units, row by row.
class RowReader {
 public:
  RowReader(const TextBlock& block, const FrictionRoles& roles,
            const std::vector<HeaderStatement>& common, const std::string& name)
      : block_(block), roles_(roles), common_(common), name_(name) {
    for (const FrictionRole& column : roles.columns)
      if (isBelowZero(column)) negatives_.push_back(column.index);
    refuseEmptyColumns();
  }

  /// Returns notes on loads and friction that are below 0 in all rows.
  std::vector<Message> signNotes() const {
    std::vector<Message> notes;
    for (const FrictionRole& column : roles_.columns)
      if (isNegative(column))
        notes.push_back(message(
            "column {}: the {} is below 0 in all rows, by a convention of signs; its magnitude is "
            "taken",
            column.index + 1, Message(meaningOf(column.quantity))));
    return notes;
  }

  /// Returns the note on a coefficient of friction that contradicts the forces beside it
  /// (contradictingRatio).
  std::optional<Message> contradiction() const {
    if (!roles_.forceOfFriction) return {};
    const auto& [quantity, index, conversion, note] = *roles_.forceOfFriction;
    std::vector<double> ratios;
    for (std::size_t row = 0; row < block_.rows; ++row) {
      const double force = std::abs(conversion.unit.toSi(block_.at(row, index)));
      if (!std::isgreater(force, 0)) continue;
      const double ratio = valueAt(row, Quantity::Mu) * valueAt(row, Quantity::Force) / force;
      if (std::isgreater(ratio, 0)) ratios.push_back(ratio);
    }
    const auto ratio = contradictingRatio(std::move(ratios));
    if (!ratio) return {};
    return message(
        "column {} contradicts the forces: in the median it is {} times the force of friction in "
        "column {} over the normal force; it is read as the coefficient of friction",
        shortened(block_.columns[roles_.find(Quantity::Mu)->index].name), printed(*ratio, 3),
        shortened(block_.columns[index].name));
  }

  /// Returns the points; rows without a value in a column that is used are left out.
  std::vector<MeasuredPoint> read() const {
    std::vector<MeasuredPoint> points;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < block_.rows; ++row) {
      if (missingIn(row)) continue;
      points.push_back(pointAt(row));
      rows.push_back(row);
    }
    if (!roles_.repeats.empty() && !roles_.find(Quantity::MuError)) averageRepeats(rows, points);
    return points;
  }

  /// Returns notes on the rows that have values and are left out. A point without its own error,
  /// load or temperature has that of no other.
  std::vector<Message> leftOutNotes() const {
    std::vector<Message> notes;
    std::size_t count = 0;
    std::map<Quantity, std::string> lines;
    for (std::size_t row = 0; row < block_.rows; ++row) {
      const auto missing = missingIn(row);
      if (isBlank(row) || !missing) continue;
      if (missing == Quantity::Velocity || missing == Quantity::Mu)
        ++count;
      else
        appendItem(lines[*missing], std::to_string(block_.lines[row]));
    }
    if (count > 0) notes.push_back(message("rows without a value, left out: {}", count));
    for (const auto& [quantity, list] : lines)
      notes.push_back(message("rows left out, because the {} is missing: lines {}",
                              Message(meaningOf(quantity)), PrintedNumber{shortened(list)}));
    return notes;
  }

 private:
  [[noreturn]] void refuseRow(int row, const Message& what) const {
    throw InputError(name_, "", message("row {}: {}", row, what));
  }

  /// Returns the repeated measurements of a row.
  std::vector<double> repeatsOf(std::size_t row) const {
    std::vector<double> values;
    for (const std::size_t index : roles_.repeats)
      if (const double value = block_.at(row, index); !std::isnan(value))
        values.push_back(isNegative(*roles_.find(Quantity::Mu)) ? -value : value);
    return values;
  }

  /// Sets friction to the mean of its repeats. The relative scatter is that of all rows together,
  /// because that of a few values is itself uncertain.
  void averageRepeats(const std::vector<std::size_t>& rows,
                      std::vector<MeasuredPoint>& points) const {
    double squares = 0;
    std::size_t degreesOfFreedom = 0, i = 0;
    std::vector<std::size_t> counts;
    for (const std::size_t row : rows) {
      const std::vector<double> values = repeatsOf(row);
      for (const double value : values) squares += std::pow(value / points[i].mu - 1, 2);
      degreesOfFreedom += values.size() - 1;
      counts.push_back(values.size());
      ++i;
    }
    if (!(squares > 0)) return;
    for (i = 0; i < points.size(); ++i)
      points[i].muError = points[i].mu * std::sqrt(squares / static_cast<double>(degreesOfFreedom) /
                                                   static_cast<double>(counts[i]));
  }

  /// Returns the first quantity that a point needs and a row has no value of.
  std::optional<Quantity> missingIn(std::size_t row) const {
    for (const Quantity quantity : {Quantity::Velocity, Quantity::Mu})
      if (std::isnan(valueAt(row, quantity))) return quantity;
    for (const Quantity quantity : kOfEachPoint)
      if (roles_.find(quantity) && std::isnan(valueAt(row, quantity))) return quantity;
    return {};
  }

  /// Throws InputError for a column that would leave out all rows.
  void refuseEmptyColumns() const {
    for (const Quantity quantity : kOfEachPoint) {
      const FrictionRole* column = roles_.find(quantity);
      if (column && block_.rows > 0 && !block_.hasNumber(column->index))
        throw InputError(
            name_, "",
            message("column {}: the {} is missing in all rows; take the column out",
                    shortened(block_.label(column->index)), Message(meaningOf(quantity))));
    }
  }

  /// Returns whether a row has nothing but separators.
  bool isBlank(std::size_t row) const {
    for (std::size_t i = 0; i < block_.columns.size(); ++i)
      if (block_.columns[i].isText ? !block_.texts[i][row].empty() : !std::isnan(block_.at(row, i)))
        return false;
    return true;
  }

  bool isNegative(const FrictionRole& column) const {
    return std::ranges::find(negatives_, column.index) != negatives_.end();
  }

  /// Returns whether a column has loads below 0 in all rows, as load cells give compression, or
  /// friction, as force sensors give what acts against the motion.
  bool isBelowZero(const FrictionRole& column) const {
    const bool isFriction = column.quantity == Quantity::Mu && !column.conversion.isForce;
    if (!isFriction && column.quantity != Quantity::Force && column.quantity != Quantity::Pressure)
      return false;
    const bool areRepeats = isFriction && !roles_.repeats.empty();
    const std::vector<std::size_t> columns =
        areRepeats ? roles_.repeats : std::vector<std::size_t>{column.index};
    bool isNegative = false;
    for (const std::size_t index : columns)
      for (std::size_t row = 0; row < block_.rows; ++row) {
        const double value = block_.at(row, index);
        if (std::isgreaterequal(value, 0)) return false;
        isNegative = isNegative || std::isless(value, 0);
      }
    return isNegative;
  }

  /// Returns a value of a row; NaN where the column or the value is missing.
  double valueAt(std::size_t row, Quantity quantity, double whole = 1) const {
    const FrictionRole* column = roles_.find(quantity);
    if (!column) {
      const auto common = std::ranges::find(common_, quantity, &HeaderStatement::quantity);
      return common == common_.end() ? kNotApplicable : common->value;
    }
    if (quantity == Quantity::Mu && !roles_.repeats.empty()) {
      const std::vector<double> values = repeatsOf(row);
      return values.empty() ? kNotApplicable : mean(values);
    }
    const FrictionConversion& in = column->conversion;
    double number = block_.at(row, column->index);
    if (std::isnan(number)) return kNotApplicable;
    if (in.isVariance) number = std::sqrt(number);
    if (isNegative(*column)) number = -number;
    if (in.isForce) return std::abs(in.unit.toSi(number)) / valueAt(row, Quantity::Force);
    return in.unit.toSi(number) * (in.isShare ? whole : 1) / in.divisor;
  }

  MeasuredPoint pointAt(std::size_t row) const {
    MeasuredPoint point;
    point.row = static_cast<int>(block_.lines[row]);
    point.velocity = valueAt(row, Quantity::Velocity);
    point.mu = valueAt(row, Quantity::Mu);
    needPositive(point, point.velocity, Quantity::Velocity);
    needPositive(point, point.mu, Quantity::Mu);
    point.muError = valueAt(row, Quantity::MuError, point.mu);
    point.velocityError = valueAt(row, Quantity::VelocityError, point.velocity);
    point.normalForce = valueAt(row, Quantity::Force);
    point.nominalPressure = valueAt(row, Quantity::Pressure);
    point.temperature = valueAt(row, Quantity::Temperature);
    constexpr double kColdest = 120;  // K; below it no elastomer is rubbery
    // Degrees that were converted differ in the last digit.
    if (std::isless(point.temperature, kColdest))
      refuseRow(point.row,
                message("a temperature of {} K is too cold for rubber; name the unit, as "
                        "in \"temperature (C)\"",
                        plain(std::round(point.temperature * 1e6) / 1e6)));
    for (const auto& [quantity, value] : {std::pair{Quantity::MuError, point.muError},
                                          {Quantity::Force, point.normalForce},
                                          {Quantity::Pressure, point.nominalPressure},
                                          {Quantity::Temperature, point.temperature}})
      if (roles_.find(quantity)) needPositive(point, value, quantity);
    if (roles_.find(Quantity::VelocityError) && !std::isnan(point.velocityError) &&
        !(point.velocityError >= 0))
      refuseRow(point.row, "the error of the velocity is below 0");
    for (const FrictionRole& column : roles_.columns)
      if (column.quantity == Quantity::Label)
        appendItem(point.label, block_.texts[column.index][row]);
    return point;
  }

  void needPositive(const MeasuredPoint& point, double value, Quantity quantity) const {
    if (!(value > 0))
      refuseRow(point.row, message("the {} is {}, which is not above 0",
                                   Message(meaningOf(quantity)), plain(value)));
  }

  const TextBlock& block_;
  const FrictionRoles& roles_;
  const std::vector<HeaderStatement>& common_;
  const std::string& name_;
  std::vector<std::size_t> negatives_;  // columns below 0 in all rows
};

/// Leaves the force on the whole sample out where a test states its nominal pressure, too: the
/// pressure does not depend on the sample. Returns the note on it. Throws InputError where the two
/// are not proportional, so that they are not the load on one sample.
Message keepPressures(std::vector<MeasuredPoint>& points, const std::string& name) {
  constexpr double kAgree = 1.15;  // one of the two may be a nominal value
  Extent areas;
  for (MeasuredPoint& point : points) {
    areas.add(point.normalForce / point.nominalPressure);
    point.normalForce = kNotApplicable;
  }
  constexpr double kSquareCentimetres = 1e4;  // in a square metre
  const auto from = printed(areas.least * kSquareCentimetres, 3),
             to = printed(areas.most * kSquareCentimetres, 3);
  if (!(areas.most <= kAgree * areas.least))
    throw InputError(
        name, "",
        message("has both a normal force and a nominal pressure, which are not those of one "
                "sample: their quotient is {} to {} cm\u00B2; take the column out that does not "
                "say the load",
                from, to));
  return message(
      "the nominal pressure says the load; the normal force, on a sample of {} cm\u00B2, is not "
      "used",
      to);
}

}  // namespace

FrictionRows readRows(const TextBlock& block, const FrictionRoles& roles,
                      const std::vector<HeaderStatement>& common, const std::string& name) {
  const RowReader reader(block, roles, common, name);
  FrictionRows rows{reader.read(), reader.leftOutNotes()};
  if (rows.points.size() < 2 && !rows.notes.empty())
    throw InputError(name, "",
                     message("has {} row of numbers; at least 2 are needed ({})",
                             rows.points.size(), rows.notes.back()));
  std::ranges::move(reader.signNotes(), std::back_inserter(rows.notes));
  if (const auto note = reader.contradiction()) rows.notes.push_back(*note);
  if (!rows.points.empty() && roles.find(Quantity::Force) && roles.find(Quantity::Pressure))
    rows.notes.push_back(keepPressures(rows.points, name));
  return rows;
}

}  // namespace asperity
