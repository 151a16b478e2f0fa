// The lists at the axes of the friction chart, instead of their titles: the parameter of the
// horizontal axis and the quantity of the vertical axis. They offer the same choices as the menu of
// the curve, whose commands they call. Owned by the commands; the chart owns the lists. GUI thread.
#pragma once

#include <QObject>
#include <QString>

namespace asperity {

class AxisBox;
class ChartView;
class CurveCommands;
class Session;

class AxisChoosers : public QObject {
  Q_OBJECT

 public:
  AxisChoosers(Session& session, ChartView& view, CurveCommands& commands);

 private:
  void fillKeys();
  void fillQuantities();
  void update();
  void explain();
  void showTexts();
  void showTitles(const QString& x, const QString& y);

  Session& session_;
  CurveCommands& commands_;
  AxisBox *x_, *y_;
};

}  // namespace asperity
