// Shows diagrams that are made and drawn in the background, the newest wish only, and only while it
// is visible. GUI thread; belongs to its parent. Failure: what cannot be made is said in the place
// of the picture; where nothing draws, the signal.
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
  /// Called on the worker's thread; may throw.
  using Maker = std::function<DiagramSheet()>;

  explicit DiagramView(QWidget* parent = nullptr);

  /// What to show from now on; wishes that come fast are thinned out.
  void show(Maker maker);
  void setTheme(const Theme& theme);

  /// Whether the newest wish is on the screen.
  bool isPainted() const { return shown_ > 0 && shown_ == asked_ && !isDue_; }
  const QImage& image() const { return image_; }

  QSize minimumSizeHint() const override { return {320, 170}; }

 signals:
  void painted();
  void failed(const QString& reason);
  /// Only a diagram that is seen needs data.
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
  // Last: its thread ends before anything else here goes.
  BackgroundWork pictures_{Overtaking::SkipsTheWaiting};
};

}  // namespace asperity
