#include "core/fit/friction_roles.h"

#include <algorithm>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/fit/friction_preparation.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

std::string namesOfColumns(const TextBlock& block) {
  std::string names;
  for (const TextColumn& column : block.columns) appendItem(names, shortened(column.name));
  return names;
}

class FrictionRoleFinder {
 public:
  FrictionRoleFinder(const TextBlock& block, const std::string& name)
      : block_(block), name_(name) {}

  FrictionRoles find() {
    if (block_.hasNames())
      findByName();
    else
      takeInOrder();
    return std::move(roles_);
  }

 private:
  [[noreturn]] void refuse(const Message& what) const { throw InputError(name_, "", what); }

  /// Takes columns without names for velocity, friction and its error.
  void takeInOrder() {
    const std::size_t count = block_.columns.size();
    for (const TextEntry& entry : block_.header)
      if (namesQuantity(joinEntry(entry, " ")))
        refuse(
            message("line {}: '{}' does not name {} columns; separate the names as the "
                    "numbers are, or write each one without blanks, such as velocity_mm/s",
                    entry.line, shortened(entry.written), count));
    if (count != 2 && count != 3)
      refuse(
          message("has {} columns without names; name them: velocity, mu, and where there are "
                  "some mu_error, normal_force, nominal_pressure, temperature, label",
                  count));
    add(Quantity::Velocity, 0);
    add(Quantity::Mu, 1);
    if (count == 3) add(Quantity::MuError, 2);
  }

  void findByName() {
    refuseSeveralStates();
    for (std::size_t i = 0; i < block_.columns.size(); ++i) {
      const TextColumn& column = block_.columns[i];
      if (const auto quantity = findMeaning(column)) {
        if (*quantity == Quantity::MuError && isScatter(column.name) && hasErrorOfMean()) continue;
        if (isFrictionInNewtons(column)) continue;
        if (isClear(column, *quantity) || !hasClearColumn(*quantity)) add(*quantity, i);
      } else {
        refuseUnknownUnit(column);
      }
    }
    for (const TextColumn& column : block_.columns) refuseUnclear(column);
    if (!roles_.find(Quantity::Mu)) findRepeats();
    findFrictionForce();
    if (!roles_.find(Quantity::Mu))
      refuse(message("has no column of the {}; its columns are {}; name it as in \"{}\"",
                     Message(meaningOf(Quantity::Mu)), Message::name(namesOfColumns(block_)),
                     "mu"));
  }

  /// Returns whether a name is that of friction in one state: "mu 5\u00B0C", "mu_5C", "mu@5 N".
  static bool namesState(const std::string& name) {
    const std::size_t number = name.find_first_of("-0123456789");
    if (number == name.npos || quantityNamed(plainWord(name.substr(0, number))) != Quantity::Mu)
      return false;
    const auto state = parseQuantity(withoutEnd(name.substr(number), ")"));
    return state && stateOfUnit(state->unit);
  }

  /// Throws InputError for friction at several temperatures, loads or velocities side by side.
  void refuseSeveralStates() const {
    std::string names;
    int count = 0;
    for (const TextColumn& column : block_.columns) {
      const std::vector<std::string> words = nameWords(column.name);
      const bool isState = namesState(column.name);
      if (words.empty() || (!isState && quantityNamed(words.front()) != Quantity::Mu)) continue;
      // "mu (0.1 MPa)", "mu 20 \u00B0C"; "mu 1" is the first of several measurements.
      const bool isInUnit = column.unit.size() > 1 && isDigit(column.unit.front());
      const bool isInName = words.size() > 1 && isDigit(words[1].front()) &&
                            (words.size() > 2 || !column.unit.empty()) && !findMeaning(column);
      if (!isInUnit && !isInName && !isState) continue;
      appendItem(names, shortened(column.name));
      ++count;
    }
    if (count > 1)
      refuse(
          message("has friction in several states side by side ({}); write them one below the "
                  "other, with a column that tells them apart, such as temperature",
                  Message::name(names)));
  }

