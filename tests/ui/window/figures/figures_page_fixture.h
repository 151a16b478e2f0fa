// Figures that are made at once or never, and the page of the paper's figures alone. For tests on
// the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>

#include "core/base/stop.h"
#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/figures/claims_table.h"
#include "ui/window/figures/figures_page.h"

namespace asperity {

inline constexpr int kFigurePatience = 120000;  // ms, far more than anything here takes

template <class Condition>
bool waitFor(Condition condition) {
  return QTest::qWaitFor(condition, kFigurePatience);
}

/// One diagram with one curve, and one claim.
inline Figure quickFigure(FigureName name, const FigureOptions& options) {
  Figure figure;
  figure.name = name;
  figure.scene = figureScene(name, options);
  figure.sheet.title = "a figure";
  DiagramSeries series{"a curve"};
  series.stroke = SeriesStroke::Solid;
  series.points = {{1, 1}, {10, 20}, {100, 30}};
  figure.sheet.diagrams = {{"", {"x"}, {"y"}, {series}, {}, {}, {}}};
  figure.csv = "x,y\n1,1\n";
  Claim claim{"it_grows", "p. 1", "It grows", "growth"};
  claim.measured = {1.234, 0.056};
  claim.criterion = "above zero";
  claim.holds = Verdict::Yes;
  claim.note = "It does.";
  figure.claims = {claim};
  return figure;
}

/// Is a quarter done at once, and no more before it is stopped.
inline Figure endlessFigure(FigureName, const FigureOptions& options) {
  options.progress(0.25);
  std::mutex mutex;
  std::condition_variable_any changed;
  std::unique_lock lock(mutex);
  changed.wait(lock, options.stop, [] { return false; });
  throw StopRequested{};
}

inline std::size_t coloursOf(QWidget& widget) {
  const QImage image = widget.grab().toImage();
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y));
  return colours.size();
}

/// The page alone.
class PageTest : public testing::Test {
 protected:
  FiguresPage& show(FigureMaker maker) {
    page_ = std::make_unique<FiguresPage>(std::move(maker));
    page_->resize(1000, 640);
    page_->show();
    return *page_;
  }

  /// Does what the window does when it has set palette or font of the application, which Qt gives
  /// to styled widgets only with a style sheet.
  void restyle() { page_->setStyleSheet(page_->styleSheet()); }

  template <class Control>
  Control& control(const char* name) {
    return *page_->findChild<Control*>(name);
  }
  void click(const char* name) { QTest::mouseClick(&control<QPushButton>(name), Qt::LeftButton); }
  const FigureStatus& status(FigureName name) { return page_->queue().status(name); }
  bool isComputing(FigureName name) {
    return status(name).work == FigureStage::Computing && status(name).part > 0;
  }
  bool waitUntilMade(FigureName name) {
    return waitFor([&] { return status(name).work == FigureStage::None && status(name).made; });
  }
  ClaimsTable& claims() { return *page_->findChild<ClaimsTable*>(); }

  std::unique_ptr<FiguresPage> page_;
};

}  // namespace asperity
