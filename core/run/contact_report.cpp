#include "core/run/contact_report.h"

#include <algorithm>
#include <cmath>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/curve_regions.h"
#include "core/contact/steady_sliding.h"
#include "core/material/element_law.h"
#include "core/scene/columns.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

bool touches(const Frame& frame, std::size_t i) {
  return frame.pressure[i] > 0;
}

double gapAt(const Frame& frame, std::size_t i) {
  return touches(frame, i) ? 0 : std::max(frame.lineHeight[i] - frame.surfaceHeight[i], 0.0);
}

/// Returns a value of the frame that is computed only on request.
double valueAt(const Frame& frame, const std::vector<double>& field, std::size_t i) {
  return field.size() == frame.pressure.size() ? field[i] : kNotApplicable;
}

/// Calls `use` with each point of an interval.
template <class Use>
void forEachPoint(const Frame& frame, const ContactInterval& interval, const Use& use) {
  const std::size_t n = frame.pressure.size();
  for (std::size_t k = 0; k < interval.points; ++k) use((interval.first + k) % n);
}

struct SpotForces {
  double normal = 0, tangential = 0, largest = 0;  // N, N, N/m
};

SpotForces spotForces(const Frame& frame, const ContactInterval& contact) {
  SpotForces forces;
  forEachPoint(frame, contact, [&](std::size_t i) {
    const double pressure = frame.pressure[i];
    forces.normal += pressure * frame.spacing;
    forces.tangential -= pressure * lineSlopeAt(frame, i) * frame.spacing;
    forces.largest = std::max(forces.largest, pressure);
  });
  return forces;
}

struct GapSize {
  double area = 0, largest = 0;  // m^2, m
};

GapSize gapSize(const Frame& frame, const ContactInterval& gap) {
  GapSize size;
  forEachPoint(frame, gap, [&](std::size_t i) {
    size.area += gapAt(frame, i) * frame.spacing;
    size.largest = std::max(size.largest, gapAt(frame, i));
  });
  return size;
}

struct PowerBalance {
  double in = 0, contact = 0, free = 0, interface = 0;  // W
  double dissipated() const { return contact + free + interface; }
};

/// Returns the balance of power of a frame. In contact the elastomer has the part of Frame::power
/// that local friction does not take.
PowerBalance powerBalance(const Frame& frame) {
  PowerBalance balance;
  const double speed = std::abs(frame.velocity);
  // Friction of the steady state belongs to the line as a whole; a motion's to its last steps.
  const ContactState& state = frame.state;
  const double force =
      std::isfinite(state.mu) ? state.mu * state.normalForce : state.tangentialForce;
  const Interface local = frame.scene ? interfaceAt(*frame.scene, frame.velocity) : Interface{};
  for (std::size_t i = 0; i < frame.pressure.size(); ++i) {
    const double power = valueAt(frame, frame.power, i) * frame.spacing;
    if (!touches(frame, i)) {
      balance.free += power;
      continue;
    }
    const double here = localFrictionLoad(local, frame.pressure[i]) * speed * frame.spacing;
    balance.interface += here;
    balance.contact += power - here;
  }
  balance.in = force * speed + balance.interface;
  return balance;
}

}  // namespace

FrameFields fieldsForTables() {
  return {.lineSlope = true, .sinceContact = true, .power = true};
}

std::vector<ContactInterval> findIntervals(const Frame& frame, bool isGap) {
  const std::size_t n = frame.pressure.size();
  std::vector<ContactInterval> intervals;
  const auto belongs = [&](std::size_t i) { return touches(frame, i % n) != isGap; };
  for (std::size_t i = 0; i < n; ++i) {
    if (!belongs(i) || belongs(i + n - 1)) continue;  // not the first point of an interval
    std::size_t points = 1;
    while (points < n && belongs(i + points)) ++points;
    intervals.push_back({(static_cast<double>(i) - 0.5) * frame.spacing,
                         static_cast<double>(points) * frame.spacing, i, points});
  }
  if (intervals.empty() && n > 0 && belongs(0))
    intervals.push_back({-0.5 * frame.spacing, static_cast<double>(n) * frame.spacing, 0, n});
  return intervals;
}

std::vector<double> timeInContact(const Frame& frame) {
  const std::size_t n = frame.pressure.size();
  std::vector<double> times(n, 0);
  const bool isKnown = !frame.transient && !frame.isSettling && frame.velocity != 0;
  for (const ContactInterval& contact : findIntervals(frame, false)) {
    const bool hasEdge = contact.points < n;
    for (std::size_t k = 0; k < contact.points; ++k) {
      // The line moves towards +x for v > 0, so its edge on that side meets the elastomer first.
      const std::size_t ahead = frame.velocity > 0 ? contact.points - 1 - k : k;
      const double distance = (static_cast<double>(ahead) + 0.5) * frame.spacing;
      times[(contact.first + k) % n] =
          isKnown && hasEdge ? distance / std::abs(frame.velocity) : kNotApplicable;
    }
  }
  return times;
}

