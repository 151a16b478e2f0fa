// The contact view: shows frames by OpenGL where a window can have it from its graphics hardware,
// else by images from OSMesa: OpenGL in software draws the same pictures, but on the GUI thread
// and, with the window's own composition, at half the rate. Changes over at run time if OpenGL
// turns out not to work. The environment variable ASPERITY_CANVAS ("opengl", "software") decides
// otherwise. GUI thread; owned by its parent. Failure: where neither works, it says so and stays
// empty.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <deque>
#include <memory>

#include "core/run/frame.h"
#include "ui/picture/contact_picture.h"

class QVBoxLayout;

namespace asperity {

class CanvasBackend;

class ContactCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ContactCanvas(QWidget* parent = nullptr);

  void setFrame(std::shared_ptr<const Frame> frame);
  void setTheme(const Theme& theme);

  /// "OpenGL" or "software (OSMesa)"; empty where neither works.
  QString backendName() const;

  /// Pictures shown during the last second.
  int framesPerSecond() const;

  /// The frame that was last asked to be shown; null before the first.
  const Frame* frame() const { return frame_.get(); }

 signals:
  void painted();
  void failed(const QString& reason);

 private:
  void useOpenGl();
  void useSoftware();
  void place(CanvasBackend* backend);
  void giveUp(const QString& reason);
  void countPicture();
  void refresh();

  QVBoxLayout* layout_;
  CanvasBackend* backend_ = nullptr;  // a child widget
  std::shared_ptr<const Frame> frame_;
  Theme theme_ = lightTheme();
  QElapsedTimer clock_;
  mutable std::deque<qint64> pictures_;  // when they were shown, ms
};

}  // namespace asperity
