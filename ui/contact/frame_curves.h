// What a picture takes from a frame: the forces on the rigid line and its velocity, and of the
// points long curves reduced to what a pixel column can show, intervals in contact, contacts too
// narrow to be visible as lines. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/run/contact_report.h"

namespace asperity {

/// Returns whether the friction force on the line points to the right. It points against the
/// motion, except shortly after a stop or a reversal, when contact is still on the other side.
bool pushesRight(const Frame& frame);

/// Returns the present velocity, m/s; 0 without a scene.
double frameVelocity(const Frame& frame);

/// Returns whether there is local friction in addition to that of the deformation.
bool hasInterface(const Frame& frame);

/// Returns the friction coefficient including the interface's part.
double totalFriction(const ContactState& state);

/// Returns the magnitude of the friction force on the line, N, including the interface's part.
double frictionForce(const ContactState& state);

/// Maps positions to pixel columns; column 0 starts at `left`.
struct Columns {
  double left = 0;  // m
  double pixelsPerMetre = 1;
};

struct CurveVertex {
  double x = 0;       // m
  double height = 0;  // m
  double value = 0;   // of the colour scale, the greatest of the points it represents
};

/// Points first..last of the periodic frame; the indices may be any integers.
struct PointRange {
  std::int64_t first = 0, last = -1;
  std::int64_t count() const { return last - first + 1; }
};

/// Returns true if the arrays have one length, at least one point, and a positive finite spacing.
bool isDrawable(const Frame& frame);

/// Returns the length of the period by the points of a drawable frame, m.
double periodLength(const Frame& frame);

/// Returns the points from `left` to `left + width` and one more on either side.
PointRange pointsWithin(const Frame& frame, double left, double width);

/// Returns every point where there are at most two per column; otherwise the lowest and the highest
/// of each column, in their order in x. x ascends. `heights` is lineHeight or surfaceHeight of the
/// frame. `values`: one per point, or empty where there are none (then 0).
std::vector<CurveVertex> decimated(const Frame& frame, const std::vector<double>& heights,
                                   PointRange range, const Columns& columns,
                                   const std::vector<double>& values = {});

/// Returns the intervals of the elastomer's surface where values are above `least`, each decimated.
/// Intervals less than a column apart are merged; none is ever lost: a single point is an interval
/// of one vertex.
std::vector<std::vector<CurveVertex>> intervalsAbove(const Frame& frame, PointRange range,
                                                     const Columns& columns,
                                                     const std::vector<double>& values,
                                                     double least);

/// Returns the point to mark where the two bodies touch but no interval of points in contact is
/// `metres` wide (intervals less than a quarter of it apart count as one): that of the greatest
/// pressure or, where contact lies between points and none carries pressure, of the smallest gap
/// lineHeight - surfaceHeight. None where there is a wider contact or no contact.
std::optional<std::size_t> narrowContact(const Frame& frame, double metres);

/// Returns whether the pressures of the points are those of the contact: not where a narrow contact
/// lies between them.
bool pointsBearLoad(const Frame& frame);

/// Returns the greatest finite pressure, N/m; 0 where no point is in contact, or where the points
/// do not bear the load.
double greatestPressure(const Frame& frame);

}  // namespace asperity
