// The page of the paper's figures as a person uses it: with the real figures of few lines, and with
// figures that never end or that fail.
#include "ui/window/gallery_page.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/friction/study.h"
#include "core/scene/scene_file.h"
#include "tests/core/small_scene.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/claim_text.h"
#include "ui/window/claims_table.h"
#include "ui/window/figure_list.h"
#include "ui/window/figure_picture.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "ui/window/session.h"

namespace asperity {
namespace {

constexpr int kPatience = 120000;  // ms, far more than anything here takes

template <class Condition>
bool waitFor(Condition condition) {
  return QTest::qWaitFor(condition, kPatience);
}

Scene smallScene() {
  Scene scene = sceneOfSize(256, 9, 3);
  scene.title = "small";
  return scene;
}

/// One diagram with one curve, and one claim.
Figure quickFigure(FigureName name, const FigureOptions& options) {
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
Figure endlessFigure(FigureName, const FigureOptions& options) {
  options.progress(0.25);
  std::mutex mutex;
  std::condition_variable_any changed;
  std::unique_lock lock(mutex);
  changed.wait(lock, options.stop, [] { return false; });
  throw StudyStopped{};
}

std::size_t coloursOf(QWidget& widget) {
  const QImage image = widget.grab().toImage();
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y));
  return colours.size();
}

/// The page alone.
class PageTest : public testing::Test {
 protected:
  GalleryPage& show(FigureMaker maker) {
    page_ = std::make_unique<GalleryPage>(std::move(maker));
    page_->resize(1000, 640);
    page_->show();
    return *page_;
  }

  template <class Control>
  Control& control(const char* name) {
    return *page_->findChild<Control*>(name);
  }
  void click(const char* name) { QTest::mouseClick(&control<QPushButton>(name), Qt::LeftButton); }
  const FigureStatus& status(FigureName name) { return page_->gallery().status(name); }
  bool isComputing(FigureName name) {
    return status(name).work == FigureStage::Computing && status(name).part > 0;
  }
  bool waitUntilMade(FigureName name) {
    return waitFor([&] { return status(name).work == FigureStage::None && status(name).made; });
  }
  ClaimsTable& claims() { return *page_->findChild<ClaimsTable*>(); }

  std::unique_ptr<GalleryPage> page_;
};

TEST_F(PageTest, AFigureIsComputedShownAndKept) {
  GalleryPage& page = show(makeFigure);
  control<QSpinBox>("realizations").setValue(2);
  std::vector<double> parts;
  QObject::connect(&page.gallery(), &FigureGallery::changed, [&](FigureName name) {
    EXPECT_EQ(name, FigureName::Exponents);
    if (status(name).work == FigureStage::Computing) parts.push_back(status(name).part);
  });
  page.choose(FigureName::Exponents, true);
  EXPECT_TRUE(control<QProgressBar>("figureProgress").isVisible());
  EXPECT_FALSE(control<QPushButton>("openAsScene").isEnabled());
  ASSERT_TRUE(waitUntilMade(FigureName::Exponents));

  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GE(std::set<double>(parts.begin(), parts.end()).size(), 5U);
  EXPECT_EQ(status(FigureName::Exponents).made->realizations, 2);
  EXPECT_FALSE(control<QProgressBar>("figureProgress").isVisible());
  EXPECT_TRUE(control<QPushButton>("openAsScene").isEnabled());
  EXPECT_EQ(claims().rowCount(),
            static_cast<int>(status(FigureName::Exponents).made->figure.claims.size()));
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_GT(coloursOf(page.picture()), 20U);

  const auto made = status(FigureName::Exponents).made;
  page.choose(FigureName::Hurst, false);
  EXPECT_EQ(claims().rowCount(), 0);
  EXPECT_FALSE(control<QPushButton>("savePicture").isEnabled());
  page.choose(FigureName::Exponents, true);  // there already
  EXPECT_EQ(status(FigureName::Exponents).work, FigureStage::None);
  EXPECT_EQ(status(FigureName::Exponents).made, made);
}

TEST_F(PageTest, TheContactIsDrawnAsOne) {
  GalleryPage& page = show(makeFigure);
  page.choose(FigureName::Contact, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Contact));
  ASSERT_TRUE(status(FigureName::Contact).made->contact);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_GT(coloursOf(page.picture()), 100U);
}

