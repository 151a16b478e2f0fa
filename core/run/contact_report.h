// The contact at one moment as tables and in words: its shape point by point, the contact spots and
// the gaps between them, the balance of power, and short sentences, for those who hear the window
// or want to quote it. Everything is read from one frame: each point stands for one spacing of the
// line (midpoint rule), so that sums over the shape give the other tables exactly, and lengths are
// whole spacings. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/run/frame.h"
#include "core/scene/data_table.h"
#include "core/scene/notes.h"

namespace asperity {

/// The optional values that a frame needs for these tables.
FrameFields fieldsForTables();

/// A contact spot or a gap, from the left edge of its first point's interval. It may pass the end
/// of the period.
struct ContactInterval {
  double start = 0, length = 0;  // m; start in [-spacing/2, period)
  std::size_t first = 0, points = 0;
};

/// Returns the contact spots, or with `isGap` the gaps between them, in order of their start. A
/// spot or a gap that is the whole period starts at its first point.
std::vector<ContactInterval> findIntervals(const Frame& frame, bool isGap);

/// Returns for each point the time (s) since it came into contact: in steady sliding the distance
/// to the edge of contact that moves ahead over the velocity; 0 outside of contact. Not applicable
/// where nothing slides, in contact without an edge, and in a motion, whose march keeps no such
/// times.
std::vector<double> timeInContact(const Frame& frame);

/// position, rigid_height, surface_height, gap, line_load, time_in_contact, power,
/// time_since_contact.
DataTable shapeTable(const Frame& frame);

/// start, length, normal_force, tangential_force, mean_line_load, largest_line_load. The tangential
/// force is -integral p z' dx, below 0 where it resists motion towards +x.
DataTable contactsTable(const Frame& frame);

/// start, length, mean_gap, largest_gap, area.
DataTable gapsTable(const Frame& frame);

/// One row: velocity, power_in, power_contact, power_free, power_interface, power_dissipated,
/// power_difference. In steady sliding the difference is the error of the points; in a motion also
/// what the springs take up.
DataTable powerTable(const Frame& frame);

/// Returns a note where the loads of the points add up to a force that differs from the normal
/// force by more than a twentieth, because contacts are shorter than a few spacings; else empty.
std::optional<Message> coarsePointsNote(const Frame& frame);

/// Returns a note where the powers at the points of steady sliding add up to another power than
/// that of friction, by more than half a per cent: the points are coarse for short contacts, or the
/// line on which friction was computed has other points than the one that is drawn. Else empty. A
/// motion has no such balance at one moment, because its springs take up power as well.
std::optional<Message> coarsePowerNote(const Frame& frame);

/// Numbers that follow from the frame and that a person reads off the picture: forces, contacts and
/// gaps, loads, power, of the line, SI.
nlohmann::ordered_json derivedNumbers(const Frame& frame);

/// What the friction curve of the scene says about the velocity of a frame, as far as it is known.
struct CurveAtVelocity {
  double mu = kNotApplicable;     // mean over the lines
  double error = kNotApplicable;  // standard error of mu
  std::int64_t lines = 0;         // over which mu is a mean
  std::string region{};           // "III"; empty: not known
  NoteSet notes{};                // what limits these results
};

/// Returns the state as short sentences: how the line moves and presses, where the bodies touch,
/// what friction is and where it comes from, what other lines have, and, one sentence each, how far
/// this holds. Their numbers are those of the picture and of the status line.
std::vector<Message> describeContact(const Frame& frame, const CurveAtVelocity& curve = {});

}  // namespace asperity