  /// Finds columns "mu1", "mu2", ... of repeated measurements.
  void findRepeats() {
    for (std::size_t i = 0; i < block_.columns.size(); ++i) {
      const TextColumn& column = block_.columns[i];
      const std::string word = plainWord(column.name);
      const std::string name = word.substr(0, word.find_last_not_of("0123456789") + 1);
      if (name != word && quantityNamed(name) == Quantity::Mu && isPureUnit(column.unit) &&
          !column.isText)
        roles_.repeats.push_back(i);
    }
    if (roles_.repeats.size() < 2) {
      roles_.repeats.clear();
      return;
    }
    // A standard deviation of the repeats of a row says less than their scatter in all rows.
    std::erase_if(roles_.columns, [&](const FrictionRole& role) {
      return role.quantity == Quantity::MuError && isScatter(block_.columns[role.index].name);
    });
    const std::size_t first = roles_.repeats.front() + 1, last = roles_.repeats.back() + 1;
    roles_.columns.push_back(
        {Quantity::Mu,
         roles_.repeats.front(),
         {},
         roles_.find(Quantity::MuError)
             ? message("columns {} to {}: repeated measurements of the coefficient of friction; "
                       "each point is their mean",
                       first, last)
             : message("columns {} to {}: repeated measurements of the coefficient of "
                       "friction; each point is their mean, with a standard error from "
                       "the scatter in all rows",
                       first, last)});
  }

  /// Finds the one column of the force of friction. Over the normal force it is the coefficient of
  /// friction; beside one it says the same.
  void findFrictionForce() {
    std::vector<std::size_t> found;
    // "Friction force (N)" precedes "Tangential force Fx (N)".
    for (const auto isNamed : {isForceOfFriction, meansForceOfFriction}) {
      if (!found.empty()) break;
      for (std::size_t i = 0; i < block_.columns.size(); ++i)
        if ((isFrictionInNewtons(block_.columns[i]) || isNamed(block_.columns[i].name)) &&
            !block_.columns[i].isText)
          found.push_back(i);
    }
    if (found.size() != 1) return;
    const std::size_t index = found.front();
    const TextColumn& column = block_.columns[index];
    if (roles_.find(Quantity::Mu)) {
      const auto unit =
          column.unit.empty() ? Unit{"N"} : unitOfQuantity(column.unit, Quantity::Force);
      if (unit) roles_.forceOfFriction = {Quantity::Mu, index, {*unit}, {}};
      return;
    }
    FrictionConversion conversion = findConversion(Quantity::Force, column, block_, name_);
    conversion.isForce = true;
    roles_.columns.push_back(
        {Quantity::Mu, index, conversion,
         message("column {}: force of friction; its magnitude over the normal force "
                 "is the coefficient of friction",
                 index + 1)});
  }

  /// Returns whether a column has the force of friction by its unit: "Friction (N)".
  static bool isFrictionInNewtons(const TextColumn& column) {
    return isOneOf(plainWord(column.name), "friction reibung frottement attrito") &&
           measures(column.unit, Quantity::Force);
  }

  /// Returns whether a column names the quantity by more than an ambiguous letter, and a velocity
  /// as that of sliding.
  static bool isClear(const TextColumn& column, Quantity quantity) {
    return !isAmbiguousName(column.name) &&
           (!findErrorScale(column) || isErrorOfMean(column.name)) &&
           (quantity != Quantity::Velocity || isNameOfSliding(column.name));
  }

  /// Returns whether a column names the quantity clearly.
  bool hasClearColumn(Quantity quantity) const {
    return std::ranges::any_of(block_.columns, [&](const TextColumn& column) {
      return findMeaning(column) == quantity && isClear(column, quantity);
    });
  }

