// Shows one of the paper's figures, drawn again for each size and theme, or a line of text where
// there is none: as a whole, or its diagrams one at a time. Pictures are made in the background.
// GUI thread; owned by its parent. Failure: a signal, where no picture can be made.
#pragma once

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <memory>

#include "ui/draw/theme.h"
#include "ui/language/language.h"
#include "ui/window/figures/figure_queue.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

/// Shows a figure as a whole.
class FigurePicture : public QWidget {
  Q_OBJECT

 public:
  explicit FigurePicture(QWidget* parent = nullptr);

  void showFigure(std::shared_ptr<const ComputedFigure> made);
  void showText(const QString& text);
  void setTheme(const Theme& theme);
  /// Sets the minimum size of texts, relative to their usual size; otherwise a low picture would
  /// have smaller ones.
  void setMinTextSize(float part);

  /// Returns whether the picture shows the last figure at this size and in this theme.
  bool isPainted() const;
  const QImage& image() const { return image_; }

  QSize sizeHint() const override { return {900, 560}; }
  QSize minimumSizeHint() const override { return {320, 200}; }

 signals:
  void painted();
  void failed(const asperity::LiveText& reason);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void requestPicture();
  void describe();

  std::shared_ptr<const ComputedFigure> figure_;
  QString text_;
  Theme theme_ = lightTheme();
  float minTextSize_ = 0;
  QImage image_;
  // Last: its thread ends before other members are destroyed.
  BackgroundWork pictures_{RequestPolicy::ReplaceWaiting};
};

}  // namespace asperity
