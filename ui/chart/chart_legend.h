// The lines above an interactive chart: the meaning of each mark, and the progress of the work. A
// click on a pinned curve's entry unpins it. There are as many rows as needed, up to a limit. GUI
// thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/chart/curve_diagram.h"
#include "core/chart/explanations.h"
#include "ui/chart/chart_style.h"

namespace asperity {

class ChartLegend : public QWidget {
  Q_OBJECT

 public:
  explicit ChartLegend(QWidget* parent = nullptr);

  /// Shows the entries of the sheet. `english`: the same sheet with English texts, by which
  /// explanations are found. `available`: pixels; names are shortened before the legend becomes
  /// higher than this.
  void show(const DiagramSheet& sheet, const DiagramSheet& english, const ChartStyle& style,
            double available);

  /// Returns the rectangle of a pinned curve's entry; empty where it is not shown.
  QRectF entryRect(int id) const;
  /// Returns the lines of a pinned curve's entry.
  QStringList entryLines(int id) const;

 signals:
  void unpinRequested(int id);
  /// Emitted with the anchor of the guide for the entry under the pointer; empty: there is none.
  void pointedAt(const QString& guideAnchor);
  void entered();  // emitted when the pointer comes from the plot, which gets no leave event

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
    QStringList lines{};   // of the text; the last one is shortened where it does not fit
    DiagramSeries series;  // without its points
    bool hasSample = true, hasBars = false, isMarker = false;
    QRectF box{};
    std::optional<HoverExplanation> explanation{};

    bool isPinned() const { return series.id > kPresentCurve; }
  };

  void arrange();
  int fit();
  int place(int rows, std::optional<double> widestName);
  std::vector<Entry> makeEntries() const;
  double rowHeight() const;    // pixels
  double sampleWidth() const;  // width of a sample with its gap, pixels
  double statusWidth() const;
  QString tipAt(QPointF position) const;
  const Entry* pinAt(QPointF position) const;
  const Entry* entryAt(QPointF position) const;
  void paintStatus(QPainter& painter) const;
  void paintEntry(QPainter& painter, const Entry& entry) const;
  void paintSample(QPainter& painter, const Entry& entry, QPointF centre) const;

  DiagramSheet sheet_, english_;
  ChartStyle style_;
  double available_ = 0;  // pixels for the legend, if shorter names are enough
  std::vector<Entry> entries_;
  int under_ = 0;  // pinned curve under the pointer; 0: none
};

}  // namespace asperity