  /// Returns whether a column has the standard error of friction, beside which its standard
  /// deviation is not needed.
  bool hasErrorOfMean() const {
    return std::ranges::any_of(block_.columns, [](const TextColumn& column) {
      return isErrorOfMean(column.name) && !column.errorsOf &&
             findMeaning(column) == Quantity::MuError;
    });
  }

  /// Throws InputError for a known quantity in an unknown unit, such as "load (stone)".
  void refuseUnknownUnit(const TextColumn& column) const {
    const std::size_t open = column.name.find_last_of("([");
    if (!column.unit.empty() || open == std::string::npos || open == 0) return;
    const std::string unit = column.name.substr(open);
    TextColumn known{std::string(trimmedBlanks(column.name.substr(0, open))),
                     std::string(withoutBrackets(unit)), false};
    if (const auto quantity = findMeaning(known)) {
      findConversion(*quantity, known, block_, name_);
      refuse(message("column {}: the unit {} is not understood", shortened(column.name),
                     shortened(known.unit)));
    }
  }

  /// Returns whether a column may have a load or temperature by its unit, or by the first or last
  /// word of its name.
  static bool mayBe(const TextColumn& column, Quantity quantity) {
    const std::vector<std::string> words = nameWords(column.name);
    return measures(column.unit, quantity) ||
           (words.size() > 1 && (quantityInText(words.front()) == quantity ||
                                 quantityInText(words.back()) == quantity));
  }

  /// Throws InputError for bounds of a quantity, and for a load or temperature, by its name or its
  /// unit, that is not understood while no other column gives it: leaving these out would change
  /// the result.
  void refuseUnclear(const TextColumn& column) const {
    if (findMeaning(column)) return;
    if (column.name == "T" && !roles_.isGiven(Quantity::Temperature) &&
        (column.unit.empty() || isOneOf(plainWord(column.unit), "deg degree degrees \u00B0")))
      refuse(
          "column T: is it the temperature of the rubber? Give it as numbers with a unit, as "
          "in \"T (\u00B0C)\", or take the column out");
    if (column.isText) return;
    const auto scale = findErrorScale(column);
    const bool isIndefinite = scale && scale->isIndefinite;
    if ((isIndefinite || column.errorsOf) && !roles_.find(Quantity::MuError))
      refuse(
          message("column {}: it is not known how many standard errors this is; give one standard "
                  "error as mu_error, or take the column out",
                  shortened(column.name)));
    if (column.name == "s" && isPureUnit(column.unit) && !roles_.find(Quantity::MuError))
      refuse(
          "column s: is it the standard deviation of the coefficient of friction? Name it "
          "std, or take the column out");
    const std::vector<std::string> words = nameWords(column.name);
    if (words.empty()) return;
    const auto isBound = [](const std::string& word) {
      return isOneOf(word, "min max minimum maximum lower upper low high lo hi untere obere");
    };
    std::string subject;
    for (const std::string& word : words)
      if (!isBound(word)) subject += word;
    const bool hasBound = std::ranges::any_of(words, isBound);
    auto named = quantityNamed(subject);
    if (!named) named = findMeaning(TextColumn{subject});
    if (hasBound && named)
      refuse(
          message("column {}: bounds of the {} are not read; give its error as a column such "
                  "as mu_error, or take the column out",
                  shortened(column.name), Message(meaningOf(*named))));
    if (isErrorName(column.name) || isOtherLoad(words)) return;
    for (const Quantity quantity : kLoadsAndTemperature) {
      if (roles_.isGiven(quantity) || !mayBe(column, quantity)) continue;
      const auto other =
          std::find_if(std::next(&column), block_.columns.data() + block_.columns.size(),
                       [&](const TextColumn& one) { return !one.isText && mayBe(one, quantity); });
      if (other != block_.columns.data() + block_.columns.size())
        refuse(
            message("columns {} and {}: each may be the {}; give one such column, and a row "
                    "for each measurement of mu",
                    shortened(column.name), shortened(other->name), Message(meaningOf(quantity))));
      if (quantity == Quantity::Temperature)
        refuse(
            message("column {}: is it the temperature of the rubber, and not of the track or "
                    "the air? Name it temperature alone, with its unit in brackets, or take "
                    "the column out",
                    shortened(column.name)));
      refuse(
          message("column {}: is it the {}? Name it so alone, with its unit in brackets, "
                  "or take the column out",
                  shortened(column.name), Message(meaningOf(quantity))));
    }
  }

