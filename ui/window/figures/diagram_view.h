// Shows diagrams, or another picture, that are made and drawn in the background for the size, the
// palette, the font and the language of the view: only the newest request, and only while the view
// is visible; a menu copies or saves diagrams. GUI thread; owned by its parent. Failure: an error
// of the maker is shown as text instead of the diagrams; where nothing can be drawn the view is
// empty, and the signal reports it.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>

#include "core/chart/diagram.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"
#include "ui/window/figures/diagram_files.h"
#include "ui/window/tasks/background_work.h"

class QTimer;

namespace asperity {

/// Returns the sheet as it can be read at this size: diagrams that would be too low below each
/// other stand side by side, with symbols in the legend and the subtitle in place of both headings;
/// the last ones are left out where that is too narrow.
DiagramSheet readableSheet(DiagramSheet sheet, const DiagramOptions& options);

class DiagramView : public QWidget {
  Q_OBJECT

 public:
  /// Draws a picture of this size. It is called on the worker's thread and may throw.
  using Composer = std::function<DrawList(const DiagramOptions& options)>;

  explicit DiagramView(QWidget* parent = nullptr);

  /// Sets the diagram to show from now on; of many fast requests some are skipped.
  void show(const DiagramMaker& maker, DiagramExport saved = {});
  /// Sets a picture to show from now on, which the view cannot save.
  void showPicture(Composer composer);
  /// Shows a text instead of a picture, which is also the name for screen readers.
  void showText(const QString& text);
  /// Shows nothing until the next picture is made.
  void clear();
  /// Sets the text that is shown in the middle while there is no diagram yet; empty: none.
  void setPlaceholder(const QString& text);
  QString placeholder() const { return placeholder_; }
  /// Sets the minimum time between two pictures, ms.
  void setPause(int pause);
  /// Sets the minimum size of texts in a low view, relative to their usual size.
  void setMinTextSize(float part);

  /// Returns where the diagrams are in the picture that is shown, in logical pixels of the view.
  const std::vector<ChartGeometry>& frames() const { return frames_; }
  /// Returns what saves and copies the diagrams; it is empty where they cannot be saved.
  DiagramFiles& files() { return *files_; }

  /// Returns whether the newest request is on the screen.
  bool isPainted() const { return !image_.isNull() && !pictures_.isBusy() && !isDue_; }
  const QImage& image() const { return image_; }

  QSize minimumSizeHint() const override { return {320, 170}; }

 signals:
  void failed(const asperity::LiveText& reason);
  /// Emitted when the view appears or disappears: only a visible diagram needs data.
  void visibilityChanged(bool isVisible);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

  /// Returns the theme that belongs to the palette of the view.
  const Theme& theme() const;

 private:
  /// A picture, and where the diagrams are in it, in pixels.
  struct Picture {
    DrawList list;
    std::vector<ChartGeometry> frames{};
  };

  void requestSoon();
  void request();
  void take(const QImage& image, const std::vector<ChartGeometry>& frames);
  bool hasFrame() const;

  QString placeholder_;
  DiagramFiles* files_;
  std::function<Picture(const DiagramOptions&)> compose_;
  float minTextSize_ = 1;  // views are low, which would make their texts small
  QImage image_;
  std::vector<ChartGeometry> frames_;
  QTimer* pause_;
  bool isDue_ = false;
  BackgroundWork pictures_{RequestPolicy::ReplaceWaiting};  // last: its thread ends first
};

}  // namespace asperity
