// Measured friction in the window: a table that is dropped stands beside the curve, with the ratio
// of measured to computed friction below it.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>

#include "core/chart/curve_diagram.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

class MeasuredFrictionTest : public MainWindowTest {
 protected:
  QString write(const QString& name, const QByteArray& text) {
    const QString path = folder_.filePath(name);
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return path;
  }

  QTemporaryDir folder_;
};

TEST_F(MeasuredFrictionTest, ATableIsToldFromOthers) {
  EXPECT_EQ(kindOfFile(write("a.csv", "velocity (mm/s);mu\n1;0,2\n10;0,3\n").toStdString()),
            FileKind::Friction);
  EXPECT_EQ(kindOfFile(write("cells.csv", "v;mu\n1 mm/s;0,2(1)\n10 mm/s;0,3(1)\n").toStdString()),
            FileKind::Friction);
  EXPECT_EQ(kindOfFile(write("b.csv", "x (mm),z (um)\n0,1\n1,2\n2,1\n").toStdString()),
            FileKind::Surface);
}

TEST_F(MeasuredFrictionTest, ADroppedTableStandsBesideTheCurve) {
  const QString file =
      write("mine.csv", "velocity,mu,mu_error\n0.001,0.0005,0.0001\n0.1,0.002,0.0002\n");
  window_.imports().openDropped(file);
  const auto& scene = [&]() -> const Scene& { return window_.document().scene(); };
  ASSERT_TRUE(waitFor([&] { return scene().comparison.data.size() == 1; }));
  EXPECT_EQ(window_.document().history().count(), 1);
  const FrictionChartModel& chart = window_.session().friction();
  ASSERT_TRUE(waitFor([&] { return chart.sheet().diagrams.size() == 2; }));
  const DiagramSheet sheet = chart.sheet();
  const auto measured =
      std::ranges::find(sheet.diagrams[0].series, kMeasuredCurves, &DiagramSeries::id);
  ASSERT_NE(measured, sheet.diagrams[0].series.end());
  EXPECT_EQ(measured->points.size(), 2U);
  EXPECT_EQ(measured->points[1].y, 0.002);
  EXPECT_TRUE(chart.describe(kMeasuredCurves, 1).contains("mine"));
}

}  // namespace
}  // namespace asperity