TEST_F(PageTest, ThePictureFollowsSizeAndTheme) {
  GalleryPage& page = show(quickFigure);
  page.choose(FigureName::Forces, true);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  const auto corner = [&] { return page.picture().grab().toImage().pixelColor(1, 1).lightness(); };
  EXPECT_GT(corner(), 200);
  page.setTheme(darkTheme());
  EXPECT_FALSE(page.picture().isPainted());
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_LT(corner(), 80);
  page.resize(1300, 800);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
}

TEST_F(PageTest, CancelEndsWhatIsComputedAndWhatWaits) {
  bool isEndless = true;
  GalleryPage& page = show([&](FigureName name, const FigureOptions& options) {
    return isEndless ? endlessFigure(name, options) : quickFigure(name, options);
  });
  page.choose(FigureName::Hurst, true);
  page.choose(FigureName::Forces, true);
  EXPECT_EQ(status(FigureName::Forces).work, FigureStage::Waiting);
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Hurst); }));
  EXPECT_EQ(control<QProgressBar>("figureProgress").value(), 250);
  EXPECT_EQ(stateText(FigureName::Hurst, status(FigureName::Hurst)), "25 %");
  click("cancel");
  ASSERT_TRUE(waitFor([&] { return !page.gallery().computing(); }));
  for (const FigureName name : {FigureName::Hurst, FigureName::Forces}) {
    EXPECT_EQ(status(name).work, FigureStage::None);
    EXPECT_FALSE(status(name).made);
    EXPECT_TRUE(status(name).error.isEmpty());
  }
  EXPECT_FALSE(page.messages().isVisible());
  EXPECT_FALSE(control<QPushButton>("cancel").isVisible());

  isEndless = false;
  click("compute");
  EXPECT_TRUE(waitUntilMade(FigureName::Forces));
}

TEST_F(PageTest, AllFiguresComeOneAfterAnother) {
  std::vector<FigureName> made;
  GalleryPage& page = show([&](FigureName name, const FigureOptions& options) {
    made.push_back(name);  // by one thread at a time
    return quickFigure(name, options);
  });
  click("paper");
  click("computeAll");
  ASSERT_TRUE(waitUntilMade(FigureName::Spacing));
  std::vector<FigureName> all;
  for (const FigureEntry& entry : figureEntries()) {
    all.push_back(entry.name);
    EXPECT_EQ(status(entry.name).made->realizations, GalleryPage::kPaper);
  }
  EXPECT_EQ(made, all);
  click("computeAll");  // as many lines: nothing to do
  EXPECT_FALSE(page.gallery().computing());
  click("quick");
  click("computeAll");
  ASSERT_TRUE(waitFor(
      [&] { return status(FigureName::Spacing).made->realizations == GalleryPage::kQuick; }));
  EXPECT_EQ(made.size(), 2 * all.size());
}

TEST_F(PageTest, WhatFailsIsSaidInOneSentence) {
  GalleryPage& page = show([](FigureName name, const FigureOptions& options) {
    if (name == FigureName::Hurst) throw std::runtime_error("the force balance is not met");
    return quickFigure(name, options);
  });
  page.choose(FigureName::Hurst, true);
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_EQ(page.messages().text(), "the force balance is not met");
  EXPECT_EQ(stateText(FigureName::Hurst, status(FigureName::Hurst)), "failed");
  page.choose(FigureName::Forces, true);
  EXPECT_FALSE(page.messages().isVisible());  // it is not this figure's
  EXPECT_TRUE(waitUntilMade(FigureName::Forces));
}

