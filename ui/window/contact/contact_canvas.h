// The contact view. It draws frames with OpenGL where the graphics hardware supports it in a
// window, otherwise with images of the program's own rasterizer: OpenGL in software draws the same
// pictures for five times the processor time. It switches at run time if OpenGL does not work. The
// environment variable ASPERITY_CANVAS ("opengl", "software") overrides this choice. Wheel and
// pinch zoom at the cursor; with Ctrl they change the vertical exaggeration, with Shift they move
// the view in x. Dragging moves the view; the rigid body dragged up or down, the force's arrow and
// the velocity's change the scene (ui/contact/contact_signs.h): the shape of the cursor and a tip
// show this before and during the drag, and Escape undoes it. The cursor is a crosshair with a
// readout. Keys while it has the focus: arrows move the view, with Ctrl they move the crosshair by
// an element (with Shift by ten), with Shift the up and down arrows change the exaggeration;
// contact_view_actions.cpp has the other keys. GUI thread; owned by its parent. Failure: where
// nothing can draw, it shows a message and stays empty.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <deque>
#include <memory>
#include <optional>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/contact/contact_signs.h"
#include "ui/contact/contact_viewer.h"
#include "ui/language/language.h"
#include "ui/window/contact/canvas_backend.h"

class QMenu;
class QVBoxLayout;

namespace asperity {

class ContactVeil;
struct ContactTip;

class ContactCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ContactCanvas(QWidget* parent = nullptr);

  /// Draws the frame; frameShown() follows when its picture is ready.
  void setFrame(std::shared_ptr<const Frame> frame);
  void setTheme(const Theme& theme);

  /// Sets the scene that drags change; without one they only move the view.
  void setScene(const Scene& scene) { scene_ = scene; }
  /// Changes what a drag of the handle changes, as by a drag of a few pixels: downwards, or in the
  /// direction of sliding, for positive steps.
  void nudge(ContactHandle handle, double steps);

  /// Sets a factor for texts and lines, for an audience.
  void setTextScale(double scale);
  double textScale() const { return textScale_; }
  /// Returns the height of the numbers in device pixels where texts are scaled: that of the font,
  /// as in the chart, however low the picture is. 0 otherwise: it follows the size of the picture.
  float fontSize() const;

  /// Covers the picture with a translucent veil that shows the reason; empty: no veil.
  void setVeil(const QString& reason);

  /// Returns "OpenGL" or "software"; empty where neither works.
  QString backendName() const;

  /// Returns the number of pictures shown during the last second.
  int framesPerSecond() const;

  /// Returns the frame of the last request; null before the first.
  const Frame* frame() const { return viewer_.frame().get(); }

  const ContactViewer& viewer() const { return viewer_; }

  /// Zooms, or changes the exaggeration, by steps, at the crosshair or in the middle.
  void zoom(double steps);
  void exaggerate(double steps);
  void fit();
  void fitHeights();
  void follow(bool follows);
  void magnify(bool magnifies);
  void setOverlay(ContactOverlay overlay);
  void setNavigation(const ViewNavigation& navigation);

  /// Returns the optional values that frames need for the present view.
  FrameFields fields() const { return viewer_.fields(); }

  /// Returns the plot's area in the widget's pixels; empty before the first frame.
  QRectF plotArea() const;

  /// Opens the guide at the object that was under the pointer when the menu was opened.
  void readAbout();

 signals:
  /// Emitted once for each frame whose picture is ready, and at once where nothing can draw: what
  /// changes now is painted together with it. Frames that come too fast are left out.
  void frameShown(std::shared_ptr<const asperity::Frame> frame);
  void painted();
  void failed(const asperity::LiveText& reason);
  void viewChanged();
  void fieldsChanged(const asperity::FrameFields& fields);
  /// Emitted at each step of a drag that changes the scene.
  void sceneEdited(const asperity::Scene& scene);
  void guideRequested(const QString& anchor);
  /// Emitted with a sentence on what a drag from the pointer does.
  void statusMessage(const QString& sentence);

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void useOpenGl();
  void useSoftware();
  CanvasEvents eventsOfPictures();
  void setBackend(CanvasBackend* backend);
  void removeBackend();
  void showFailure(const LiveText& reason);
  void takeReady(const std::shared_ptr<const Frame>& frame);
  void takePainted(const std::vector<LabelPlace>& labels);
  void refresh();
  void giveLabelsSpace();
  PictureRequest request() const;

  std::optional<ViewPosition> viewPositionAt(const QPointF& position) const;
  ViewPosition zoomCentre() const;
  void showCrosshair(const QPointF& position);
  void hideCrosshair();
  void movePointer(int elements);
  ContactTip tipAt(const QPointF& position) const;
  ContactHandle handleUnder(const QPointF& position) const;
  void showHandle(ContactHandle handle);
  void startDrag(const QPointF& position);
  void continueDrag(const QPointF& position);
  void endDrag();
  void pinch(const QPointF& position, double factor);
  void changed();
  QPoint tipPlace(const QRectF& explained, const QPoint& pointer) const;
  void explain(const QPoint& position);

  QVBoxLayout* layout_;
  CanvasBackend* backend_ = nullptr;  // a child widget
  ContactVeil* veil_;                 // covers it
  ContactViewer viewer_;
  FrameFields requestedFields_;
  Theme theme_ = lightTheme();
  double textScale_ = 1;
  std::vector<LabelPlace> labels_;  // of the picture on the screen
  std::optional<QPointF> dragged_;  // last position of the cursor while a button is down
  std::optional<Scene> scene_;
  /// The handle that the drag moves, and the scene and the heights (m) at its beginning. The first
  /// pixels decide whether a drag of the body moves the body or, sideways, the view.
  struct Grip {
    ContactHandle handle;
    QPointF from;
    Scene scene;
    double height;
    bool isDecided;
  };
  std::optional<Grip> grip_;
  bool isPinching_ = false;
  bool hasHint_ = false;  // what a drag of the body does was shown in the status line
  QString guideAnchor_;   // of the object that was under the pointer when the menu was opened
  QElapsedTimer clock_;
  mutable std::deque<qint64> pictures_;  // the times when they were shown, ms
  std::shared_ptr<const Frame> shown_;   // the last one whose picture was ready
};

/// Adds the commands of the canvas to it, for its context menu and their keys, and to a menu: zoom,
/// exaggeration, loads and velocity, following the line, the magnifier, the quantity shown by
/// colours. They belong to the canvas and show its state. Call it once.
void addContactViewActions(ContactCanvas& canvas, QMenu& menu);

}  // namespace asperity
