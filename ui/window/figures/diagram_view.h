// Shows diagrams that are made and drawn in the background: only the newest request, and only while
// the view is visible. GUI thread; belongs to its parent. Failure: an error of the maker is shown
// as text in place of the picture; where nothing can draw, the signal reports it.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>

#include "core/chart/diagram.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/tasks/background_work.h"

class QTimer;

namespace asperity {

class DiagramView : public QWidget {
  Q_OBJECT

 public:
  /// Makes the diagram. It is called on the worker's thread and may throw.
  using Maker = std::function<DiagramSheet()>;

  explicit DiagramView(QWidget* parent = nullptr);

  /// Sets the diagram to show from now on; of many fast requests some are skipped.
  void show(Maker maker);
  void setTheme(const Theme& theme);

  /// Returns whether the newest request is on the screen.
  bool isPainted() const { return shown_ > 0 && shown_ == asked_ && !isDue_; }
  const QImage& image() const { return image_; }

  QSize minimumSizeHint() const override { return {320, 170}; }

 signals:
  void painted();
  void failed(const QString& reason);
  /// Emitted when the view appears or disappears: only a visible diagram needs data.
  void visibilityChanged(bool isVisible);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void requestSoon();
  void request();

  Maker maker_;
  Theme theme_ = lightTheme();
  QImage image_;
  QTimer* pause_;
  bool isDue_ = false;
  quint64 asked_ = 0, shown_ = 0;  // numbers of requests
  // Last: its thread ends before other members are destroyed.
  BackgroundWork pictures_{Overtaking::SkipsTheWaiting};
};

}  // namespace asperity
