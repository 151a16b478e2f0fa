// What the window shows of the session's frames: the picture of the contact, the tabs, the moment,
// the readings and the warnings at the parameters. A new frame is drawn first, in the background;
// when its picture is ready, all of them change together and tell the same moment. A contact of the
// scene before is dimmed. GUI thread.
#pragma once

#include <QObject>
#include <functional>

#include "core/run/frame.h"
#include "core/scene/notes.h"

namespace asperity {

class ContactCanvas;
class ParameterPanel;
class SceneTabs;
class Session;
class StatusLine;
class TimeBar;

class FrameDisplay : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Session& session;
    ContactCanvas& canvas;
    SceneTabs& tabs;
    TimeBar& time;
    StatusLine& status;
    ParameterPanel& panel;
    /// Returns whether a lesson asks for a point of the curve, which the mean here would be.
    std::function<bool()> isPointAsked;
  };

  FrameDisplay(const Parts& parts, QObject* parent);

  /// Shows the session's frame again, where something else than the frame has changed.
  void showFrame();

 private:
  void showVeil();
  void showReadings();
  void showWarnings(const Frame& frame, NoteSet notes);

  Parts parts_;
};

}  // namespace asperity
