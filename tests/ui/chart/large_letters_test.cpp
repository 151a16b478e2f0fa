// Charts in the letters of a presentation, read back from their pixels: nothing is cut off, and
// marks grow with the letters.
#include <gtest/gtest.h>

#include <QImage>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/chart/curve_diagram.h"
#include "core/run/transient_diagram.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"

namespace asperity {
namespace {

constexpr double kScales[] = {1.0, 1.5, 2.4, 3.6};

/// All but texts and the data, which are blue, is white.
Theme theme() {
  Theme theme = printTheme();
  theme.axis = theme.grid = theme.highlight = theme.background;
  return theme;
}

/// Whether a pixel is of the first colour of the palette, or nearly.
bool isBlue(const QColor& pixel) {
  return pixel.blue() - pixel.red() > 100 && pixel.blue() > 120;
}

QFont letters(double scale) {
  QFont font = QApplication::font();
  font.setPointSizeF(scale * font.pointSizeF());
  return font;
}

/// Of the two outermost columns and rows of pixels, those that are not blank.
int cutPixels(const QImage& image) {
  int cut = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const bool isEdge =
          std::min(x, image.width() - 1 - x) < 2 || std::min(y, image.height() - 1 - y) < 2;
      cut += isEdge && image.pixelColor(x, y) != QColor(Qt::white) ? 1 : 0;
    }
  return cut;
}

/// Area in pixels, edges by their share.
double blueArea(const QImage& image) {
  double blue = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      blue += image.pixelColor(x, y).blueF() - image.pixelColor(x, y).redF();
  return blue;
}

Scene stepScene() {
  Scene scene;
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.duration = 0.012;
  return scene;
}

/// The strips of a motion as a picture, so many pixels wide and high at a scale of 1.
QImage stripsOf(const std::vector<TransientSample>& samples, double scale, int width) {
  ChartView strips;
  strips.setFont(letters(scale));
  strips.setTheme(theme());
  strips.resize(static_cast<int>(width * scale), static_cast<int>(240 * scale));
  strips.setSheet(transientSheet(stepScene(), samples));
  strips.show();
  QTest::qWait(1);  // the layout is made with the first events
  return strips.grab().toImage();
}

TEST(LargeLetters, OfStripsAreWhole) {
  std::vector<TransientSample> samples;
  for (int i = 0; i <= 100; ++i) {
    TransientSample sample;
    sample.time = 1.2e-4 * i;
    sample.mu = 1.1e-3 + 1e-4 * std::sin(i);
    sample.indentation = 308e-9 + 3e-9 * std::sin(0.1 * i);
    sample.contactLength = 75e-6 + 7e-6 * std::sin(0.3 * i);
    sample.predictedRate = 5230;
    samples.push_back(sample);
  }
  for (const double scale : kScales)
    EXPECT_EQ(cutPixels(stripsOf(samples, scale, 800)), 0) << scale;
}

/// A curve that ends in either corner of its strip is painted in every column: nothing lies over
/// it.
TEST(LargeLetters, NamesOfStripsHideNothingOfTheCurves) {
  for (const double slope : {1.0, -1.0})
    for (const double scale : {1.0, 2.4})
      for (const int width : {500, 800}) {
        std::vector<TransientSample> samples;
        for (int i = 0; i <= 100; ++i) {
          TransientSample sample;
          sample.time = 1.2e-4 * i;
          for (double* value :
               {&sample.velocity, &sample.mu, &sample.indentation, &sample.contactLength})
            *value = 1e-3 * (2 + slope * i / 100);
          samples.push_back(sample);
        }
        const QImage image = stripsOf(samples, scale, width);
        std::vector<int> curves;  // of each column that has one: how many of the four
        for (int x = 0; x < image.width(); ++x) {
          int runs = 0;
          bool was = false;
          for (int y = 0; y < image.height(); ++y) {
            const QColor pixel = image.pixelColor(x, y);
            const bool is = isBlue(pixel);
            runs += is && !was ? 1 : 0;
            was = is;
          }
          if (runs > 0) curves.push_back(runs);
        }
        ASSERT_GT(curves.size(), 0.5 * width * scale);
        const auto inner = std::ranges::subrange(curves.begin() + 3, curves.end() - 3);
        EXPECT_TRUE(std::ranges::all_of(inner, [](int runs) { return runs == 4; }))
            << slope << ' ' << scale << ' ' << width;
      }
}

TEST(LargeLetters, OfTheChartAreWholeAndItsMarksGrowWithThem) {
  DiagramSeries point;
  point.name = " ";
  point.mark = SeriesMark::Circle;
  point.stroke = SeriesStroke::None;
  point.colour = 0;
  point.id = kPresentCurve;
  point.points = {{1, 1e-4}};
  Diagram diagram;
  diagram.x = {"x", "", AxisScale::Logarithmic, 1e-4, 1e3};
  diagram.y = {"y", "", AxisScale::Logarithmic, 1e-6, 1e-2};
  diagram.series = {point};
  DiagramSheet sheet;
  sheet.diagrams = {diagram};
  double first = 0;
  for (const double scale : kScales) {
    const auto view = std::make_unique<ChartView>();
    view->setFont(letters(scale));
    view->setTheme(theme());
    view->resize(static_cast<int>(800 * scale), static_cast<int>(300 * scale));
    view->setSheet(sheet);
    view->show();
    QTest::qWait(1);  // the layout is made with the first events
    const QImage image = view->grab().toImage();
    EXPECT_EQ(cutPixels(image), 0) << scale;
    const double marks = blueArea(image) / std::pow(markScale(letters(scale)), 2);
    if (first == 0) first = marks;
    EXPECT_GT(first, 50);                          // of the point and its sample in the legend
    EXPECT_NEAR(marks / first, 1, 0.25) << scale;  // their rims do not grow
  }
}

}  // namespace
}  // namespace asperity
