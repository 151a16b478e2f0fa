// Contacts too narrow to be visible as lines. Private to ui/contact; pure.
#pragma once

#include <cstddef>
#include <optional>

#include "core/run/frame.h"

namespace asperity {

/// Returns the point of the deepest contact, where the two bodies touch but no stretch of points in
/// contact is `metres` wide (stretches less than a quarter of it apart count as one). It is the
/// point of the greatest pressure or, where contact lies between points and none carries pressure,
/// of the smallest gap lineHeight - surfaceHeight. None where there is a wider contact or no
/// contact.
std::optional<std::size_t> narrowContact(const Frame& frame, double metres);

/// Returns whether the pressures of the points are those of the contact: not where a narrow contact
/// lies between them.
bool pointsBearLoad(const Frame& frame);

/// Returns the greatest finite pressure, N/m; 0 where no point is in contact, or where the points
/// do not bear the load.
double greatestPressure(const Frame& frame);

}  // namespace asperity
