// A point over the friction chart that a student places where the curve is expected: by clicking,
// by dragging, or with the arrow keys (with Shift finer); Enter answers with it. It can move over
// the whole chart, or only up and down at one x. Once the answer is known it stays as a mark. GUI
// thread; child of the chart. Cannot fail: until the chart is laid out nothing is drawn.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>

class QPainter;

namespace asperity {

class ChartView;

class PredictionPoint : public QWidget {
  Q_OBJECT

 public:
  explicit PredictionPoint(ChartView& chart);

  /// Lets the user place a point; x: its fixed position on the axis, or none. name: the question,
  /// for screen readers.
  void ask(std::optional<double> x, const QString& name);
  /// Shows a point that is decided: the student's answer, or the one that the program computed.
  enum class Whose { Given, Computed };
  void showDecided(double x, double y, Whose whose = Whose::Given);
  void dismiss() { hide(); }
  /// Sets the question in another language; the point stays.
  void setQuestion(const QString& name);

  /// Returns the position in the units of the axes, once the point was placed.
  std::optional<QPointF> point() const { return point_; }
  /// Returns the rectangle of the label as it was drawn last, in pixels.
  QRectF label() const { return label_; }

 signals:
  void placed();
  /// Emitted when the student presses Return to go on.
  void returnPressed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool hasAxes() const;
  QPointF valueAt(QPointF pixel) const;
  QString placeText() const;
  QRectF labelRect(QSizeF label, QPointF at, const QRectF& frame) const;
  void paintLeader(QPainter& painter, QPointF at) const;
  QPointF middle() const;
  void place(QPointF value);
  void describePosition();

  ChartView& chart_;
  std::optional<double> x_;
  std::optional<QPointF> point_;
  QString name_;
  QRectF label_;
  bool isDecided_ = false, isComputed_ = false, isDragged_ = false;
};

}  // namespace asperity
