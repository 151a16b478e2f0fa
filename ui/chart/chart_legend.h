// The lines above an interactive chart: what each mark means, and how far the work is. A pinned
// curve's entry lets it go when it is clicked. As many rows as are needed, up to a few. GUI thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/chart/curve_diagram.h"
#include "ui/chart/chart_panel.h"

namespace asperity {

class ChartLegend : public QWidget {
  Q_OBJECT

 public:
  explicit ChartLegend(QWidget* parent = nullptr);

  void show(const DiagramSheet& sheet, const ChartLook& look);

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
    QStringList lines{};   // of it; the last one shortened where there is no room
    DiagramSeries series;  // without its points
    bool hasSample = true, hasBars = false, isMarker = false;
    QRectF box{};

    bool isPinned() const { return series.id > kPresentCurve; }
  };

  void arrange();
  std::vector<Entry> wanted() const;
  double samples() const;  // width of a sample with its gap, pixels
  double statusWidth() const;
  QString tipAt(QPointF place) const;
  const Entry* pinAt(QPointF place) const;
  void paintStatus(QPainter& painter) const;
  void paintEntry(QPainter& painter, const Entry& entry) const;
  void paintSample(QPainter& painter, const Entry& entry, QPointF centre) const;

  DiagramSheet sheet_;
  ChartLook look_;
  std::vector<Entry> entries_;
  int under_ = 0;  // pinned curve under the pointer; 0: none
};

}  // namespace asperity
