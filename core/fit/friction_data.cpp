#include "core/fit/friction_data.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/column_units.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_table.h"
#include "core/fit/friction_columns.h"
#include "core/fit/friction_header.h"
#include "core/fit/friction_preparation.h"
#include "core/fit/friction_roles.h"
#include "core/fit/friction_rows.h"
#include "core/material/table_forms.h"
#include "core/material/temperature_shift.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

bool hasFriction(const TextBlock& block) {
  bool hasVelocity = false, hasMu = false;
  for (const TextColumn& column : block.columns) {
    const std::optional<Quantity> quantity = findMeaning(column);
    hasVelocity = hasVelocity || quantity == Quantity::Velocity;
    hasMu = hasMu || quantity == Quantity::Mu;
  }
  return hasVelocity && hasMu;
}

/// Reads the blocks of a text and prepares their columns. notes: on how the table was understood.
TextTable readTable(std::string_view bytes, const std::string& name, std::vector<Message>& notes) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  options.textColumns = {"label", "sample",  "name", "set",  "series",      "specimen",
                         "track", "surface", "run",  "lauf", "wiederholung"};
  TextTable table = readTextTable(bytes, name, options);
  notes = repeatNames(table, hasFriction, [](const std::string& word, const std::string& unit) {
    return stateNamed(word.empty() ? meaningOf(Quantity::Temperature) : word, unit);
  });
  transposeRows(table, hasFriction, notes);
  undoLogarithms(table, [](const std::string& quantity) {
    return findMeaning(quantity, kAnyUnit).has_value();
  });
  for (TextBlock& block : table.blocks) prepareColumns(block);
  moveListsAbove(table);
  return table;
}

/// Returns the decimal mark of a table. A table of whole numbers shows none; where it may be a mark
/// of thousands, a note says which one is taken.
HeaderMark decimalMark(const TextBlock& block, const TextDialect& dialect) {
  const bool hasDecimals = std::ranges::any_of(block.values, [](double value) {
    return std::isfinite(value) && value != std::floor(value);
  });
  return {dialect.decimal, hasDecimals || dialect.isUnclear};
}

/// Throws InputError for loads and temperatures in the cells of another table than that of
/// friction: they may be what holds for all points.
void refuseStatements(const TextBlock& block, const std::string& name) {
  for (const std::vector<TextCell>& cells : block.cells)
    for (std::size_t row = 0; row < cells.size(); ++row)
      if (const auto quantity = quantityOfUnit(cells[row].unit))
        throw InputError(
            name, "",
            message("line {}: '{}' may state the {}, but is not understood; write "
                    "it as \"name: value\", or take the line out",
                    block.lines[row], shortened(cells[row].text), Message(meaningOf(*quantity))));
}

/// Returns notes on how the columns were understood, and which ones were ignored. isOnly: the lines
/// above the table state what holds for all points of the file.
std::vector<Message> notesOn(const TextBlock& block, const FrictionRoles& roles,
                             const HeaderStatements& header, HeaderMark mark, bool isOnly) {
  std::vector<Message> notes{roles.columns.front().note};
  for (std::size_t i = 1; i < roles.columns.size(); ++i)
    notes.front() = message("{}; {}", notes.front(), roles.columns[i].note);
  for (const HeaderStatement& one : header.common) {
    const Message quantity(meaningOf(*one.quantity)), text = Message::name(shortened(one.text));
    notes.front() = message(
        "{}; {}", notes.front(),
        isOnly ? message("line {}: {} of all points ({})", one.line, quantity, text)
               : message("line {}: {} of the points below it ({})", one.line, quantity, text));
  }
  std::string unused;
  for (std::size_t i = 0; i < block.columns.size(); ++i)
    if (!roles.isUsed(i))
      appendItem(unused, block.columns[i].name.empty() ? std::to_string(i + 1)
                                                       : shortened(block.columns[i].name));
  for (const HeaderStatement& statement : header.unused)
    appendItem(unused, shortened(statement.text));
  if (!unused.empty()) notes.push_back(message("not used: {}", Message::name(unused)));
  for (std::size_t i = 0; i < block.cells.size(); ++i)
    if (roles.isUsed(i) && hasErrors(block.cells[i]) && !roles.areErrorsUsed(block, i))
      notes.push_back(message("column {}: the errors in its cells are not used", i + 1));
  for (const HeaderStatement& one : header.unused)
    for (const auto& [stated, column] : {std::pair(Quantity::Pressure, Quantity::Force),
                                         std::pair(Quantity::Force, Quantity::Pressure)})
      if (one.quantity == stated && roles.find(column))
        notes.push_back(message(
            "line {}: the {} is not used, because a column gives the {}; take the column out where "
            "the line says the load",
            one.line, Message(meaningOf(stated)), Message(meaningOf(column))));
  if (header.hasTwoLoads)
    notes.emplace_back(
        "the lines above the table state several loads; one normal force or one nominal pressure "
        "says the load");
  for (const HeaderStatement& one : header.common)
    if (one.isNegative)
      notes.push_back(
          message("line {}: the {} is below 0, by a convention of signs; its magnitude is taken",
                  one.line, Message(meaningOf(*one.quantity))));
  for (const HeaderStatement& one : header.common)
    if (!one.groupedNumber.empty())
      notes.push_back(
          mark.decimal == ','
              ? message("line {}: {} is read as {}; the decimal mark of the table is a comma",
                        one.line, one.groupedNumber, plain(one.number))
              : message("line {}: {} is read as {}; the decimal mark of the table is a point",
                        one.line, one.groupedNumber, plain(one.number)));
  return notes;
}

