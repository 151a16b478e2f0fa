// Reads a friction curve at the velocity that is shown: mean and standard error, the region, and
// the notes that a user must know. Pure; any thread.
#pragma once

#include <QString>
#include <optional>

#include "core/run/contact_report.h"
#include "core/run/runner.h"

namespace asperity {

/// The notes are those of the curve's points on both sides of the velocity.
struct CurveReading : CurveAtVelocity {
  bool isInterpolated = false;            // mu lies between two points of the curve
  QString regime;                         // "region III, plateau", "at rest"; empty: not known
  std::optional<Message> missedTarget{};  // why the curve misses the target of its scene
};

/// Returns "region III, plateau" for "III".
QString regionText(std::string_view name);

/// Returns a sentence that distinguishes the error beside a reading from that of the whole curve:
/// both places that show one of them have it in their tips.
QString errorsInWords();

/// Reads the curve at the frame's velocity. `curve`: of the frame's scene, or null.
CurveReading readCurve(const Frame& frame, const CurveUpdate* curve);

}  // namespace asperity
