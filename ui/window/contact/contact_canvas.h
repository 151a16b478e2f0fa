// The contact view: shows frames by OpenGL where a window can have it from its graphics hardware,
// else by images from OSMesa: OpenGL in software draws the same pictures, but on the GUI thread
// and, with the window's own composition, at half the rate. Changes over at run time if OpenGL
// turns out not to work. The environment variable ASPERITY_CANVAS ("opengl", "software") decides
// otherwise.
// Wheel and pinch zoom at the cursor, with Ctrl they change the vertical exaggeration, with Shift
// they move along; dragging moves; the cursor is a crosshair with a readout. Keys while it has the
// focus: arrows move, with Ctrl they move the crosshair by an element (with Shift by ten), with
// Shift up and down change the exaggeration; the others are contact_view_actions.h.
// GUI thread; owned by its parent. Failure: where nothing draws, it says so and stays empty.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <deque>
#include <memory>
#include <optional>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/contact/contact_viewer.h"
#include "ui/window/contact/canvas_backend.h"

class QLabel;
class QVBoxLayout;

namespace asperity {

class ContactCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ContactCanvas(QWidget* parent = nullptr);

  void setFrame(std::shared_ptr<const Frame> frame);
  void setTheme(const Theme& theme);

  /// Larger texts and lines, for an audience.
  void setTextScale(double scale);
  double textScale() const { return textScale_; }

  /// Veils the picture and says why; empty: it is seen as it is.
  void setVeil(const QString& reason);

  /// "OpenGL" or "software (OSMesa)"; empty where neither works.
  QString backendName() const;

  /// Pictures shown during the last second.
  int framesPerSecond() const;

  /// The frame that was last asked to be shown; null before the first.
  const Frame* frame() const { return viewer_.frame().get(); }

  const ContactViewer& viewer() const { return viewer_; }

  /// Steps of zoom or exaggeration, at the crosshair or in the middle.
  void zoom(double steps);
  void exaggerate(double steps);
  void fit();
  void fitHeights();
  void follow(bool follows);
  void magnify(bool magnifies);
  void setOverlay(ContactOverlay overlay);

  /// The fields that frames have to hold for what is shown.
  FrameFields fields() const { return viewer_.fields(); }

  /// The plot in the widget's pixels; empty before the first frame.
  QRectF plotArea() const;

 signals:
  void painted();
  void failed(const QString& reason);
  void viewChanged();
  void fieldsWanted(const asperity::FrameFields& fields);

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
  void place(CanvasBackend* backend);
  void giveUp(const QString& reason);
  void countPicture();
  void refresh();
  void paintVeil();
  PictureRequest request() const;

  std::optional<ViewPlace> placeAt(const QPointF& position) const;
  ViewPlace focusPlace() const;
  void showCrosshair(const QPointF& position);
  void movePointer(int elements);
  QString tipAt(const QPointF& position) const;
  void pinch(const QPointF& position, double factor);
  void changed();

  QVBoxLayout* layout_;
  CanvasBackend* backend_ = nullptr;  // a child widget
  QLabel* veil_;                      // over it
  ContactViewer viewer_;
  FrameFields wanted_;
  Theme theme_ = lightTheme();
  double textScale_ = 1;
  std::optional<QPointF> dragged_;  // the cursor's last place while a button is down
  bool isPinching_ = false;
  QElapsedTimer clock_;
  mutable std::deque<qint64> pictures_;  // when they were shown, ms
};

}  // namespace asperity