/// Fills loads and temperatures that stand in the first row of each group alone; returns notes on
/// them.
std::vector<Message> fillGroups(TextBlock& block, const FrictionRoles& roles) {
  std::vector<Message> notes;
  for (const Quantity quantity : kLoadsAndTemperature) {
    const FrictionRole* role = roles.find(quantity);
    if (role == nullptr) continue;
    const auto filled = filledDown(block, role->index, roles.find(Quantity::Mu)->index);
    if (!filled) continue;
    for (std::size_t row = 0; row < block.rows; ++row) block.at(row, role->index) = (*filled)[row];
    notes.push_back(standsInFirstRows(block.label(role->index)));
  }
  return notes;
}

/// Returns the tables of friction by their names; the largest table where there is none.
std::vector<const TextBlock*> tablesOfFriction(const TextTable& table) {
  std::vector<const TextBlock*> found;
  for (const TextBlock& block : table.blocks)
    if (hasFriction(block)) found.push_back(&block);
  return found.empty() ? std::vector{&table.largest()} : found;
}

/// A table of friction that has been read.
struct ReadTable {
  TextBlock block{};
  FrictionRoles roles{};
  HeaderMark mark{};
  HeaderStatements header{};
  std::vector<Message> ofGroups{};
  FrictionRows rows{};
};

/// Completes what the lines above a further table state by what holds for the table before it,
/// except for what its columns give. Throws InputError where they do not tell the tables apart:
/// each has to state the same loads or temperatures as those before.
void completeStatements(ReadTable& further, const ReadTable& before, const std::string& name) {
  std::vector<HeaderStatement>& common = further.header.common;
  if (common.empty() || !std::ranges::all_of(common, [&](const HeaderStatement& one) {
        return before.header.hasCommon(*one.quantity);
      }))
    throw InputError(name, "",
                     message("has several tables of friction, at lines {} and {}; each needs a "
                             "file of its own, or all one table with a column that tells them "
                             "apart, such as temperature or label",
                             before.block.lines.front(), further.block.lines.front()));
  for (const HeaderStatement& one : before.header.common)
    if (!further.header.hasCommon(*one.quantity) && !further.roles.isGiven(*one.quantity))
      common.push_back(one);
}

/// Reads one table of friction. before: the one above it; null where it is the first one. below:
/// the lines below it that are of all its points as well; those above it precede them.
ReadTable readOne(const TextTable& table, const TextBlock& written, const ReadTable* before,
                  const std::vector<TextEntry>& below, const std::string& name) {
  ReadTable one{.block = written};
  unifyUnits(one.block, name);
  one.roles = findRoles(one.block, name);
  refuseUnitsElsewhere({table, written}, one.roles, name);
  one.mark = decimalMark(one.block, table.dialect);
  const auto isGiven = [&](Quantity quantity) { return one.roles.isGiven(quantity); };
  one.header = readHeader(one.block.header, one.mark, isGiven, name);
  const auto isSaid = [&](Quantity quantity) {
    return isGiven(quantity) || one.header.hasCommon(quantity);
  };
  addBelow(one.header, readHeader(below, one.mark, isSaid, name));
  if (before) completeStatements(one, *before, name);
  requireQuantities(
      one.block, one.roles, [&](Quantity quantity) { return one.header.hasCommon(quantity); },
      name);
  one.ofGroups = fillGroups(one.block, one.roles);
  one.rows = readRows(one.block, one.roles, one.header.common, name);
  return one;
}

/// Returns the lines at which tables begin that are not read; empty where there is none.
std::string otherTables(const TextTable& table, const std::vector<const TextBlock*>& read) {
  std::string lines;
  for (const TextBlock& block : table.blocks)
    if (std::ranges::find(read, &block) == read.end())
      appendItem(lines, std::to_string(block.lines.front()));
  return lines;
}