TEST_F(PageTest, ClaimsUnfoldAndStayWhileTheFigureIsComputedAgain) {
  bool isEndless = false;
  GalleryPage& page = show([&](FigureName name, const FigureOptions& options) {
    return isEndless ? endlessFigure(name, options) : quickFigure(name, options);
  });
  page.choose(FigureName::Forces, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Forces));
  const auto sentence = [&] { return claims().item(0, 1)->text(); };
  EXPECT_EQ(sentence(), "It grows");
  EXPECT_TRUE(claims().item(0, 0)->toolTip().contains("It does."));
  const int folded = claims().rowHeight(0);
  QTest::mouseClick(claims().viewport(), Qt::LeftButton, {},
                    claims().visualItemRect(claims().item(0, 1)).center());
  EXPECT_TRUE(sentence().contains("above zero"));
  EXPECT_TRUE(sentence().contains("It does."));
  EXPECT_GT(claims().rowHeight(0), folded);

  isEndless = true;
  click("compute");
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Forces); }));
  EXPECT_TRUE(sentence().contains("It does."));
}

TEST_F(PageTest, FiguresAreSaved) {
  GalleryPage& page = show(quickFigure);
  page.choose(FigureName::Plateau, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Plateau));
  const QTemporaryDir folder;
  QSignalSpy saved(&page, &GalleryPage::saved);
  const auto bytesOf = [&](const char* name, void (GalleryPage::*save)(const QString&)) {
    const qsizetype before = saved.count();
    (page.*save)(folder.filePath(name));
    EXPECT_TRUE(waitFor([&] { return saved.count() > before; })) << name;
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    return file.readAll();
  };
  EXPECT_TRUE(bytesOf("a.png", &GalleryPage::savePicture).startsWith("\x89PNG"));
  EXPECT_TRUE(bytesOf("a.svg", &GalleryPage::savePicture).contains("<svg"));
  EXPECT_TRUE(bytesOf("a.pdf", &GalleryPage::savePicture).startsWith("%PDF"));
  // The scene in front, as in every table in a file.
  const QByteArray table = bytesOf("a.csv", &GalleryPage::saveData);
  EXPECT_TRUE(table.startsWith("# asperity: {")) << table.toStdString();
  EXPECT_TRUE(table.endsWith("}\nx,y\n1,1\n")) << table.toStdString();
  EXPECT_TRUE(bytesOf("a.json", &GalleryPage::saveData).contains("it_grows"));

  page.savePicture(folder.filePath("no/such/folder.png"));
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_TRUE(page.messages().text().contains("folder.png"));
  page.messages().hide();
  page.saveData(folder.filePath("a.txt"));
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_TRUE(page.messages().text().contains(".csv"));
  EXPECT_FALSE(QFile::exists(folder.filePath("a.txt")));
}

TEST_F(PageTest, GoesAwayInTheMiddleOfAComputation) {
  show(endlessFigure).choose(FigureName::Hurst, true);
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Hurst); }));
  page_.reset();  // the test ends only if this does
}

TEST_F(PageTest, ControlsHaveNames) {
  show(quickFigure);
  for (QWidget* widget : page_->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible()) continue;
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
      EXPECT_FALSE(button->text().isEmpty());
    } else if (widget->parentWidget() == page_.get() || qobject_cast<QAbstractItemView*>(widget) ||
               qobject_cast<QSpinBox*>(widget)) {
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << qPrintable(widget->objectName());
    }
  }
}

/// The page in the window.
class FiguresInTheWindowTest : public testing::Test {
 protected:
  FiguresInTheWindowTest() : window_(std::make_unique<MainWindow>(smallScene())) {
    window_->show();
    window_->activateWindow();
  }

  QAction& action(const QString& name) { return *window_->findChild<QAction*>(name); }
  GalleryPage& page() { return window_->gallery(); }

  std::unique_ptr<MainWindow> window_;
};

TEST_F(FiguresInTheWindowTest, TheMenuHasThemAllWithKeysOfTheirOwn) {
  for (const FigureEntry& entry : figureEntries()) {
    auto* action = window_->findChild<QAction*>("figure:" + fromUtf8(entry.word));
    ASSERT_TRUE(action) << entry.word;
    EXPECT_TRUE(action->text().contains(fromUtf8(entry.headline)));
  }
  ASSERT_TRUE(window_->findChild<QAction*>("figures"));
  std::set<QString> keys;
  for (const QAction* action : window_->findChildren<QAction*>()) {
    const QString key = action->shortcut().toString();
    EXPECT_TRUE(key.isEmpty() || keys.insert(key).second) << qPrintable(key);
  }
}