  void add(Quantity quantity, std::size_t index) {
    const TextColumn& column = block_.columns[index];
    const FrictionRole* other = roles_.find(quantity);
    if (other && column.errorsOf)
      refuse(message("column {}: has errors in its cells, and {} gives them, too; keep one of them",
                     shortened(block_.columns[*column.errorsOf].name),
                     Message::name(shortened(block_.columns[other->index].name))));
    if (other && quantity != Quantity::Label)
      refuse(message("has two columns of the {}: {} and {}", Message(meaningOf(quantity)),
                     shortened(block_.columns[other->index].name), shortened(column.name)));
    const auto hasError = [](const std::string& text) {
      return containsOneOf(text, kErrorSigns) || text.find('(') != text.npos;
    };
    if (column.isText && quantity == Quantity::Mu)
      if (const auto cell = std::ranges::find_if(block_.texts[index], hasError);
          cell != block_.texts[index].end())
        refuse(
            message("column {}: '{}' is not understood as a value with its error; write both as in "
                    "\"0.31 \u00B1 0.02\", or in two columns, mu and mu_error",
                    shortened(column.name), shortened(*cell)));
    if (column.isText && quantity != Quantity::Label)
      refuse(message("column {} has texts where numbers are expected",
                     column.name.empty() ? std::to_string(index + 1) : shortened(column.name)));
    // Numbers of samples and lengths of tracks are no labels.
    if (quantity == Quantity::Label && (!column.isText || !column.unit.empty())) return;
    const FrictionConversion conversion = findConversion(quantity, column, block_, name_);
    Message unit = conversion.unitText;
    if (unit.empty() && column.unit.empty() && !conversion.unit.si.empty())
      unit = message("{}, assumed", Message::name(std::string(conversion.unit.si)));
    if (unit.empty()) unit = Message::name(column.unit);
    const auto number = static_cast<int>(column.errorsOf.value_or(index)) + 1;
    const Message meaning(meaningOf(quantity));
    const Message note = column.errorsOf ? message("column {}, in its cells: {}", number, meaning)
                         : column.isOfNames ? message("in the names of the columns: {}", meaning)
                                            : message("column {}: {}", number, meaning);
    roles_.columns.push_back(
        {quantity, index, conversion, unit.empty() ? note : message("{} ({})", note, unit)});
  }

  const TextBlock& block_;
  const std::string& name_;
  FrictionRoles roles_;
};

}  // namespace

const FrictionRole* FrictionRoles::find(Quantity quantity) const {
  const auto found = std::ranges::find(columns, quantity, &FrictionRole::quantity);
  return found == columns.end() ? nullptr : &*found;
}

bool FrictionRoles::isGiven(Quantity quantity) const {
  if (quantity == Quantity::Temperature || quantity == Quantity::Velocity)
    return find(quantity) != nullptr;
  return find(Quantity::Force) != nullptr || find(Quantity::Pressure) != nullptr;
}

bool FrictionRoles::isUsed(std::size_t index) const {
  return std::ranges::find(columns, index, &FrictionRole::index) != columns.end() ||
         std::ranges::find(repeats, index) != repeats.end();
}

bool FrictionRoles::areErrorsUsed(const TextBlock& block, std::size_t index) const {
  return std::ranges::any_of(columns, [&](const FrictionRole& role) {
    return block.columns[role.index].errorsOf == index;
  });
}