DataTable shapeTable(const Frame& frame) {
  DataTable table{columnNames({"position", "rigid_height", "surface_height", "gap", "line_load",
                               "time_in_contact", "power", "time_since_contact"}),
                  {}};
  const std::vector<double> inContact = timeInContact(frame);
  for (std::size_t i = 0; i < frame.pressure.size(); ++i)
    table.rows.push_back({static_cast<double>(i) * frame.spacing, frame.lineHeight[i],
                          frame.surfaceHeight[i], gapAt(frame, i), frame.pressure[i], inContact[i],
                          valueAt(frame, frame.power, i), valueAt(frame, frame.sinceContact, i)});
  return table;
}

DataTable contactsTable(const Frame& frame) {
  DataTable table{columnNames({"start", "length", "normal_force", "tangential_force",
                               "mean_line_load", "largest_line_load"}),
                  {}};
  for (const ContactInterval& contact : findIntervals(frame, false)) {
    const SpotForces forces = spotForces(frame, contact);
    table.rows.push_back({contact.start, contact.length, forces.normal, forces.tangential,
                          forces.normal / contact.length, forces.largest});
  }
  return table;
}

DataTable gapsTable(const Frame& frame) {
  DataTable table{columnNames({"start", "length", "mean_gap", "largest_gap", "area"}), {}};
  for (const ContactInterval& gap : findIntervals(frame, true)) {
    const GapSize size = gapSize(frame, gap);
    table.rows.push_back({gap.start, gap.length, size.area / gap.length, size.largest, size.area});
  }
  return table;
}

DataTable powerTable(const Frame& frame) {
  const PowerBalance balance = powerBalance(frame);
  return {columnNames({"velocity", "power_in", "power_contact", "power_free", "power_interface",
                       "power_dissipated", "power_difference"}),
          {{frame.velocity, balance.in, balance.contact, balance.free, balance.interface,
            balance.dissipated(), balance.in - balance.dissipated()}}};
}

namespace {

bool isNodal(const Frame& frame) {
  return frame.scene && frame.scene->accuracy.scheme == Scheme::Nodal;
}

}  // namespace

std::optional<Message> coarsePointsNote(const Frame& frame) {
  constexpr double kMaxDeviation = 0.05;
  const double part = normalForce(frame.pressure, frame.spacing) / frame.state.normalForce;
  if (!(std::abs(part - 1) > kMaxDeviation)) return std::nullopt;
  if (isNodal(frame))
    return message(
        "the loads of the elements add up to {} % of the normal force, because one element more or "
        "less changes it by so much; more surface.elements change it by less",
        printedPercent(part));
  return message(
      "the loads of the points add up to {} % of the normal force, because contacts are hardly "
      "longer than the distance between points; a larger accuracy.oversampling has more points",
      printedPercent(part));
}

std::optional<Message> coarsePowerNote(const Frame& frame) {
  constexpr double kMaxDeviation = 0.005;
  if (frame.transient || frame.isSettling) return std::nullopt;
  const PowerBalance balance = powerBalance(frame);
  if (!(std::abs(balance.in) > 0)) return std::nullopt;
  const double part = balance.dissipated() / balance.in;
  if (!(std::abs(part - 1) > kMaxDeviation)) return std::nullopt;
  if (isNodal(frame))
    return message(
        "the powers of the elements add up to {} % of the power of friction: separate elements "
        "balance it only where many of them are in each contact",
        printedPercent(part, 4));
  return message(
      "the powers at the points add up to {} % of the power of friction, because the points or the "
      "segments of the line are coarse; a larger accuracy.oversampling makes both finer",
      printedPercent(part, 4));
}

Json derivedNumbers(const Frame& frame) {
  const std::vector<ContactInterval> contacts = findIntervals(frame, false);
  const std::vector<ContactInterval> gaps = findIntervals(frame, true);
  double largestLoad = 0, longest = 0, inContact = 0, largestGap = 0, area = 0;
  for (const ContactInterval& contact : contacts) {
    largestLoad = std::max(largestLoad, spotForces(frame, contact).largest);
    longest = std::max(longest, contact.length);
    inContact += contact.length;
  }
  for (const ContactInterval& gap : gaps) {
    const GapSize size = gapSize(frame, gap);
    largestGap = std::max(largestGap, size.largest);
    area += size.area;
  }
  return {{"length", frame.length},
          {"spacing", frame.spacing},
          {"velocity", frame.velocity},
          {"normal_force", frame.state.normalForce},
          {"tangential_force", numberOrNull(frame.state.tangentialForce)},
          {"rms_height", frame.rmsHeight},
          {"rms_slope", frame.rmsSlope},
          {"contact_spots", contacts.size()},
          {"mean_contact_length",
           numberOrNull(contacts.empty() ? kNotApplicable
                                         : inContact / static_cast<double>(contacts.size()))},
          {"largest_contact_length", longest},
          {"mean_line_load",
           numberOrNull(inContact > 0 ? frame.state.normalForce / inContact : kNotApplicable)},
          {"largest_line_load", largestLoad},
          {"mean_gap", area / frame.length},
          {"largest_gap", largestGap}};
}

