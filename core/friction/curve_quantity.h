// The quantities that the vertical axis of a friction curve may show, each with the word of its
// column in tables. Constant; any thread.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/columns.h"

namespace asperity {

enum class CurveQuantity {
  Mu,
  MuTotal,
  NormalizedMu,
  ContactFraction,
  RmsSlopeContact,
  Indentation,
  TangentialForce,
  Power,
  MeanPressure
};

struct QuantityEntry {
  CurveQuantity quantity;
  ColumnName word;         // in tables and on the command line
  std::string_view title;  // of an axis
  std::string_view unit;   // SI; empty for a pure number
  double (*value)(const CurvePoint& point);
  bool isFriction;  // proportional to mu at one state: it has error bars, and Eq. (11) gives it
};

/// Returns all of them in the order of a menu; mu is the first.
std::span<const QuantityEntry> quantityEntries();
const QuantityEntry& quantityEntry(CurveQuantity quantity);

/// Returns the quantity with this word; empty where there is none.
std::optional<CurveQuantity> findQuantity(std::string_view word);
std::vector<std::string_view> quantityWords();

/// Returns whether this is mu, of the deformation alone or with local friction: what is measured is
/// then shown as it is.
inline bool isCoefficient(CurveQuantity quantity) {
  return quantity == CurveQuantity::Mu || quantity == CurveQuantity::MuTotal;
}

/// Returns the quantity of a point.
inline double quantityValue(CurveQuantity quantity, const CurvePoint& point) {
  return quantityEntry(quantity).value(point);
}

/// Returns the factor from the friction of a point to the quantity; NaN where they are not
/// proportional, or the point has no friction.
inline double perFriction(CurveQuantity quantity, const CurvePoint& point) {
  if (isCoefficient(quantity)) return 1;
  if (!quantityEntry(quantity).isFriction || std::isnan(point.mu) || point.mu == 0)
    return kNotApplicable;
  return quantityValue(quantity, point) / point.mu;
}

}  // namespace asperity