TEST_F(FiguresInTheWindowTest, ThePageTakesThePlaceOfTheViewsAndGivesItBack) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  auto& dock = *window_->findChild<QDockWidget*>("parameterDock");
  QTest::keyClick(window_.get(), Qt::Key_G, Qt::ControlModifier);
  EXPECT_TRUE(page().isVisible());
  EXPECT_FALSE(dock.isVisible());
  EXPECT_FALSE(action("play").isEnabled());  // Space is for the page's buttons
  QTest::keyClick(&page(), Qt::Key_Escape);
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(dock.isVisible());
  EXPECT_TRUE(action("play").isEnabled());
  EXPECT_FALSE(action("figures").isChecked());

  dock.hide();
  action("figures").trigger();
  action("figures").trigger();
  EXPECT_FALSE(page().isVisible());
  EXPECT_FALSE(dock.isVisible());
}

TEST_F(FiguresInTheWindowTest, AFigureOpensAsASceneToPlayWith) {
  action("figure:1").trigger();
  EXPECT_TRUE(page().isVisible());
  EXPECT_EQ(page().chosen(), FigureName::Contact);
  ASSERT_TRUE(
      waitFor([&] { return page().gallery().status(FigureName::Contact).made != nullptr; }));
  const std::uint64_t before = window_->session().sceneNumber();
  QTest::mouseClick(page().findChild<QPushButton*>("openAsScene"), Qt::LeftButton);
  EXPECT_EQ(window_->session().sceneNumber(), before + 1);
  EXPECT_EQ(window_->session().scene(),
            page().gallery().status(FigureName::Contact).made->figure.scene);
  EXPECT_EQ(window_->panel().scene(), window_->session().scene());
  EXPECT_TRUE(window_->windowTitle().contains("Fig. 1"));
  EXPECT_FALSE(page().isVisible());
  ASSERT_TRUE(waitFor([&] {
    const auto frame = window_->session().frame();
    return frame && frame->sceneNumber == window_->session().sceneNumber();
  }));
}

TEST_F(FiguresInTheWindowTest, TheContactGoesOnWhileAFigureIsComputed) {
  page().findChild<QSpinBox*>("realizations")->setValue(1500);
  action("figure:6").trigger();
  const auto part = [&] { return page().gallery().status(FigureName::Plateau).part; };
  ASSERT_TRUE(waitFor([&] { return part() > 0; }));
  QSignalSpy frames(&window_->session(), &Session::frameArrived);
  EXPECT_TRUE(waitFor([&] { return frames.count() >= 5; }));
  EXPECT_EQ(page().gallery().computing(), FigureName::Plateau);
}

TEST_F(FiguresInTheWindowTest, TheWindowClosesInTheMiddleOfAComputation) {
  page().findChild<QSpinBox*>("realizations")->setValue(1500);
  action("figure:6").trigger();
  ASSERT_TRUE(waitFor([&] { return page().gallery().status(FigureName::Plateau).part > 0; }));
  EXPECT_TRUE(window_->close());
  EXPECT_FALSE(window_->isVisible());
  window_.reset();  // 1500 lines would outlast the test
}

TEST(EstimateText, HasTheDigitsThatTheUncertaintyLeaves) {
  EXPECT_EQ(estimateText({1.2345, 0.056}), QStringLiteral("1.23 ± 0.06"));
  EXPECT_EQ(estimateText({1.2345, 0.0123}), QStringLiteral("1.234 ± 0.012"));
  EXPECT_EQ(estimateText({-0.4127, 0.003}), QStringLiteral("−0.413 ± 0.003"));
  EXPECT_EQ(estimateText({123.4, 31}), QStringLiteral("123 ± 31"));
  EXPECT_EQ(estimateText({0.5, kNotApplicable}), QStringLiteral("0.5"));
  EXPECT_EQ(estimateText({2.5e-9, 1e-10}), QStringLiteral("2.5×10⁻⁹ ± 10⁻¹⁰"));
  EXPECT_EQ(estimateText({}), QStringLiteral("–"));
}

}  // namespace
}  // namespace asperity