namespace {

PrintedNumber coefficient(double mu) {
  return printed(mu, 3, Zeros::Keep);
}

/// Returns the velocity at this moment, m/s; above 0 the line moves to the right.
double presentVelocity(const Frame& frame) {
  return frame.transient ? frame.velocity : frame.scene->sliding.velocity;
}

/// Returns how the rigid line moves.
Message motionInWords(const Frame& frame) {
  const double velocity = presentVelocity(frame);
  const PrintedNumber speed = printed(std::abs(velocity), "m/s");
  if (frame.transient) {
    const PrintedNumber time = printed(frame.time, "s");
    if (velocity == 0) return message("At {} of the motion the rigid line rests.", time);
    return velocity > 0 ? message("At {} of the motion the rigid line slides to the right at {}.",
                                  time, speed)
                        : message("At {} of the motion the rigid line slides to the left at {}.",
                                  time, speed);
  }
  if (velocity == 0) return message("The rigid line rests.");
  return velocity > 0 ? message("The rigid line slides to the right at {}.", speed)
                      : message("The rigid line slides to the left at {}.", speed);
}

/// Returns where the bodies touch. The contact spots are those of the picture.
Message touchInWords(const Frame& frame, const ContactState& state) {
  const std::vector<ContactInterval> contacts = findIntervals(frame, false);
  if (contacts.empty()) return message("The bodies do not touch.");
  if (state.contactFraction >= 1) return message("All of the surface is in contact.");
  double longest = 0;
  for (const ContactInterval& contact : contacts) longest = std::max(longest, contact.length);
  const PrintedNumber part = printedPercent(state.contactFraction),
                      period = printed(frame.length, "m"), length = printed(longest, "m");
  // Between two nodes the picture may have a point more or fewer than the steady state.
  if (contacts.size() == 1)
    return message("They touch at one contact of {}, which is {} % of the period of {}.",
                   printed(state.contactFraction * frame.length, "m"), part, period);
  return message("They touch at {} contacts, {} % of the period of {}; the longest contact is {}.",
                 contacts.size(), part, period, length);
}

/// Returns what friction is and where it comes from.
Message frictionInWords(const Frame& frame, const ContactState& state) {
  const bool isElastic = elementLaw(frame.scene->elastomer).kind() == ElementKind::Elastic;
  if (!(state.normalForce > 0)) return message("Without a normal force there is no friction.");
  if (presentVelocity(frame) == 0 && !frame.transient)
    return message("At rest there is no friction here.");
  if (!std::isfinite(state.mu))
    return message("Friction cannot be read here: elements or time steps are too coarse for it.");
  if (hasLocalFriction(*frame.scene)) {
    if (isElastic)
      return message("The coefficient of friction is {}, all of it from the interface.",
                     coefficient(state.muInterface));
    return message(
        "The coefficient of friction is {}: {} from the deformation of the elastomer and {} from "
        "the interface.",
        coefficient(state.mu + state.muInterface), coefficient(state.mu),
        coefficient(state.muInterface));
  }
  if (isElastic)
    return message(
        "There is no friction: an elastic body gives back all the work of its deformation.");
  return message(
      "The coefficient of friction is {}: a tangential force of {}, all of it from the deformation "
      "of the elastomer.",
      coefficient(state.mu), printed(std::abs(state.tangentialForce), "N"));
}

/// Returns the friction of other lines by the friction curve; empty where it is not known.
Message curveInWords(const CurveAtVelocity& curve) {
  Message mean, region;
  // All lines agree where they are the same line, except for rounding.
  constexpr double kRounding = 1e-5;
  const double share = std::abs(curve.error / curve.mu);
  if (curve.lines > 1 && std::isfinite(curve.mu) && share > kRounding)
    mean = message("The mean of {} lines is {} ± {} %.", curve.lines, coefficient(curve.mu),
                   printedPercent(share, 1));
  if (!curve.region.empty())
    region = message("This is region {} of the friction curve, {}.", curve.region,
                     Message(regionWord(curve.region)));
  return sentences({mean, region});
}

}  // namespace

std::vector<Message> describeContact(const Frame& frame, const CurveAtVelocity& curve) {
  if (!frame.scene) return {};
  const ContactState& state = frame.drawn();
  std::vector<Message> text;
  text.push_back(motionInWords(frame));
  text.push_back(message("It presses with {}; its lowest point is {} below the undeformed surface.",
                         printed(state.normalForce, "N"), printed(state.indentation, "m")));
  text.push_back(touchInWords(frame, state));
  text.push_back(frictionInWords(frame, state));
  if (Message of = curveInWords(curve); !of.empty()) text.push_back(std::move(of));
  if (frame.isSettling)
    text.push_back(
        std::isfinite(frame.state.mu)
            ? message("The picture still moves to the steady state, whose coefficient is {}.",
                      coefficient(frame.state.mu))
            : message("The picture still moves to the steady state."));
  for (const Note note : curve.notes.list())
    text.push_back(message("Note: {}.", noteSentence(note)));
  return text;
}

}  // namespace asperity
