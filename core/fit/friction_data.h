// Measured coefficients of friction, as a person brings them in a table. Plain values.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// One row. What the table does not give is NaN, and the scene's own value is meant.
struct MeasuredPoint {
  double velocity = 0;  // m/s, above 0
  double mu = 0;        // above 0
  double muError = kNotApplicable;
  double velocityError = kNotApplicable;    // m/s
  double normalForce = kNotApplicable;      // N
  double nominalPressure = kNotApplicable;  // Pa
  double temperature = kNotApplicable;      // K
  std::string label;
  int row = 0;  // of the file, counted from 1
};

struct FrictionData {
  std::string name;  // of its legend: given, or the file's
  std::vector<MeasuredPoint> points;
  std::vector<Message> notes;  // what the columns were taken for

  bool hasErrors() const { return !points.empty() && !std::isnan(points.front().muError); }
};

/// The scene as it was when the point was measured: its velocity, and force, pressure and
/// temperature where the table gives them.
Scene sceneOf(const MeasuredPoint& point, const Scene& scene);

}  // namespace asperity
