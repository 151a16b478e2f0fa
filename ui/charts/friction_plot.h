// The diagram of friction coefficient against velocity: collects what the runner delivers and says
// what to show. Knows when the curve at hand belongs to an older scene (then it is drawn faded and
// never mixed with the new one). Owned by the window; one thread. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <cstdint>
#include <optional>

#include "core/run/frame.h"
#include "core/run/runner.h"
#include "ui/charts/plot.h"

namespace asperity {

/// Whether two scenes have the same averaged curve: all but title and present velocity agree.
bool haveSameCurve(const Scene& a, const Scene& b);

class FrictionPlot {
  Q_DECLARE_TR_FUNCTIONS(asperity::FrictionPlot)

 public:
  /// A scene was posted: its velocities are in the range at once; the curve at hand is stale unless
  /// it is that scene's, too.
  void expect(const Scene& scene);

  /// A later state of a curve. Ignored when it is not of the expected scene or has no point yet.
  /// Returns whether it is shown.
  bool take(const CurveUpdate& update);

  /// The velocity of this frame and the steady friction of its line.
  void mark(const Frame& frame);

  bool isStale() const;
  Plot plot() const;

 private:
  bool isOneLine() const;
  PlotSeries measured() const;
  PlotSeries law() const;
  QString note() const;
  QString blank() const;
  void fitRanges(bool newCurve);
  DecadeRange neededCoefficients(const DecadeRange& data) const;

  std::optional<Scene> expected_;
  std::optional<CurveUpdate> curve_;
  std::optional<PlotMarker> marker_;
  DecadeRange velocities_, coefficients_;
};

}  // namespace asperity