void refuseUnitsElsewhere(const TextPart& in, const FrictionRoles& roles, const std::string& name) {
  for (const FrictionRole& role : roles.columns) {
    const TextColumn& column = in.block.columns[role.index];
    if (!column.unit.empty() || column.isOfNames || role.conversion.isForce) continue;
    const auto found = unitOfNoNumber(in, [&role](const std::string& word) {
      // One letter may mean anything, and "un" is no micronewton.
      if (word.size() < 2 || (word.size() == 2 && !findUnit(word))) return false;
      const auto unit = unitOfQuantity(word, role.quantity);
      return unit && unit->toSi(1) != 1;
    });
    if (found)
      throw InputError(name, "",
                       message("column {}: {}", shortened(in.block.label(role.index)),
                               unitStandsElsewhere(column.name, *found)));
  }
}

namespace {

bool isSlip(const std::string& name) {
  return hasOneOf(nameWords(name),
                  "slip schlupf slipangle slipratio sliprate schr\u00E4glauf schr\u00E4glaufwinkel "
                  "schraeglaufwinkel");
}

/// Returns whether a line above the table states the slip of a wheel: "Slip angle: 15 deg".
bool statesSlip(const TextEntry& entry) {
  const std::string text = joinEntry(entry);
  const std::string name = text.substr(0, std::min(text.find_first_of("0123456789"), text.size()));
  const bool isOfWheel = !hasOneOf(nameWords(name), "stick distance length path weg");
  return isSlip(name) && isOfWheel && name.size() < text.size() &&
         findMeaning(parseColumnName(entry.key)) != Quantity::Velocity;
}

/// Throws InputError for a velocity beside a slip: it is that of the wheel or the vehicle, unless
/// its name says otherwise.
void refuseVelocityOfWheel(const TextBlock& block, const FrictionRoles& roles,
                           const std::string& name) {
  const auto column = std::ranges::find_if(block.columns, [](const TextColumn& one) {
    return isSlip(one.name) && findMeaning(one) != Quantity::Velocity;
  });
  const auto line = std::ranges::find_if(block.header, statesSlip);
  const auto refuse = [&](const Message& what) {
    if (column != block.columns.end())
      throw InputError(name, "", message("column {}: {}", shortened(column->name), what));
    if (line != block.header.end())
      throw InputError(name, "", message("line {}: {}", line->line, what));
  };
  const FrictionRole* velocity = roles.find(Quantity::Velocity);
  if (!velocity)
    refuse(
        "with a slip, the velocity of sliding is not the one above the table; give it for each row "
        "in a column, as in \"v (m/s)\"");
  else if (!isNameOfSliding(block.columns[velocity->index].name))
    refuse(
        message("with a slip, the velocity of sliding may not be that of column {}; name that "
                "column sliding velocity where it is, or give the velocity of sliding",
                shortened(block.label(velocity->index))));
}

}  // namespace

void requireQuantities(const TextBlock& block, const FrictionRoles& roles,
                       const std::function<bool(FrictionQuantity)>& isStated,
                       const std::string& name) {
  const auto isKnown = [&](Quantity quantity) {
    return roles.find(quantity) || isStated(quantity);
  };
  if (!isKnown(Quantity::Velocity))
    throw InputError(
        name, "",
        message("has no column of the velocity; its columns are {}; name it as in \"v (m/s)\", or "
                "write one velocity of all rows above them, as in \"Velocity: 10 mm/s\"",
                Message::name(namesOfColumns(block))));
  refuseVelocityOfWheel(block, roles, name);
  if (roles.find(Quantity::Mu)->conversion.isForce && !isKnown(Quantity::Force))
    throw InputError(
        name, "",
        "has no coefficient of friction, and a force of friction without a normal force; give it "
        "in a column \"Fz (N)\", or above the columns, as in \"Normal force: 30 N\"");
}

FrictionRoles findRoles(const TextBlock& block, const std::string& name) {
  return FrictionRoleFinder(block, name).find();
}

}  // namespace asperity
