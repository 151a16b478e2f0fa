// Reads a friction curve at the velocity that is shown: mean and standard error, the region, and
// the notes that a user must know. Pure; any thread.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "core/run/frame.h"
#include "core/run/runner.h"

namespace asperity {

struct CurveReading {
  double mu = kNotApplicable;             // mean over the lines, interpolated on the curve
  double error = kNotApplicable;          // standard error of mu
  bool isInterpolated = false;            // mu lies between two points of the curve
  std::int64_t lines = 0;                 // over which mu is a mean
  std::string region{};                   // "III"; empty: not known
  QString regime;                         // "region III, plateau", "at rest"; empty: not known
  NoteSet notes{};                        // of the curve's points on both sides of the velocity
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
