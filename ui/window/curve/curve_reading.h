// What a friction curve says of the velocity that is shown: mean and standard error there, and in
// which region it lies. Pure; any thread.
#pragma once

#include <QString>

#include "core/run/frame.h"
#include "core/run/runner.h"

namespace asperity {

struct CurveReading {
  double mu = kNotApplicable;     // mean of the lines, between two points of the curve
  double error = kNotApplicable;  // standard error of it
  QString regime;                 // "region III, plateau", "at rest"; empty: not known
};

/// `curve`: of the frame's scene, or null.
CurveReading readCurve(const Frame& frame, const CurveUpdate* curve);

}  // namespace asperity