FrictionData readPoints(const TextTable& table, const std::string& name,
                        const std::vector<Message>& ofTable) {
  const std::vector<const TextBlock*> ofFriction = tablesOfFriction(table);
  for (const TextBlock& block : table.blocks)
    if (std::ranges::find(ofFriction, &block) == ofFriction.end()) refuseStatements(block, name);
  FrictionData data{name};
  std::vector<ReadTable> tables;
  for (const TextBlock* block : ofFriction) {
    const bool isOnly = ofFriction.size() == 1 && block == &table.blocks.back();
    tables.push_back(readOne(table, *block, tables.empty() ? nullptr : &tables.back(),
                             isOnly ? statedBelow(table, stateNamed) : std::vector<TextEntry>{},
                             name));
    const ReadTable& one = tables.back();
    data.points.insert(data.points.end(), one.rows.points.begin(), one.rows.points.end());
    for (const std::vector<Message>& notes :
         {notesOn(one.block, one.roles, one.header, one.mark, ofFriction.size() == 1), one.ofGroups,
          one.rows.notes})
      data.notes.insert(data.notes.end(), notes.begin(), notes.end());
  }
  requirePoints(data.points, name);
  for (const ReadTable& one : tables) checkColumns(one.rows.points, one.block, one.roles, name);
  checkPoints(data.points,
              std::ranges::all_of(tables,
                                  [](const ReadTable& one) {
                                    return one.roles.find(Quantity::Velocity) != nullptr;
                                  }),
              name);
  if (const std::string lines = otherTables(table, ofFriction); !lines.empty())
    data.notes.push_back(message("tables of numbers that are not used: at line {}",
                                 PrintedNumber{shortened(lines)}));
  data.notes.insert(data.notes.end(), ofTable.begin(), ofTable.end());
  std::ranges::move(slipNotes(data.points), std::back_inserter(data.notes));
  std::ranges::move(doubtsAbout(table), std::back_inserter(data.notes));
  if (table.dialect.isUnclear) data.notes.push_back(unclearMark(table.dialect.decimal));
  return data;
}

}  // namespace

std::vector<Message> notesOf(std::span<const FrictionData> tables) {
  std::vector<Message> notes;
  for (const FrictionData& table : tables)
    for (const Message& note : table.notes)
      notes.push_back(message("{}: {}", Message::name(table.name), note));
  return notes;
}

InputError missingFrictionData() {
  return {"", "--data", "no measured friction is given, nor named by the scene"};
}

bool isFrictionTable(std::string_view bytes) {
  try {
    std::vector<Message> notes;
    const TextTable table = readTable(bytes, {}, notes);
    if (std::ranges::any_of(table.blocks, hasFriction)) return true;
    // A line above the table may state the velocity, and forces give friction.
    return table.largest().hasNames() && !readPoints(table, {}, notes).points.empty();
  } catch (const InputError&) {
    return false;
  }
}

FrictionData parseFrictionData(std::string_view bytes, const std::string& name) {
  std::vector<Message> notes;
  const TextTable table = readTable(bytes, name, notes);
  return readPoints(table, name, notes);
}

FrictionData readFrictionData(const std::filesystem::path& file, const std::string& label) {
  constexpr std::size_t kLargest = std::size_t{1} << 26;  // bytes
  FrictionData data = parseFrictionData(readRegularFile(file, kLargest), file.string());
  data.name = label.empty() ? file.stem().string() : label;
  return data;
}

Scene sceneAtPoint(const MeasuredPoint& point, const Scene& scene) {
  Scene at = scene;
  at.sliding.kind = SlidingKind::Steady;
  at.sliding.velocity = point.velocity;
  if (!std::isnan(point.normalForce)) {
    at.load.kind = LoadKind::Force;
    at.load.normalForce = point.normalForce;
  }
  if (!std::isnan(point.nominalPressure)) {
    at.load.kind = LoadKind::Pressure;
    at.load.nominalPressure = point.nominalPressure;
  }
  if (!std::isnan(point.temperature)) {
    at.elastomer.temperature = point.temperature;
    try {
      temperatureShift(at.elastomer);
    } catch (const InputError& error) {
      throw InputError("", error.key(),
                       message("row {} of the measured friction: {}", point.row, error.message()));
    }
  }
  return at;
}

std::optional<Message> forceNote(const FrictionData& data, const Scene& scene) {
  constexpr double kFar = 3;  // times the load of the scene, or less than its inverse
  if (scene.load.kind != LoadKind::Pressure) return {};
  Extent forces;
  for (const MeasuredPoint& point : data.points)
    if (!std::isnan(point.normalForce)) forces.add(point.normalForce);
  if (forces.isEmpty()) return {};
  const double length = lineExtent(scene).length;
  const double ofScene = loadOn(scene.load, length).normalForce;
  if (!(forces.least > kFar * ofScene || forces.most < ofScene / kFar)) return {};
  const double perForce = scene.load.nominalPressure / ofScene;
  Extent pressures;
  for (const double force : {forces.least, forces.most}) pressures.add(force * perForce);
  return message(
      "{}: a normal force is that on one period of the line, so that {} would be a nominal "
      "pressure "
      "of {} on the period of {} times the width of {}, while the scene has {}; where it is the "
      "force on a whole sample, give the nominal pressure of the test in its place",
      Message::name(data.name), extentText(forces, "N"), extentText(pressures, "Pa"),
      printed(length, "m"), printed(contactWidth(scene.load, length), "m"),
      printed(scene.load.nominalPressure, "Pa"));
}

}  // namespace asperity
