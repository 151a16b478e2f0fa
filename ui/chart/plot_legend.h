// The lines above a plot: what each mark means, and how far the plot is. A pinned curve's entry
// lets it go when it is clicked. As many rows as are needed, up to a few. GUI thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/chart/plot.h"
#include "ui/chart/plot_view.h"

namespace asperity {

class PlotLegend : public QWidget {
  Q_OBJECT

 public:
  explicit PlotLegend(QWidget* parent = nullptr);

  void show(const Plot& plot, const PlotColours& colours);

  /// Where the entry of a pinned curve is; empty where it is not shown.
  QRectF placeOf(int id) const;
  /// Its text as it is broken into lines.
  QStringList linesOf(int id) const;

 signals:
  void unpinWanted(int id);
  void entered();  // the pointer came from the plot, which does not see it leave

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  struct Entry {
    QString text;
    QStringList lines{};  // of it; the last one shortened where there is no room
    int series = -1;      // of the plot; -1: the marker or what has no room
    bool isMarker = false;
    QRectF box;
  };

  void arrange();
  double scale() const;
  double samples() const;  // width of a sample with its gap, pixels
  double noteWidth() const;
  QString tipAt(QPointF place) const;
  std::optional<int> pinAt(QPointF place) const;
  void paintNote(QPainter& painter) const;
  void paintEntry(QPainter& painter, const Entry& entry) const;
  void paintSample(QPainter& painter, const PlotSeries& series, QPointF centre) const;

  Plot plot_;
  PlotColours colours_;
  std::vector<Entry> entries_;
  int under_ = 0;  // pinned curve under the pointer; 0: none
};

}  // namespace asperity
