#include "ui/window/main/frame_display.h"

#include <memory>

#include "core/run/runner.h"
#include "ui/language/language.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/contact/time_bar.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"

namespace asperity {

namespace {

LineSize lineSize(const Frame& frame) {
  return {frame.length, frame.elements};
}

}  // namespace

FrameDisplay::FrameDisplay(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  Session& session = parts_.session;
  session.drawFirst([canvas = &parts_.canvas](const std::shared_ptr<const Frame>& frame) {
    canvas->setFrame(frame);
  });
  connect(&parts_.canvas, &ContactCanvas::frameShown, &session, &Session::show);
  connect(&session, &Session::frameArrived, this, &FrameDisplay::showFrame);
  connect(&session, &Session::frameLost, this, [this] {
    parts_.canvas.setFrame(nullptr);
    parts_.tabs.clearFrame();
    parts_.status.clearReadings();
  });
  // While time is paused no frame follows a curve that is complete.
  connect(&session, &Session::plotChanged, this, [this] {
    if (parts_.session.frame()) showReadings();
  });
  keepTranslated(parts_.canvas, [this] { showVeil(); });
  connect(&session, &Session::waitingChanged, this, &FrameDisplay::showVeil);
  connect(&session, &Session::errorOccurred, this, &FrameDisplay::showVeil);
  connect(&session, &Session::sceneRuns, this, &FrameDisplay::showVeil);
}

/// Dims a contact of the previous scene and its readings. A scene that was posted twice has its own
/// contact before the second frame comes.
void FrameDisplay::showVeil() {
  const bool isWaiting = parts_.session.isWaiting();
  const bool isMissing = isWaiting || parts_.session.isRefused();
  const std::shared_ptr<const Frame> frame = parts_.session.frame();
  const bool hasIt = isMissing && frame && frame->scene && *frame->scene == parts_.session.scene();
  parts_.status.fadeReadings(isMissing && !hasIt);
  if (!isMissing || hasIt)
    parts_.canvas.setVeil({});
  else if (!frame)
    parts_.canvas.setVeil(isWaiting ? tr("This scene is being computed")
                                    : tr("This scene cannot be computed"));
  else
    parts_.canvas.setVeil(
        isWaiting ? tr("This is the previous scene; the changed one is being computed")
                  : tr("This is the previous scene; the changed one cannot be computed"));
}

void FrameDisplay::showFrame() {
  const std::shared_ptr<const Frame> frame = parts_.session.frame();
  if (!frame) return;
  showVeil();
  parts_.tabs.showFrame(*frame);
  if (frame->sceneNumber == parts_.session.sceneNumber()) {
    parts_.time.showFrame(*frame, parts_.session.requestedMoment());
    parts_.panel.showLine(lineSize(*frame));
  }
  showReadings();
}

/// Shows the readings of the present frame and, at its state, of the present curve.
void FrameDisplay::showReadings() {
  const std::shared_ptr<const Frame> frame = parts_.session.frame();
  CurveReading reading = readCurve(*frame, parts_.session.curve());
  if (parts_.session.friction().isConcealed()) {
    // The student is to guess the shape of the curve. Some lessons read the mean at the present
    // state; where a point of the curve is asked for, the mean would be that point.
    if (parts_.isPointAsked()) reading.mu = kNotApplicable;
    if (!reading.region.empty()) reading.regime.clear();
    reading.region.clear();
    reading.notes = {};
  }
  parts_.status.showFrame(*frame, reading);
  if (frame->sceneNumber == parts_.session.sceneNumber()) showWarnings(*frame, reading.notes);
}

/// Shows at the parameters the notes on the limits of the present result. Until the curve of a
/// changed scene is complete, the previous warnings stay, so that rows do not move back and forth
/// during the computation.
void FrameDisplay::showWarnings(const Frame& frame, NoteSet notes) {
  const CurveUpdate* curve = parts_.session.curve();
  if (!curve || !haveSameCurve(*frame.scene, *curve->scene)) return;
  if (!curve->isComplete && parts_.session.averaging() == Session::Averaging::Running) return;
  notes.add(Note::SlopeAbove, frame.rmsSlope > kSmallSlope);
  parts_.panel.showNotes(notes);
}

}  // namespace asperity
